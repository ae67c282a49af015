#!/usr/bin/python3
"""A drop sheared without walls: against the theory that knows none, and the same wherever it lies in the box."""

import math
import sys
from dataclasses import dataclass
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))

from validation.in_flow import drift_of_end, greatest_rate, mean_of_end, middle_of
from validation.item import Item
from validation.simulations import Simulation

CASE = Path(__file__).resolve().parents[1] / "drop_in_shear" / "drop.toml"
VISCOSITY = 0.5
CAPILLARY = 0.05
TAYLOR = 35 / 32  # D/Ca at equal viscosities
TILT = 45 - math.degrees(35 * 5 / 160 * CAPILLARY)  # of first order in Ca
EINSTEIN = 1.75  # what a volume fraction adds to the viscosity, of drops of equal viscosity (Taylor 1932)


@dataclass(frozen=True)
class Drop:
    name: str
    height: float  # of its centre, of the box
    radius: float = 12.0
    box: tuple = (20 / 3, 14 / 3, 20 / 3)  # in R
    walls: bool = False

    def rate(self):
        return greatest_rate(self.radius, VISCOSITY)

    def sigma(self):
        return float(f"{VISCOSITY * self.rate() * self.radius / CAPILLARY:.4g}")

    def size(self):
        return [8 * round(length * self.radius / 8) for length in self.box]

    def fraction(self):
        return 4 / 3 * math.pi * self.radius**3 / math.prod(self.size())

    def confinement(self):
        """What walls add to the deformation of a drop midway between them (Shapira and Haber 1990)."""
        return 1 + 5.6996 * (self.radius / self.size()[2]) ** 3 * 1.75 if self.walls else 1.0

    def steps(self):
        """Six times the sum of the times in which the fluid takes up the shear and the drop its shape."""
        fluid = self.size()[2] ** 2 / (4 * math.pi**2 * VISCOSITY)
        drop = CAPILLARY / self.rate() * 35 * 5 / 80
        return 100 * math.ceil(6 * (fluid + drop) / 100)

    def simulation(self):
        centre = middle_of(self.size())
        centre[2] = self.height * self.size()[2]
        return Simulation(self.name, CASE, {
            "lattice.size": self.size(), "vesicle[0].centre": centre, "vesicle[0].radius": self.radius,
            "fluid.kinematic_viscosity": VISCOSITY, "flow.shear.rate": self.rate(),
            "flow.shear.with": "walls" if self.walls else "lees-edwards",
            "vesicle_type.drop.tension.sigma": self.sigma(), "run.steps": self.steps(),
            "output.checkpoint.every": max(500, self.steps() // 4),
        })  # fmt: skip

    def end(self):
        return max(300, self.steps() // 20)


CASES = (Drop("middle", 0.5), Drop("quarter", 0.25), Drop("across", 1.0), Drop("walls", 0.5, walls=True))
SMALL = (6, 4, 6)
QUICK = (Drop("middle", 0.5, 8.0, SMALL), Drop("across", 1.0, 8.0, SMALL))


def main():
    item = Item(__file__, "A drop in shear without walls")
    cases = QUICK if item.quick else CASES
    finished = item.run([case.simulation() for case in cases])
    results = item.results
    found = {}
    for case in cases:
        run = finished[case.name]
        radius = (3 * mean_of_end(run, "volume", case.end()) / (4 * math.pi)) ** (1 / 3)
        capillary = VISCOSITY * case.rate() * radius / case.sigma()
        found[case.name] = (
            mean_of_end(run, "taylor_deformation", case.end()) / capillary,
            mean_of_end(run, "inclination", case.end()),
            mean_of_end(run, "effective_viscosity", case.end()),
        )
        results.at_most("relative change of D over the end of the run", case.name,
                        abs(drift_of_end(run, "taylor_deformation", case.end()))
                        / mean_of_end(run, "taylor_deformation", case.end()), 0.005)  # fmt: skip
    tolerance = 0.1 if item.quick else 0.05
    for case in cases:
        results.relative("D over Ca" + (", with the walls' share" if case.walls else ""), case.name, found[case.name][0],
                         TAYLOR * case.confinement(), tolerance)  # fmt: skip
        results.absolute("tilt, degrees", case.name, found[case.name][1], TILT, 4.0 if item.quick else 1.5)
    middle = found["middle"]
    for case in cases:
        if case.name == "middle" or case.walls:
            continue
        deformation, angle, viscosity = found[case.name]
        results.relative("D against the drop in the middle", case.name, deformation, middle[0], 0.03 if item.quick else 0.01)
        results.absolute("tilt against the drop in the middle", case.name, angle, middle[1], 1.0 if item.quick else 0.3)
        results.relative("effective viscosity less one against the drop in the middle", case.name, viscosity - 1,
                         middle[2] - 1, 0.03 if item.quick else 0.01)  # fmt: skip
    first = cases[0]
    results.report("effective viscosity less one over that of a dilute emulsion, 7/4 of the volume fraction", first.name,
                   (middle[2] - 1) / (EINSTEIN * first.fraction()))  # fmt: skip
    results.table("Where the drop lies", ("drop", "D/Ca", "tilt", "effective viscosity"),
                  [(case.name, *found[case.name]) for case in cases])  # fmt: skip
    item.finish()


if __name__ == "__main__":
    main()
