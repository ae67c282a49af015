// Elements with text inside; the data are never read as HTML.
export function element(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes))
    if (value !== null && value !== undefined) made.setAttribute(key, value);
  made.append(...children);
  return made;
}

export const byId = (id) => document.getElementById(id);

// rows of cells; the first cell of each is its header.
export function table(head, rows, attributes = {}) {
  const made = element("table", attributes);
  if (head) made.append(element("thead", {}, element("tr", {}, ...head.map((text) => element("th", { scope: "col" }, text)))));
  const body = element("tbody");
  for (const [first, ...rest] of rows)
    body.append(element("tr", {}, element("th", { scope: "row" }, first), ...rest.map((cell) => element("td", {}, cell))));
  made.append(body);
  return element("div", { class: "scroll", tabindex: "0", role: "group", "aria-label": attributes["aria-label"] ?? "Table" }, made);
}
