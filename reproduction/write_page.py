#!/usr/bin/python3
"""Writes docs/reproduction.md from the results kept in reproduction/results.

  write_page.py          the page alone
  write_page.py DIR      first takes over what `vesica reproduce -o DIR` has run whole
"""

import json
import shutil
import sys
from pathlib import Path

from cost import core_minutes
from registry import MODULES, module_of
from shared import ROOT, number, row_line, table_lines

KEPT = ROOT / "reproduction" / "results"
PAGE = ROOT / "docs" / "reproduction.md"
SIGNS = {"met": "as expected", "missed": "**missed**", "reported": ""}
SOURCES = {"paper": "paper", "theory": "theory", "": ""}


def take_over(folder):
    for name in MODULES:
        source = folder / "whole" / name
        if (source / "results.json").is_file():
            shutil.rmtree(KEPT / name, ignore_errors=True)
            shutil.copytree(source, KEPT / name)


def kept():
    found = {}
    for name in MODULES:
        path = KEPT / name / "results.json"
        found[name] = json.loads(path.read_text("utf-8")) if path.is_file() else None
    return found


def page(found):
    lines = [
        "# The reference paper, reproduced",
        "",
        "Spendlove et al. 2021, figure by figure and table by table. Made by `reproduction/write_page.py` from what `vesica reproduce` has",
        "left in `reproduction/results`; do not edit. Every number is a run's own. Targets are the paper's numbers, or theory where",
        "the paper has none; a missed one stands here as it is.",
        "",
        "```",
        "vesica reproduce --list                # the items",
        "vesica reproduce fig5 table4           # some of them, full size; --quick shows in minutes that they work",
        "vesica reproduce --all -o DIR          # all; what is done in DIR already is not done again, what was cut short goes on",
        "```",
        "",
        "| item | as expected | core-minutes | runs |",
        "| --- | --- | --- | --- |",
    ]
    for name, results in found.items():
        title = f"[{module_of(name).TITLE}](#{name})"
        if results is None:
            lines.append(f"| {title} | **not run whole yet** | about {core_minutes(module_of(name).plan(False)):.0f} | |")
            continue
        judged = [row for row in results["rows"] if row["verdict"] != "reported"]
        met = sum(row["verdict"] == "met" for row in judged)
        runs = ", ".join(run["name"] for run in results["runs"][:2]) + (", ..." if len(results["runs"]) > 2 else "")
        lines.append(f"| {title} | {met} of {len(judged)} | {results['seconds'] / 60:.1f} | {runs} |")
    lines += ["", *_total(found)]
    for name, results in found.items():
        lines += _section(name, results)
    return "\n".join(lines) + "\n"


def _total(found):
    """Runs that several items share count once."""
    done = {run["name"]: run["seconds"] for results in found.values() if results for run in results["runs"]}
    missing = {s.name: s for name, results in found.items() if results is None for s in module_of(name).plan(False) if s.name not in done}
    text = f"What has been run takes {sum(done.values()) / 60:.0f} core-minutes, {sum(done.values()) / 120:.0f} minutes on two cores"
    if missing:
        rest = core_minutes(missing.values())
        text += (f"; what has not, about {rest:.0f} core-minutes more ({rest / 120:.1f} hours on two cores), counted from cells and steps at "
                 "20 million cells per second and core in double precision and twice that in single")  # fmt: skip
    return [text + ". The results do not depend on the number of cores."]


def _section(name, results):
    module = module_of(name)
    lines = ["", f'<a id="{name}"></a>', "", f"## {module.TITLE}", "", f"**The paper.** {module.PAPER}", ""]
    if results is None:
        return [*lines, f"Not run whole yet: `vesica reproduce {name}`."]
    for file, caption in results["pictures"]:
        lines += [f"![{caption}](../reproduction/results/{name}/{file})", "", f"*{caption}*", ""]
    lines += ["| quantity | conditions | ours | target | tolerance | from | |", "| --- | --- | --- | --- | --- | --- | --- |"]
    for row in results["rows"]:
        target = "" if row["target"] is None else number(row["target"])
        cells = (row["law"], row["conditions"], number(row["measured"]), target, row["tolerance"], SOURCES[row["group"]], SIGNS[row["verdict"]])
        lines.append(row_line(cells))
    lines += table_lines(results["tables"])
    for note in results["notes"]:
        lines += ["", note]
    if results["choices"]:
        lines += ["", "What the paper leaves out, and what was chosen:", "", "| parameter | here | why |", "| --- | --- | --- |"]
        lines += [row_line(choice) for choice in results["choices"]]
    data = ", ".join(f"[{file}](../reproduction/results/{name}/{file})" for file in results["data"])
    return [*lines, "", f"Data: {data}. Runs: {results['seconds'] / 60:.1f} core-minutes."]


def main():
    if len(sys.argv) > 2 or sys.argv[1:] == ["--help"]:
        print(__doc__)
        return 2
    if len(sys.argv) == 2:
        take_over(Path(sys.argv[1]))
    PAGE.write_text(page(kept()), encoding="utf-8")
    print(f"{PAGE}: written")
    return 0


if __name__ == "__main__":
    sys.exit(main())
