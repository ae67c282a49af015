// Which columns of metrics.csv have a plot.
import { byId, element } from "./elements.js";
import { labelOf } from "./metrics.js";

export function createColumns(metrics, use) {
  let chosen = metrics.usualNames();
  const buttons = metrics.names.map((name) => {
    const isEmpty = metrics.empty.has(name);
    const button = element("button", { type: "button", class: "chip plain", "data-name": name, title: isEmpty ? `${name}: no numbers in this run` : name }, labelOf(name));
    button.disabled = isEmpty;
    button.addEventListener("click", () => set(chosen.includes(name) ? chosen.filter((other) => other !== name) : [...chosen, name]));
    return button;
  });
  const set = (names) => {
    chosen = metrics.names.filter((name) => names.includes(name));
    for (const button of buttons) button.setAttribute("aria-pressed", String(chosen.includes(button.dataset.name)));
    byId("columns-summary").textContent = `Columns (${chosen.length} of ${metrics.names.length - metrics.empty.size})`;
    use(chosen);
  };
  byId("columns").append(...buttons);
  byId("columns-usual").addEventListener("click", () => set(metrics.usualNames()));
  byId("columns-all").addEventListener("click", () => set(metrics.names.filter((name) => !metrics.empty.has(name))));
  byId("columns-none").addEventListener("click", () => set([]));
  set(metrics.usualNames());
}
