// A card with a plot for each chosen column; all share their cursor, and show which frame is in the view.
import uPlot from "uplot";
import { vesicleColour, vesicleVariable } from "./colours.js";
import { labelOf, unitOf } from "./metrics.js";
import { short } from "./numbers.js";

const listedVesicles = 4;
const height = 168;

// Of few lines the first are wider, so that one which lies under another still shows.
const widthOf = (place, count) => (count > 12 ? 0.9 : count > 4 ? 1.4 : 1.6 + 1.3 * (count - 1 - place));

export class Plots {
  // clock: { factor, unit } of times against steps; go(step): the reader clicked there.
  constructor(place, store, clock, go) {
    Object.assign(this, { place, store, clock, go, cards: new Map() });
    this.seen = new IntersectionObserver((entries) => {
      for (const entry of entries) if (entry.isIntersecting) this.build(this.cards.get(entry.target.dataset.column));
    }, { rootMargin: "300px" });
    this.sized = new ResizeObserver((entries) => {
      for (const entry of entries) {
        const card = this.cards.get(entry.target.parentElement?.dataset.column);
        if (card?.plot && entry.contentRect.width > 0) card.plot.setSize({ width: entry.contentRect.width, height });
      }
    });
    store.on("step", () => this.mark());
    for (const name of ["hidden", "against", "dark"]) store.on(name, () => this.rebuild());
  }

  use(metrics) {
    this.metrics = metrics;
    for (const card of this.cards.values()) if (card.plot) card.plot.setData(this.dataFor(card.name));
    this.mark();
  }

  choose(names) {
    for (const [name, card] of this.cards) if (!names.includes(name)) this.drop(name, card);
    for (const name of names) {
      const card = this.cards.get(name) ?? this.add(name);
      this.place.append(card.element);
    }
    this.mark();
  }

  visible() {
    const hidden = this.store.get("hidden");
    return this.metrics.vesicles.filter((vesicle) => !hidden.has(vesicle));
  }

  abscissa(step) {
    return this.store.get("against") === "time" ? step * this.clock.factor : step;
  }

  dataFor(name) {
    return [this.metrics.steps.map((step) => this.abscissa(step)), ...this.visible().map((vesicle) => this.metrics.series(name, vesicle))];
  }

  add(name) {
    const element = document.createElement("article");
    element.className = "card";
    element.dataset.column = name;
    const unit = unitOf(name);
    element.innerHTML = `<header><h3></h3><p class="now" aria-live="off"></p></header><div class="plot" role="img"></div>`;
    element.querySelector("h3").textContent = labelOf(name);
    element.querySelector("h3").title = name;
    if (unit) element.querySelector("h3").insertAdjacentHTML("beforeend", ` <small>${unit}</small>`);
    const card = { name, element, now: element.querySelector(".now"), holder: element.querySelector(".plot"), plot: null };
    card.holder.style.height = `${height}px`;
    this.cards.set(name, card);
    this.seen.observe(element);
    this.sized.observe(card.holder);
    return card;
  }

  drop(name, card) {
    this.seen.unobserve(card.element);
    this.sized.unobserve(card.holder);
    card.plot?.destroy();
    card.element.remove();
    this.cards.delete(name);
  }

  rebuild() {
    for (const card of this.cards.values()) {
      if (!card.plot) continue;
      card.plot.destroy();
      card.plot = null;
      this.build(card);
    }
  }

  axis(style) {
    return {
      stroke: style.getPropertyValue("--faint").trim(),
      grid: { stroke: style.getPropertyValue("--grid").trim(), width: 1 },
      ticks: { show: false },
      font: "11px system-ui, sans-serif",
    };
  }

  build(card) {
    if (!card || card.plot || !this.metrics) return;
    const style = getComputedStyle(document.documentElement);
    const vesicles = this.visible();
    const axis = this.axis(style);
    const numbers = (plot, values) => values.map((value) => short(value, 5));
    const few = this.metrics.steps.length < 60;
    card.plot = new uPlot({
      width: card.holder.clientWidth || 300,
      height,
      padding: [8, 18, 0, 0],
      legend: { show: false },
      cursor: { sync: { key: "metrics" }, drag: { x: true, y: false }, points: { size: 6 }, y: false },
      scales: { x: { time: false } },
      axes: [{ ...axis, size: 26, values: numbers, space: 60 }, { ...axis, size: this.roomFor(card.name), values: numbers, space: 28 }],
      series: [{}, ...vesicles.map((vesicle, place) => ({ stroke: vesicleColour(vesicle), width: widthOf(place, vesicles.length), points: { show: few, size: 3.5 }, spanGaps: false }))],
      hooks: { setCursor: [(plot) => this.tell(card, plot.cursor.idx)], setScale: [() => this.markOne(card)], setSize: [() => this.markOne(card)] },
    }, this.dataFor(card.name), card.holder);
    const line = document.createElement("div");
    line.className = "frame-line";
    card.plot.over.append(line);
    card.line = line;
    card.plot.over.addEventListener("click", () => {
      const value = card.plot.posToVal(card.plot.cursor.left, "x");
      this.go(this.store.get("against") === "time" ? value / this.clock.factor : value);
    });
    card.holder.setAttribute("aria-label", this.description(card.name));
    this.markOne(card);
  }

  // Wide enough for the numbers along the axis.
  roomFor(name) {
    let low = Infinity, high = -Infinity;
    for (const vesicle of this.visible())
      for (const value of this.metrics.series(name, vesicle))
        if (value !== null) [low, high] = [Math.min(low, value), Math.max(high, value)];
    if (!(low <= high)) return 50;
    const digits = high > low ? Math.ceil(Math.log10(Math.max(Math.abs(low), Math.abs(high)) / (high - low) + 1)) + 2 : 4;
    const typical = [low, high, (low + high) / 2].map((value) => short(value, Math.min(digits, 5)).length);
    return Math.min(76, 14 + 6.2 * Math.max(3, ...typical));
  }

  description(name) {
    const parts = this.visible().slice(0, listedVesicles).map((vesicle) => {
      const line = this.metrics.series(name, vesicle).filter((value) => value !== null);
      return line.length ? `vesicle ${vesicle}: from ${short(line[0])} to ${short(line[line.length - 1])}` : `vesicle ${vesicle}: no numbers`;
    });
    return `${labelOf(name)} against ${this.store.get("against")}; ${parts.join("; ")}`;
  }

  mark() {
    if (this.metrics) for (const card of this.cards.values()) this.markOne(card);
  }

  markOne(card) {
    const { plot, line } = card;
    if (!line || !plot) return this.tell(card, null);
    const left = plot.valToPos(this.abscissa(this.store.get("step")), "x");
    const isInside = left >= -0.5 && left <= plot.over.clientWidth + 0.5;
    line.style.display = isInside ? "" : "none";
    line.style.transform = `translateX(${Math.round(left)}px)`;
    this.tell(card, plot.cursor.idx ?? null);
  }

  // The numbers at the cursor, or else at the frame in the view.
  tell(card, cursor) {
    if (!this.metrics || this.metrics.steps.length === 0) return;
    const index = cursor ?? this.metrics.nearest(this.store.get("step"));
    const vesicles = this.visible();
    const values = vesicles.map((vesicle) => this.lineOf(card.name, vesicle)[index]);
    card.element.classList.toggle("pointed", cursor !== null && cursor !== undefined);
    if (vesicles.length > listedVesicles) {
      const numbers = values.filter((value) => value !== null && value !== undefined);
      card.now.textContent = numbers.length ? `${short(Math.min(...numbers))} … ${short(Math.max(...numbers))}` : "–";
      return;
    }
    card.now.replaceChildren(...vesicles.map((vesicle, i) => {
      const number = document.createElement("span");
      number.textContent = short(values[i], vesicles.length > 1 ? 4 : 5);
      if (vesicles.length > 1) number.style.setProperty("--mark", vesicleVariable(vesicle));
      number.className = vesicles.length > 1 ? "marked" : "";
      return number;
    }));
  }

  lineOf(name, vesicle) {
    const plot = this.cards.get(name)?.plot;
    const place = this.visible().indexOf(vesicle) + 1;
    return plot?.data[place] ?? this.metrics.series(name, vesicle);
  }
}
