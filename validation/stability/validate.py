#!/usr/bin/python3
"""Which oblates return from an ellipse in their plane, and where the prolate becomes dearer than the oblate."""

import json
import math
import sys
from pathlib import Path

import numpy

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))

from validation.item import Item
from validation.shapes_at_rest import bending_time, rest_case

CASE = Path(__file__).with_name("oblate.toml")
RADIUS, KAPPA, NU = 12, 0.7, 1 / 4
BENDING_TIMES = 10
REST_SHAPES = Path(__file__).parents[1] / "rest_shapes" / "results.json"
LOSES_STABILITY = 0.750  # +-.01: the oblate to m = 2
EQUAL_ENERGIES = 0.651  # of prolate and oblate


def growth_rate(run, first, last):
    """Of the ellipse in the plane, per step, from (I2 - I1)/I3: the oblate has its largest moment about its own axis,
    so the two others, equal on a body of revolution, are compared."""
    steps = run.metrics["step"]
    ellipse = (run.metrics["inertia_2"] - run.metrics["inertia_1"]) / run.metrics["inertia_3"]
    chosen = (steps >= first) & (steps <= last) & (ellipse > 0)
    return float(numpy.polyfit(steps[chosen], numpy.log(ellipse[chosen]), 1)[0]), ellipse


def main():
    item = Item(__file__, "Stability of oblates and the order of energies")
    time = bending_time(RADIUS, KAPPA, NU)
    runs = {v: rest_case(CASE, f"oblate-v{v:.2f}", "discocyte", v, RADIUS, 2 if item.quick else BENDING_TIMES,
                         kappa=KAPPA, nu=NU)
            for v in ((0.70,) if item.quick else (0.80, 0.78, 0.72, 0.70))}  # fmt: skip
    finished = item.run(runs.values())
    rates = {}
    rows = []
    for v in runs:
        run = finished[f"oblate-v{v:.2f}"]
        last = run.steps()
        rate, ellipse = growth_rate(run, min(2 * time, 0.3 * last), min(10 * time, last))
        own_v = run.last("reduced_volume")
        rates[own_v] = rate * time
        rows.append((v, own_v, rate * time, ellipse[0], ellipse[-1], run.last("bending_energy")))
        if v > LOSES_STABILITY:
            item.results.at_least("growth of an ellipse in the plane, per bending time", f"v = {v}", rate * time, 0.0)
        else:
            item.results.at_most("growth of an ellipse in the plane, per bending time", f"v = {v}", rate * time, 0.0)
    item.results.table(
        f"Oblates with a 2 % ellipse in their plane, R0 = {RADIUS}, {BENDING_TIMES} bending times",
        ("v asked for", "v", "growth per bending time", "(I2 - I1)/I3 at first", "at last", "E at last"), rows)  # fmt: skip
    if not item.quick:
        ordered = sorted(rates.items())
        volumes, values = zip(*ordered)
        crossing = float(numpy.interp(0.0, values, volumes))
        item.results.absolute("reduced volume above which the ellipse grows", "interpolated", crossing,
                              LOSES_STABILITY, 0.01)  # fmt: skip
        energies_cross(item.results)
    item.finish()


def energies_cross(results):
    """From the energies that `rest_shapes` measured at R0 = 20."""
    if not REST_SHAPES.is_file():
        results.at_most("rest_shapes has been run", str(REST_SHAPES.name), math.nan, 0)
        return
    tables = json.loads(REST_SHAPES.read_text("utf-8"))["tables"]
    measured = {row[0]: (row[1], row[2]) for row in tables[0]["rows"]}
    branch = {shape: sorted(value for name, value in measured.items()
                            if name.startswith(shape) and name.endswith("-R20") and value[0] < 0.76)
              for shape in ("discocyte", "prolate")}  # fmt: skip
    volumes = numpy.linspace(0.61, 0.70, 901)
    oblate, prolate = (numpy.interp(volumes, *zip(*branch[s])) for s in ("discocyte", "prolate"))
    difference = prolate - oblate
    crossing = float(volumes[numpy.flatnonzero(difference < 0)[0]])
    results.absolute("reduced volume at which prolate and oblate cost the same", "energies of rest_shapes", crossing,
                     EQUAL_ENERGIES, 0.01)  # fmt: skip
    results.at_most("E prolate - E oblate", "v = .70", float(numpy.interp(0.70, volumes, difference)), 0.0)
    results.at_least("E prolate - E oblate", "v = .62", float(numpy.interp(0.62, volumes, difference)), 0.0)


if __name__ == "__main__":
    main()
