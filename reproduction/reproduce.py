#!/usr/bin/python3
"""Reproduces the figures and tables of the reference paper; `vesica reproduce` calls it.

Exit status: 0 done, whatever the verdicts; 1 a run failed, or a package is missing; 2 wrong input; 3 stopped on request."""

import argparse
import difflib
import importlib.util
import os
import sys
import time
from pathlib import Path

from registry import MODULES, module_of

PACKAGES = {"numpy": "python3-numpy", "scipy": "python3-scipy", "matplotlib": "python3-matplotlib", "PIL": "python3-pil",
            "h5py": "python3-h5py", "vtkmodules": "python3-vtk9"}  # fmt: skip


def main():
    options = _parse()
    missing = [package for module, package in PACKAGES.items() if importlib.util.find_spec(module) is None]
    if missing:
        print(f"vesica: {sys.executable} lacks {', '.join(missing)}; expected Debian's packages of these names; try "
              f"apt-get install {' '.join(missing)}, or set VESICA_PYTHON to a Python that has them", file=sys.stderr)  # fmt: skip
        return 1
    if options.list:
        from cost import core_minutes

        for name in MODULES:
            minutes = core_minutes(module_of(name).plan(False))
            cost = f"about {minutes:.0f} core-minutes" if minutes >= 0.5 else "seconds"
            print(f"{name:14s}{cost:24s}{module_of(name).TITLE}")
        return 0
    names = list(MODULES) if options.all else options.items
    problem = _problem(names, options)
    if problem:
        print(problem, file=sys.stderr)
        return 2
    try:
        return _reproduce(names, options)
    except KeyboardInterrupt:
        print("\nstopped; the same command goes on from here", file=sys.stderr)
        return 3


def _reproduce(names, options):
    from item import Item
    from shared import number

    failed, core_seconds, counted, begin = [], 0.0, set(), time.monotonic()
    for name in names:
        print(f"== {name}: {module_of(name).TITLE}" + (" (quick)" if options.quick else ""), flush=True)
        item = Item(name, module_of(name), options)
        item.carry_out()
        for row in item.results.rows:
            target = "" if row.target is None else f"  {row.group or 'beside'} {number(row.target)} {row.tolerance}"
            print(f"{row.verdict:9s} {row.law}, {row.conditions}: {number(row.measured)}{target}")
        missed = sum(row.verdict == "missed" for row in item.judged())
        verdict = f"{len(item.judged()) - missed} of {len(item.judged())} as expected"
        quick = ", of the quick set-up" if options.quick else ""
        print(f"{name}: {verdict}{quick}; {item.results.seconds / 60:.1f} core-minutes; see {item.folder}", flush=True)
        failed += item.failed
        core_seconds += sum(run["seconds"] for run in item.runs if run["name"] not in counted)
        counted |= {run["name"] for run in item.runs}
    wall = time.monotonic() - begin
    print(f"all: {core_seconds / 60:.1f} core-minutes of runs, {wall / 60:.1f} minutes by the clock of this call")
    for words in failed:
        print(f"a run failed: {words}", file=sys.stderr)
    return 1 if failed else 0


def _problem(names, options):
    for name in names:
        if name not in MODULES:
            near = difflib.get_close_matches(name, MODULES, 1, 0.0)[0]
            return f"{name} is not an item; expected one of {', '.join(MODULES)}; try `vesica reproduce {near}`"
    if not names:
        return "no item is named; expected ITEM..., --all or --list; try `vesica reproduce --list`"
    if options.all and options.items:
        return f"both --all and {options.items[0]} are given; expected one of them; try `vesica reproduce --all`"
    try:
        options.output.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        return f"{options.output}: {error.strerror}; expected a directory to write to; try another with -o DIR"
    return None


def _parse():
    parser = argparse.ArgumentParser(prog="vesica reproduce", description=__doc__)
    parser.add_argument("items", nargs="*", metavar="ITEM")
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--output", type=Path, default=Path("reproduction-out"))
    parser.add_argument("--threads", type=int, default=int(os.environ.get("OMP_NUM_THREADS") or os.cpu_count() or 1))
    parser.add_argument("--program", required=True, help="the program that runs the cases")
    return parser.parse_args()


if __name__ == "__main__":
    sys.exit(main())
