// Light or dark: the system's choice until the reader makes one.
import { byId } from "./elements.js";

export function createTheme(store) {
  const system = matchMedia("(prefers-color-scheme: dark)");
  let chosen = null;
  const apply = () => {
    const isDark = chosen ?? system.matches;
    document.documentElement.dataset.theme = isDark ? "dark" : "light";
    byId("theme").setAttribute("aria-label", isDark ? "Light" : "Dark");
    byId("theme").title = isDark ? "Light (d)" : "Dark (d)";
    store.set("dark", isDark);
  };
  const toggle = () => {
    chosen = !store.get("dark");
    apply();
  };
  system.addEventListener("change", apply);
  byId("theme").addEventListener("click", toggle);
  apply();
  return { toggle };
}
