"""Numbers beside their targets, kept as `results.json` in the folder of the validation."""

import json
import math
from dataclasses import asdict, dataclass, field


@dataclass
class Row:
    """One number. `target` None: reported for the record, nothing is asked of it."""

    law: str
    conditions: str
    measured: float
    target: float | None = None
    tolerance: str = ""
    verdict: str = "reported"  # met | missed | reported
    group: str = ""


@dataclass
class Results:
    title: str
    command: str
    rows: list = field(default_factory=list)
    tables: list = field(default_factory=list)  # {"title", "columns", "rows"}
    notes: list = field(default_factory=list)
    seconds: float = 0.0  # of one core
    versions: list = field(default_factory=list)  # of the program that made the runs, as far as their stamps say

    def used(self, versions):
        self.versions = sorted({*self.versions, *versions})

    def relative(self, law, conditions, measured, target, within):
        """Asks |measured/target - 1| <= within."""
        met = math.isfinite(measured) and abs(measured / target - 1.0) <= within
        return self._judge(law, conditions, measured, target, f"±{100 * within:g} %", met)

    def absolute(self, law, conditions, measured, target, within):
        """Asks |measured - target| <= within."""
        met = math.isfinite(measured) and abs(measured - target) <= within
        return self._judge(law, conditions, measured, target, f"±{within:g}", met)

    def at_most(self, law, conditions, measured, bound):
        return self._judge(law, conditions, measured, bound, "at most", math.isfinite(measured) and measured <= bound)

    def at_least(self, law, conditions, measured, bound):
        return self._judge(law, conditions, measured, bound, "at least", math.isfinite(measured) and measured >= bound)

    def report(self, law, conditions, measured, beside=None):
        """For the record; `beside` is a number to look at together with it."""
        self.rows.append(Row(law, conditions, float(measured), beside))

    def table(self, title, columns, rows):
        self.tables.append({"title": title, "columns": list(columns), "rows": [list(row) for row in rows]})

    def note(self, text):
        self.notes.append(text)

    def missed(self):
        return [row for row in self.rows if row.verdict == "missed"]

    def _judge(self, law, conditions, measured, target, tolerance, met):
        verdict = "met" if met else "missed"
        self.rows.append(Row(law, conditions, float(measured), float(target), tolerance, verdict))
        return met

    def write(self, path):
        content = asdict(self)
        for row in content["rows"]:
            row["measured"] = _rounded(row["measured"])
        for table in content["tables"]:
            table["rows"] = [[_rounded(cell) if isinstance(cell, float) else cell for cell in row] for row in table["rows"]]
        temporary = path.with_suffix(".tmp")
        temporary.write_text(json.dumps(content, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
        temporary.replace(path)

    def print(self):
        for row in self.rows:
            target = "" if row.target is None else f"  target {number(row.target)} {row.tolerance}"
            print(f"{row.verdict:9s} {row.law}, {row.conditions}: {number(row.measured)}{target}")


def number(value):
    """As a reader wants it: five significant digits."""
    if value is None or (isinstance(value, float) and math.isnan(value)):
        return "nan"
    return f"{value:.5g}"


def _rounded(value):
    """Seven digits are kept, so that a repeated campaign does not change the file by noise. NaN becomes None."""
    return None if not math.isfinite(value) else float(f"{value:.7g}")
