"""One folder of `validation/`: its options, its runs, its results."""

import argparse
import os
import sys
from pathlib import Path

from validation.results import Results
from validation.simulations import run_all

ROOT = Path(__file__).resolve().parents[2]


class Item:
    """Made at the start of a `validate.py`; `finish()` ends it.

    --quick is the subset that the tests run; its results are printed but not kept in the folder.
    """

    def __init__(self, script, title):
        self.folder = Path(script).resolve().parent
        self.name = self.folder.name
        options = _parse(title)
        self.quick = options.quick
        self.processes = options.processes
        self.build = Path(options.build).resolve()
        self.program = str(self.build / "bin" / "vesica")
        self.scratch = Path(options.output).resolve() / (self.name + ("-quick" if self.quick else ""))
        self.results = Results(title, f"validation/{self.name}/validate.py")
        if not Path(self.program).is_file():
            raise SystemExit(f"{self.program}: not there; run `make build`, or name another with --build")

    def run(self, simulations):
        """Name -> Finished. A run that failed counts as a miss."""
        finished = run_all(simulations, self.scratch, self.program, self.processes)
        for name, run in finished.items():
            self.results.seconds += run.seconds
            self.results.used(run.versions)
            if run.failure is not None:
                why = run.failure.removeprefix("vesica: ").partition("; likely cause")[0]  # what follows names directories
                self.results.at_most(f"run {name} ends as it should", why, float("nan"), 0.0)
        return finished

    def finish(self):
        """Prints, keeps, and exits: 0 if every target is met, 1 if not."""
        self.results.print()
        missed = self.results.missed()
        if not self.quick:
            self.results.seconds = round(self.results.seconds)
            self.results.write(self.folder / "results.json")
        judged = [row for row in self.results.rows if row.verdict != "reported"]
        print(f"{self.name}: {len(judged) - len(missed)} of {len(judged)} targets met")
        sys.exit(1 if missed else 0)


def _parse(title):
    parser = argparse.ArgumentParser(description=title)
    parser.add_argument("--quick", action="store_true", help="the subset that the tests run, in minutes at most")
    parser.add_argument("--build", default=str(ROOT / "build" / "release"), help="the build whose programs are used")
    parser.add_argument("--output", default=str(ROOT / "out" / "validation"), help="where runs are kept")
    parser.add_argument("--processes", type=int, default=os.cpu_count() or 1, help="runs at a time, a thread each")
    return parser.parse_args()
