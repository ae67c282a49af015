"""docs/validation.md, from the folders' READMEs and the results their runs left."""

import json
from dataclasses import dataclass
from pathlib import Path

from validation.results import number

ROOT = Path(__file__).resolve().parents[2]
ORDER = ("numerics", "drops", "rest_shapes", "stability", "quasi_spherical", "spontaneous_curvature", "paper_formulas",
         "accuracy", "channel_flow", "viscosity_contrast", "drop_in_shear", "sliding_box", "settling_drop", "tank_treading", "tumbling", "migration",
         "sheared_discocyte", "pair_passing", "film_drainage", "pair_in_shear", "sedimenting_pair", "dilute_emulsion")  # fmt: skip
SIGNS = {"met": "met", "missed": "**missed**", "reported": ""}


@dataclass(frozen=True)
class ItemOnPage:
    name: str
    title: str
    text: str
    results: dict | None


def items():
    found = []
    for name in ORDER:
        folder = ROOT / "validation" / name
        title, _, text = (folder / "README.md").read_text("utf-8").partition("\n")
        path = folder / "results.json"
        results = json.loads(path.read_text("utf-8")) if path.is_file() else None
        found.append(ItemOnPage(name, title.removeprefix("# ").strip(), text.strip(), results))
    return found


def write_page():
    path = ROOT / "docs" / "validation.md"
    path.write_text(page_of(items()), encoding="utf-8")
    return path


def page_of(found):
    lines = [
        "# Validation",
        "",
        "Made by `tools/validate` from the results in `validation/`; do not edit. Every number is a run's own; targets",
        "are theory, exact solutions or published numbers, and their sources stand in the folders' READMEs.",
        "",
        "| validation | targets met | core-minutes | command |",
        "| --- | --- | --- | --- |",
    ]
    for item in found:
        if item.results is None:
            lines.append(f"| [{item.title}](#{item.name}) | not run yet | | `validation/{item.name}/validate.py` |")
            continue
        judged = [row for row in item.results["rows"] if row["verdict"] != "reported"]
        met = sum(row["verdict"] == "met" for row in judged)
        lines.append(
            f"| [{item.title}](#{item.name}) | {met} of {len(judged)} | {item.results['seconds'] / 60:.0f} "
            f"| `validation/{item.name}/validate.py` |"
        )
    minutes = sum(item.results["seconds"] for item in found if item.results is not None) / 60
    lines += ["", f"All of what has been run takes {minutes:.0f} core-minutes, {minutes / 120:.1f} hours on two cores."]
    for item in found:
        lines += ["", f'<a id="{item.name}"></a>', "", f"## {item.title}", "", _one_level_down(item.text)]
        if item.results is not None:
            lines += _rows(item.results["rows"]) + table_lines(item.results["tables"])
            for note in item.results["notes"]:
                lines += ["", note]
    return "\n".join(lines) + "\n"


def _rows(rows):
    if not rows:
        return []
    lines = ["", "| law | conditions | measured | target | tolerance | |", "| --- | --- | --- | --- | --- | --- |"]
    for row in rows:
        target = "" if row["target"] is None else number(row["target"])
        cells = (row["law"], row["conditions"], number(row["measured"]), target, row["tolerance"], SIGNS[row["verdict"]])
        lines.append(row_line(cells))
    return lines


def table_lines(tables):
    lines = []
    for table in tables:
        lines += ["", f"**{table['title']}**", "", row_line(table["columns"])]
        lines.append("|" + " --- |" * len(table["columns"]))
        for row in table["rows"]:
            cells = [cell if isinstance(cell, str) else number(cell) for cell in row]
            cells += [""] * (len(table["columns"]) - len(cells))
            lines.append(row_line(cells))
    return lines


def row_line(cells):
    """A bar within a cell, as in int |f|, would end it."""
    return "| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |"


def _one_level_down(text):
    """A README's own headings below that of its section."""
    return "\n".join("#" + line if line.startswith("#") else line for line in text.split("\n"))
