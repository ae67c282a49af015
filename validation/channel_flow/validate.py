#!/usr/bin/python3
"""Viscosity of a sheared channel with one drop or vesicle in it, from the walls and from the stress of what is inside."""

import math
import sys
from dataclasses import dataclass
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))

from validation.in_flow import drift_of_end, greatest_rate, mean_of_end, middle_of, steps_of_strain, viscosity_for
from validation.item import Item
from validation.simulations import Simulation

HERE = Path(__file__).parent
BOX = (4, 10 / 3, 4)  # in R0
WIDE = (8, 20 / 3, 8)


@dataclass(frozen=True)
class Case:
    name: str
    drop: bool
    ratio: float
    box: tuple
    strain: float
    radius: float = 12.0

    def viscosity(self):
        return viscosity_for(self.ratio)

    def rate(self):
        return greatest_rate(self.radius, self.viscosity())

    def size(self):
        return [8 * round(length * self.radius / 8) for length in self.box]

    def fraction(self):
        return 4 / 3 * math.pi * self.radius**3 / math.prod(self.size())

    def simulation(self):
        nu, rate = self.viscosity(), self.rate()
        settings = {
            "lattice.size": self.size(), "vesicle[0].centre": middle_of(self.size()),
            "vesicle[0].radius": self.radius, "fluid.kinematic_viscosity": nu, "flow.shear.rate": rate,
            "vesicle_type.inside.viscosity_ratio": self.ratio, "run.steps": steps_of_strain(self.strain, rate, 250),
        }  # fmt: skip
        if self.drop:  # Ca = 0.05: nearly a sphere
            settings["vesicle_type.inside.tension.sigma"] = float(f"{nu * rate * self.radius / 0.05:.3g}")
        return Simulation(self.name, HERE / ("drop.toml" if self.drop else "shear.toml"), settings)


CASES = (
    Case("drop-0.5", True, 0.5, BOX, 2.5),
    Case("drop-1", True, 1.0, BOX, 2.5),
    Case("drop-5", True, 5.0, BOX, 3.5),
    Case("vesicle-1", False, 1.0, BOX, 4.0),
    Case("vesicle-2.7", False, 2.7, BOX, 4.0),
    Case("drop-1-wide", True, 1.0, WIDE, 2.5),
)
QUICK = (Case("drop-1", True, 1.0, BOX, 1.5, radius=8.0),)


def main():
    item = Item(__file__, "Effective viscosity, measured twice")
    cases = QUICK if item.quick else CASES
    finished = item.run([case.simulation() for case in sorted(cases, key=lambda c: c.box != WIDE)])
    results = item.results
    rows = []
    for case in cases:
        run = finished[case.name]
        end = steps_of_strain(0.4, case.rate(), 250)
        walls = mean_of_end(run, "wall_stress", end) / (case.viscosity() * case.rate())
        inside = mean_of_end(run, "effective_viscosity", end)
        what = f"{'drop' if case.drop else 'vesicle, v = .9'}, eta_in/eta_out = {case.ratio:g}"
        conditions = what + (", wide box" if case.box == WIDE else "")
        results.relative("viscosity from the walls against 1 + stress of what is inside", conditions, walls, inside, 0.005)
        change = drift_of_end(run, "wall_stress", end) / (case.viscosity() * case.rate())
        results.at_most("its change over the last 0.4 of strain", conditions, abs(change), 0.005)
        dilute = (5 * case.ratio + 2) / (2 * case.ratio + 2) if case.drop else math.nan
        intrinsic = [(value - 1) / case.fraction() for value in (walls, inside)]
        rows.append((conditions, case.fraction(), walls, inside, *intrinsic, dilute if case.drop else ""))
    results.table("Viscosity over that of the fluid outside, and intrinsic viscosity (less one, over the volume fraction c)",
                  ("inside", "c", "walls", "1 + stress inside", "intrinsic, walls", "intrinsic, inside", "Taylor, c -> 0"),
                  rows)  # fmt: skip
    item.finish()


if __name__ == "__main__":
    main()
