// What the run says of itself: verdicts, warnings, where the time went.
import { element, table } from "./elements.js";
import { duration, grouped, short } from "./numbers.js";

const readable = (name) => name.replaceAll("_", " ");

export function showVerdicts(place, manifest) {
  const summary = manifest.summary;
  place.replaceChildren();
  if (!summary) {
    place.append(element("p", { class: "empty" }, manifest.state === "running"
      ? "The run still goes on; its verdicts come at the end."
      : "The run left no summary.json: it was interrupted before its end, or the file is damaged."));
    return;
  }
  const list = element("ul", { class: "verdicts" });
  for (const verdict of summary.verdicts ?? []) {
    const word = verdict.passed ? "passed" : "failed";
    list.append(element("li", { class: word }, element("span", { class: "mark", role: "img", "aria-label": word }, verdict.passed ? "✓" : "✕"),
      element("strong", {}, readable(verdict.name)), element("span", { class: "text" }, verdict.text)));
  }
  place.append(list);
  if (summary.reason) place.append(element("p", { class: "reason" }, summary.reason));
  if (summary.warnings?.length)
    place.append(element("details", { class: "warnings", open: "" }, element("summary", {}, `Warnings (${summary.warnings.length})`),
      element("ul", {}, ...summary.warnings.map((text) => element("li", {}, text)))));
}

function bars(seconds, total) {
  const list = element("ul", { class: "bars" });
  for (const [name, value] of seconds) {
    const bar = element("span", { class: "bar" });
    bar.style.setProperty("--share", total > 0 ? value / total : 0);
    list.append(element("li", {}, element("span", { class: "name" }, readable(name)), bar, element("span", { class: "value" }, duration(value))));
  }
  return list;
}

export function showTimings(place, manifest) {
  const summary = manifest.summary;
  place.replaceChildren();
  if (!summary) {
    place.append(element("p", { class: "empty" }, "Timings are written when the run ends."));
    return;
  }
  const { total, ...parts } = summary.seconds ?? {};
  const bySize = (values) => Object.entries(values).filter(([, value]) => value > 0).sort((a, b) => b[1] - a[1]);
  const machine = summary.machine ?? {};
  place.append(element("dl", { class: "facts" }, ...[
    ["Total", duration(total)],
    ["Speed", `${short(summary.mlups, 3)} MLUPS`],
    ["Steps", `${grouped(summary.first_step ?? 0)} – ${grouped(summary.last_step ?? 0)}`],
    ["Machine", `${machine.ranks > 1 ? `${machine.ranks} ranks × ` : ""}${machine.threads} thread${machine.threads === 1 ? "" : "s"}, ${machine.instruction_set ?? machine.device}`],
    ["Memory", `${short((summary.lattice?.bytes_allocated ?? NaN) / 1e6, 3)} MB`],
    ["Precision", summary.lattice?.precision ?? "–"],
  ].map(([name, value]) => element("div", {}, element("dt", {}, name), element("dd", {}, value)))));
  place.append(bars(bySize(parts), total));
  const profile = Object.fromEntries(Object.entries(summary.profile ?? {}).filter(([name]) => name.startsWith("seconds_")).map(([name, value]) => [name.slice(8), value]));
  const profiled = bySize(profile);
  if (profiled.length) {
    const sum = profiled.reduce((all, [, value]) => all + value, 0);
    place.append(element("details", {}, element("summary", {}, "Of the steps"), bars(profiled, sum)));
  }
  if (summary.parallel) {
    const rows = summary.parallel.ranks.map((rank, i) => [String(i), rank.begin.join(", "), rank.size.join(" × "), duration(rank.working_seconds), duration(rank.waiting_seconds)]);
    place.append(element("details", {}, element("summary", {}, `Ranks (${rows.length}): imbalance ${short(summary.parallel.imbalance, 3)}`),
      table(["rank", "from", "cells", "working", "waiting"], rows, { "aria-label": "Ranks" })));
  }
  if (summary.versions)
    place.append(element("p", { class: "versions" }, Object.entries(summary.versions).map(([name, value]) => `${readable(name)} ${value}`).join(" · ")));
}
