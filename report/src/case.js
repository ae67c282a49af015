// The case: the plan that `vesica check` prints as tables, groups of the summary, and the files themselves.
import { element, table } from "./elements.js";
import { short } from "./numbers.js";

// "  label   lattice value   SI value" under headings: [{ heading, rows, notes }].
export function planSections(text) {
  const sections = [];
  for (const line of text.split("\n")) {
    if (line.trim() === "") continue;
    if (!line.startsWith(" ")) {
      sections.push({ heading: line.trim(), rows: [], notes: [] });
      continue;
    }
    if (sections.length === 0) continue;
    const cells = line.trim().split(/\s{2,}/);
    const section = sections[sections.length - 1];
    if (cells.length === 1) section.notes.push(cells[0]);
    else section.rows.push([cells[0], cells[1], cells.slice(2).join(" ")]);
  }
  return sections.filter(({ rows, notes }) => rows.length + notes.length > 0);
}

export function showGroups(place, manifest) {
  place.replaceChildren();
  const grid = element("div", { class: "sections" });
  const siMatters = manifest.scales !== null;
  for (const { heading, rows, notes } of planSections(manifest.plan)) {
    const box = element("div", { class: "section" }, element("h3", {}, heading));
    if (rows.length) {
      const wide = siMatters && rows.some((row) => row[2]);
      box.append(table(wide ? ["", "lattice", "SI"] : null, rows.map((row) => (wide ? row : row.slice(0, 2))), { class: "values", "aria-label": heading }));
    }
    if (notes.length) box.append(element("ul", { class: "notes" }, ...notes.map((note) => element("li", {}, note))));
    grid.append(box);
  }
  const groups = Object.entries(manifest.summary?.dimensionless ?? {}).filter(([, value]) => value !== null);
  if (groups.length)
    grid.append(element("div", { class: "section" }, element("h3", {}, "Groups of the run (summary.json)"),
      table(null, groups.map(([name, value]) => [name.replaceAll("_", " "), short(value, 6)]), { class: "values", "aria-label": "Groups of the run" })));
  if (!grid.children.length) grid.append(element("p", { class: "empty" }, "The case could not be read again, and no summary was left."));
  place.append(grid);
}

// TOML with its comments, tables, keys and strings marked.
function markedToml(text) {
  const code = element("code");
  for (const line of text.split("\n")) {
    const parts = /^((?:[^#"']|"[^"]*"|'[^']*')*)(#.*)?$/.exec(line);
    const body = parts ? parts[1] : line;
    if (/^\s*\[/.test(body)) code.append(element("span", { class: "t-table" }, body));
    else {
      const key = /^(\s*[\w.-]+)(\s*=.*)$/.exec(body);
      if (key) code.append(element("span", { class: "t-key" }, key[1]), key[2]);
      else code.append(body);
    }
    if (parts?.[2]) code.append(element("span", { class: "t-comment" }, parts[2]));
    code.append("\n");
  }
  return code;
}

export function showFiles(place, manifest) {
  place.replaceChildren();
  const files = [["case.toml", "the case, as it was given", manifest.case, true], ["resolved.toml", "every default filled in", manifest.resolved, true], ["log.txt", "what the run said", manifest.log, false]];
  for (const [name, meaning, text, isToml] of files) {
    if (!text) continue;
    const copy = element("button", { type: "button", class: "copy" }, "Copy");
    copy.addEventListener("click", async () => {
      try {
        await navigator.clipboard.writeText(text);
        copy.textContent = "Copied";
      } catch {
        copy.textContent = "Not allowed";
      }
      setTimeout(() => (copy.textContent = "Copy"), 1500);
    });
    const details = element("details", name === "case.toml" ? { open: "" } : {}, element("summary", {}, element("code", {}, name), ` ${meaning}`),
      element("div", { class: "file" }, copy, element("pre", { tabindex: "0" }, isToml ? markedToml(text) : element("code", {}, text))));
    place.append(details);
  }
  if (!place.children.length) place.append(element("p", { class: "empty" }, "The run left neither its case nor a log."));
}
