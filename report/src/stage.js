// The view with its controls: which frame, coloured by what, between which numbers, which vesicles.
import { drawAxes } from "./axes.js";
import { colourRange, ramp, vesicleVariable } from "./colours.js";
import { byId, element } from "./elements.js";
import { createFrames } from "./frames.js";
import { grouped, quantityText, short } from "./numbers.js";
import { View } from "./scene.js";

export class Stage {
  constructor(store, manifest, timeText) {
    Object.assign(this, { store, manifest, timeText, shown: null, request: 0, spreads: new Map() });
    this.cell = manifest.scales?.cell_m ?? 1;
    this.frames = createFrames(manifest, this.cell);
    this.fillColours();
    this.message("…");
  }

  // Apart from the constructor, since a browser may take its time to find its graphics.
  open() {
    this.message("");
    if (!this.openView()) return;
    const { store } = this;
    store.on("frame", () => this.showFrame());
    for (const name of ["colour", "range", "hidden"]) store.on(name, () => this.paint());
    store.on("dark", (isDark) => {
      this.view.dark(isDark);
      this.paint();
    });
    this.showFrame();
  }

  message(text) {
    const place = byId("view-message");
    place.textContent = text;
    place.hidden = !text;
  }

  openView() {
    if (this.manifest.frames.length === 0 && !this.manifest.live) {
      this.message("This run left no surfaces. Give it [output] surfaces = { every = N } to see them here.");
      byId("stage").classList.add("bare");
      return false;
    }
    const box = this.manifest.box?.size ?? [64, 64, 64];
    try {
      this.view = new View(byId("canvas"), box, {
        reducedMotion: matchMedia("(prefers-reduced-motion: reduce)").matches,
        moved: (camera) => drawAxes(byId("axes"), camera),
      });
    } catch {
      this.message("This browser offers no WebGL, which the view of the surfaces needs. Plots and tables are complete.");
      return false;
    }
    if (this.manifest.frames.length === 0) this.message("The run has written no surface yet.");
    if (this.manifest.box?.ends) this.view.addWalls(this.manifest.box.ends);
    if (!this.manifest.box) this.view.frame.visible = false;
    this.view.dark(this.store.get("dark"));
    this.connectTools();
    return true;
  }

  connectTools() {
    for (const button of document.querySelectorAll("[data-view]"))
      button.addEventListener("click", () => this.view.look(button.dataset.view));
    byId("canvas").addEventListener("pointerdown", () => (this.view.untouched = false));
    byId("canvas").addEventListener("wheel", () => (this.view.untouched = false), { passive: true });
    byId("toggle-box").addEventListener("click", () => this.toggleBox());
  }

  toggleBox() {
    const visible = !this.view.frame.visible;
    this.view.frame.visible = visible;
    byId("toggle-box").setAttribute("aria-pressed", String(visible));
    this.view.request();
  }

  fillColours() {
    const choice = byId("colour");
    this.manifest.quantities.forEach(({ name, si_unit: unit }) =>
      choice.append(element("option", { value: name }, quantityText(name, unit, this.manifest.scales !== null).label)));
    choice.append(element("option", { value: "vesicle" }, "Vesicle"));
    choice.value = this.store.get("colour");
    choice.addEventListener("change", () => this.store.set("colour", choice.value));
    byId("range").addEventListener("change", () => this.store.set("range", byId("range").value));
  }

  nextColour() {
    const choice = byId("colour");
    choice.selectedIndex = (choice.selectedIndex + 1) % choice.options.length;
    this.store.set("colour", choice.value);
  }

  async showFrame() {
    const outline = this.manifest.frames[this.store.get("frame")];
    if (!outline || !this.view) return;
    const request = ++this.request;
    this.store.set("loading", true);
    try {
      const frame = await this.frames.load(outline.step);
      if (request !== this.request) return; // the reader is elsewhere already
      this.shown = frame;
      this.spreads.set(frame.step, frame.spreads);
      this.message("");
      this.paint();
    } catch (error) {
      if (request === this.request) this.message(`This frame cannot be shown: ${error.message}`);
    } finally {
      if (request === this.request) this.store.set("loading", false);
    }
    const following = this.manifest.frames[this.store.get("frame") + 1];
    if (this.store.get("playing") && following) this.frames.load(following.step).catch(() => {});
  }

  // The range of colours of a quantity, over this frame or all.
  rangeOf(index) {
    // While a run goes on only the frames that were looked at are known.
    const all = this.manifest.frames.map(({ step, spreads }) => (spreads.length ? spreads : this.spreads.get(step))).filter(Boolean);
    const spreads = this.store.get("range") === "frame" ? [this.shown.spreads] : all;
    const low = Math.min(...spreads.map((spread) => spread[index][0]));
    const high = Math.max(...spreads.map((spread) => spread[index][1]));
    return colourRange(low, high);
  }

  paint() {
    if (!this.shown || !this.view) return;
    const name = this.store.get("colour");
    const index = this.manifest.quantities.findIndex((quantity) => quantity.name === name);
    const hidden = this.store.get("hidden");
    let places = () => null;
    if (index >= 0) {
      const range = this.rangeOf(index);
      this.view.colours(range);
      this.legend(this.manifest.quantities[index], range);
      places = (surface) => surface.placesBetween(index, range.low, range.high);
    }
    byId("legend").hidden = index < 0;
    this.view.show(this.shown.surfaces, places, (vesicle) => !hidden.has(vesicle));
    this.tell();
  }

  legend(quantity, range) {
    const { label, unit, factor } = quantityText(quantity.name, quantity.si_unit, this.manifest.scales !== null);
    byId("legend-name").textContent = unit ? `${label}, ${unit}` : label;
    const context = byId("legend-bar").getContext("2d");
    context.putImageData(new ImageData(new Uint8ClampedArray(ramp(range.scale, range.begin, range.end)), 256, 1), 0, 0);
    byId("legend-low").textContent = short(range.low * factor, 3);
    const middle = range.scale === "diverging" ? 0 : 0.5 * (range.low + range.high);
    const place = (middle - range.low) / (range.high - range.low);
    byId("legend-middle").textContent = place > 0.27 && place < 0.73 ? short(middle * factor, 3) : "";
    byId("legend-middle").style.left = `${100 * place}%`;
    byId("legend-high").textContent = short(range.high * factor, 3);
  }

  tell() {
    const triangles = this.shown.surfaces.reduce((sum, surface) => sum + surface.triangles.length / 3, 0);
    const size = this.manifest.box?.size;
    byId("readout").textContent = `step ${grouped(this.shown.step)}${this.timeText(this.shown)}`;
    byId("readout").title = `${grouped(triangles)} triangles${size ? `; box of ${size.join(" × ")} cells` : ""}`;
    byId("view").setAttribute("aria-label", `${this.shown.surfaces.length} surface${this.shown.surfaces.length === 1 ? "" : "s"} at step ${this.shown.step}, coloured by ${byId("colour").selectedOptions[0]?.textContent}`);
  }
}

// A button for each vesicle; hidden ones are hidden from the view and the plots alike.
export function showVesicles(store, vesicles) {
  const place = byId("vesicles");
  place.hidden = vesicles.length < 2;
  const buttons = vesicles.map((vesicle) => {
    const button = element("button", { type: "button", class: "chip", "aria-pressed": String(!store.get("hidden").has(vesicle)) }, String(vesicle));
    button.style.setProperty("--mark", vesicleVariable(vesicle));
    button.setAttribute("aria-label", `Vesicle ${vesicle}`);
    button.addEventListener("click", () => {
      const hidden = new Set(store.get("hidden"));
      if (!hidden.delete(vesicle)) hidden.add(vesicle);
      button.setAttribute("aria-pressed", String(!hidden.has(vesicle)));
      store.set("hidden", hidden);
    });
    return button;
  });
  const all = element("button", { type: "button", class: "chip plain" }, "All");
  all.addEventListener("click", () => {
    const hidden = new Set(store.get("hidden").size > 0 ? [] : vesicles);
    for (const button of buttons) button.setAttribute("aria-pressed", String(hidden.size === 0));
    store.set("hidden", hidden);
  });
  place.replaceChildren(element("legend", {}, "Vesicles"), ...buttons, ...(vesicles.length > 3 ? [all] : []));
}
