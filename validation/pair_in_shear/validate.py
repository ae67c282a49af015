#!/usr/bin/python3
"""Two vesicles that shear drives past each other, and the offset across the gradient that is left."""

import math
import sys
from dataclasses import dataclass
from pathlib import Path

import numpy

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))

from validation.in_flow import greatest_rate, steps_of_strain
from validation.item import Item
from validation.pair import both, half_turn_asymmetry, judge_integrity, least_gap, separation
from validation.simulations import Simulation
from vesica.plotting import keller_skalak

CASE = Path(__file__).with_name("pair.toml")
VISCOSITY, V, CAPILLARY = 0.5, 0.95, 1.0
WIDTH = 2 / 0.67  # of the interface, 2/beta
SETTLED = 500  # steps in which the layers, drawn from a shape, become the lattice's own


@dataclass(frozen=True)
class Pair:
    offset: float  # across the gradient at the start, in R0
    strain: float
    size: tuple = (104, 40, 64)
    radius: float = 10.0
    distance: float = 4.0  # along the flow at the start, in R0

    def name(self):
        return f"offset{self.offset:g}-R{self.radius:g}"

    def conditions(self):
        return f"offset {self.offset:g} R0, R0 = {self.radius:g}"

    def rate(self):
        return greatest_rate(self.radius, VISCOSITY)

    def modulus(self):
        return float(f"{VISCOSITY * self.rate() * self.radius**3 / CAPILLARY:.3g}")

    def every(self):
        return steps_of_strain(0.05, self.rate(), 50)

    def steps(self):
        return steps_of_strain(self.strain, self.rate(), self.every())

    def simulation(self):
        angle = keller_skalak.inclination(keller_skalak.prolate_axes(V), 1.0)
        settings = {
            "lattice.size": list(self.size), "fluid.kinematic_viscosity": VISCOSITY, "flow.shear.rate": self.rate(),
            "vesicle_type.vesicle.bending.modulus": self.modulus(), "run.steps": self.steps(),
            "output.metrics.every": self.every(), "output.surfaces.every": self.steps() // 10,
            "output.checkpoint.every": self.steps() // 4,
        }  # fmt: skip
        for k, side in enumerate((-1, 1)):  # the first behind and above, where the fluid goes forwards
            settings[f"vesicle[{k}].centre"] = [self.size[0] / 2 + side * self.distance * self.radius / 2, self.size[1] / 2,
                                                self.size[2] / 2 - side * self.offset * self.radius / 2]  # fmt: skip
            settings[f"vesicle[{k}].radius"] = self.radius
            settings[f"vesicle[{k}].reduced_volume"] = V
            settings[f"vesicle[{k}].axis"] = [round(math.cos(angle), 4), 0.0, round(math.sin(angle), 4)]
        return Simulation(self.name(), CASE, settings)


CASES = (Pair(0.75, 13.0), Pair(1.0, 10.0))
QUICK = (Pair(1.0, 0.5, (64, 32, 48), 8.5, 3.2),)


def judge(results, run, case, quick):
    """Returns the rows of what happened on the way."""
    conditions = case.conditions()
    judge_integrity(results, run, conditions, SETTLED, 0.01)
    results.at_most("distance from the half turn about the middle, cells", conditions, half_turn_asymmetry(run, case.size), 1e-6)
    strain = both(run)[0]["step"] * case.rate()
    along, across = -separation(run, "x") / case.radius, -separation(run, "z") / case.radius  # the first from the second
    if quick:
        return []
    results.at_least("first's place ahead of the second along the flow at the end, R0, at the start -4", conditions,
                     along[-1], 0.0)  # fmt: skip
    # As far apart again as at the start, or, should they not get there, the last there is.
    reached = numpy.flatnonzero(along >= case.distance)
    end = int(reached[0]) if len(reached) else len(along) - 1
    results.at_least("offset across the gradient after they have passed less that before, R0", conditions,
                     across[end] - across[0] if along[-1] > 0 else math.nan, 0.0)  # fmt: skip
    results.report("the offset before, R0", conditions, across[0])
    results.report("the offset after, R0", conditions, across[end])
    results.report("their distance along the flow where it was taken, R0, beside that before", conditions, along[end],
                   case.distance)  # fmt: skip
    results.report("greatest offset on the way, R0", conditions, across.max())
    results.report("least gap over the interface's width 2/beta", conditions, least_gap(run) / WIDTH)
    first = both(run)[0]
    return [(conditions, strain[k], along[k], across[k], first["gap"][k] / case.radius, first["inclination"][k],
             first["taylor_deformation"][k]) for k in numpy.linspace(0, len(strain) - 1, 14).round().astype(int)]  # fmt: skip


def main():
    keller_skalak.self_test()
    item = Item(__file__, "Two vesicles in shear")
    cases = QUICK if item.quick else CASES
    finished = item.run([case.simulation() for case in cases])
    rows = []
    for case in cases:
        run = finished[case.name()]
        if run.failure is None:
            rows += judge(item.results, run, case, item.quick)
    if rows:
        item.results.table("On the way: place of the first from the second, in R0; the gap, to the other or to a wall", (
            "pair", "strain", "along the flow", "across", "gap", "inclination", "D"), rows)  # fmt: skip
    item.finish()


if __name__ == "__main__":
    main()
