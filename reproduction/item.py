"""One item at work: its runs, its numbers beside the paper's, its data and pictures."""

import csv
import json
import math
import subprocess
from dataclasses import asdict

from shared import Results, run_all, style

PAPER, THEORY = "paper", "theory"


class Item:
    """Made with its name, title and folders; the module's judge() fills it; finish() writes it."""

    def __init__(self, name, module, options):
        self.name = name
        self.module = module
        self.quick = options.quick
        self.program = options.program
        self.threads = options.threads
        self.folder = options.output / ("quick" if self.quick else "whole") / name
        self.runs_folder = options.output / ("quick-runs" if self.quick else "runs")
        self.results = Results(module.TITLE, f"vesica reproduce {name}")
        self.choices, self.pictures, self.data, self.runs = [], [], [], []
        self.failed = []
        self.folder.mkdir(parents=True, exist_ok=True)

    def carry_out(self):
        planned = self.module.plan(self.quick)
        finished = self._run(planned) if planned else {}
        self.module.judge(self, finished)
        self._finish()

    def _run(self, planned):
        """A run that several items share is done by the first that asks."""
        processes = min(self.threads, len(planned))
        finished = run_all(planned, self.runs_folder, self.program, processes, max(1, self.threads // processes))
        for simulation in planned:
            run = finished[simulation.name]
            self.results.used(run.versions)
            why = None if run.failure is None else reason(run)
            self.runs.append({"name": simulation.name, "seconds": round(run.seconds), "failure": why})
            if why is not None:
                self.failed.append(f"{simulation.name}: {why}")
        return finished

    def against(self, source):
        """results.relative, .absolute, .at_most, .at_least, .report with where the target is from."""
        return _Against(self.results, source)

    def choose(self, parameter, value, why):
        """A parameter that the paper leaves out."""
        self.choices.append([parameter, value, why])

    def explain(self, text):
        """Why ours and the paper's differ, and what shows it."""
        self.results.note(text)

    def table(self, title, columns, rows):
        self.results.table(title, columns, rows)

    def csv(self, name, columns, rows):
        """Data of a picture or a table; numbers as they are."""
        with open(self.folder / name, "w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(columns)
            for row in rows:
                writer.writerow([f"{cell:.7g}" if isinstance(cell, float) else cell for cell in row])
        self.data.append(name)

    def picture(self, name, figure, caption):
        style.save(figure, self.folder / name, small=True)
        self.pictures.append([name, caption])

    def paper_formulas(self):
        """The program's own tables of the paper's collision and frames."""
        done = subprocess.run([self.program, "paper-formulas"], capture_output=True, text=True, check=True)
        return json.loads(done.stdout)

    def _finish(self):
        self.results.seconds = sum(run["seconds"] for run in self.runs)
        self.csv("verdicts.csv", ("quantity", "conditions", "ours", "target", "tolerance", "verdict", "target from"),
                 [(r.law, r.conditions, r.measured, "" if r.target is None else float(r.target), r.tolerance, r.verdict, r.group)
                  for r in self.results.rows])  # fmt: skip
        content = asdict(self.results) | {
            "quick": self.quick, "choices": self.choices, "pictures": self.pictures, "data": self.data, "runs": self.runs,
        }  # fmt: skip
        temporary = self.folder / "results.tmp"
        temporary.write_text(json.dumps(_plain(content), indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
        temporary.replace(self.folder / "results.json")

    def judged(self):
        return [row for row in self.results.rows if row.verdict != "reported"]


def reason(run):
    """Why a run ended early, without what names directories."""
    return run.failure.removeprefix("vesica: ").partition("; likely cause")[0]


class _Against:
    def __init__(self, results, source):
        self._results = results
        self._source = source

    def __getattr__(self, method):
        def judge(*arguments):
            met = getattr(self._results, method)(*arguments)
            self._results.rows[-1].group = self._source
            return met

        return judge


def _plain(value):
    """Numbers of seven digits and no NaN, as JSON has them."""
    if isinstance(value, dict):
        return {key: _plain(entry) for key, entry in value.items()}
    if isinstance(value, (list, tuple)):
        return [_plain(entry) for entry in value]
    if isinstance(value, float) or type(value).__module__ == "numpy":
        value = float(value)
        return float(f"{value:.7g}") if math.isfinite(value) else None
    return value
