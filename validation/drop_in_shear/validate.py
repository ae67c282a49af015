#!/usr/bin/python3
"""Deformation and tilt of a drop in shear against the theory of small deformations."""

import math
import sys
from dataclasses import dataclass
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))

from validation.in_flow import drift_of_end, greatest_rate, mean_of_end, middle_of, viscosity_for
from validation.item import Item
from validation.simulations import Simulation

CASE = Path(__file__).with_name("drop.toml")
BOX = (20 / 3, 14 / 3, 20 / 3)  # in R
WIDE = (10, 7, 10)


def taylor(capillary, ratio):
    return capillary * (19 * ratio + 16) / (16 * ratio + 16)


def tilt(capillary, ratio):
    """Degrees from the flow; of first order in Ca."""
    return 45 - math.degrees((19 * ratio + 16) * (2 * ratio + 3) / (80 * (1 + ratio)) * capillary)


def relaxation_rate(ratio):
    """Of the drop's deformation, times eta R/sigma."""
    return 40 * (1 + ratio) / ((2 * ratio + 3) * (19 * ratio + 16))


def frequency(ratio):
    """Over the rate, of a nearly spherical drop: the surface goes at (rate R/2)(1 + cos 2a/(1 + r)), the straining part
    of the shear dragging it by 1/(1 + r) of its own tangential velocity; 2 pi over the time for a turn."""
    return 0.5 * math.sqrt(1 - (1 + ratio) ** -2)


@dataclass(frozen=True)
class Drop:
    ratio: float
    capillary: float
    radius: float = 12.0
    box: tuple = BOX

    def name(self):
        return f"r{self.ratio:g}-Ca{self.capillary:g}-R{self.radius:g}{'-wide' if self.box == WIDE else ''}"

    def conditions(self):
        box = f", box {self.height()}" if self.box == WIDE or self.radius != 12 else ""
        return f"eta_in/eta_out = {self.ratio:g}, Ca = {self.capillary:g}, R = {self.radius:g}{box}"

    def viscosity(self):
        return viscosity_for(self.ratio)

    def rate(self):
        return greatest_rate(self.radius, self.viscosity())

    def sigma(self):
        return float(f"{self.viscosity() * self.rate() * self.radius / self.capillary:.4g}")

    def size(self):
        return [8 * round(length * self.radius / 8) for length in self.box]

    def height(self):
        return self.size()[2]

    def walls(self):
        """What walls add to the deformation of a drop midway between them (Shapira and Haber 1990)."""
        return 1 + 5.6996 * (self.radius / self.height()) ** 3 * (1 + 2.5 * self.ratio) / (1 + self.ratio)

    def steps(self):
        """Six times the sum of the times in which the fluid takes up the shear and the drop its shape."""
        fluid = self.height() ** 2 / (4 * math.pi**2 * self.viscosity())
        drop = self.capillary / (self.rate() * relaxation_rate(self.ratio))
        return 100 * math.ceil(6 * (fluid + drop) / 100)

    def simulation(self):
        return Simulation(self.name(), CASE, {
            "lattice.size": self.size(), "vesicle[0].centre": middle_of(self.size()),
            "vesicle[0].radius": self.radius, "fluid.kinematic_viscosity": self.viscosity(),
            "flow.shear.rate": self.rate(), "vesicle_type.drop.tension.sigma": self.sigma(),
            "vesicle_type.drop.viscosity_ratio": self.ratio, "run.steps": self.steps(),
            "output.checkpoint.every": max(500, self.steps() // 4),
        })  # fmt: skip

    def end(self):
        return max(300, self.steps() // 20)


SCAN = tuple(Drop(ratio, capillary) for ratio in (0.5, 1.0, 5.0) for capillary in (0.05, 0.1))
CASES = (*SCAN, Drop(1.0, 0.1, box=WIDE), Drop(1.0, 0.05, radius=18.0))
QUICK = (Drop(1.0, 0.05, radius=8.0, box=(6, 4, 6)),)


def main():
    item = Item(__file__, "A drop in shear")
    cases = QUICK if item.quick else CASES
    dearest_first = sorted(cases, key=lambda c: -math.prod(c.size()) * c.steps())
    finished = item.run([case.simulation() for case in dearest_first])
    results = item.results
    rows = []
    for case in cases:
        run = finished[case.name()]
        true_radius = (3 * mean_of_end(run, "volume", case.end()) / (4 * math.pi)) ** (1 / 3)
        capillary = case.viscosity() * case.rate() * true_radius / case.sigma()
        found = mean_of_end(run, "taylor_deformation", case.end())
        angle = mean_of_end(run, "inclination", case.end())
        free, confined = taylor(capillary, case.ratio), taylor(capillary, case.ratio) * case.walls()
        results.relative("D against small deformations between walls", case.conditions(), found, confined,
                         0.1 if item.quick else 0.05)  # fmt: skip
        if case.capillary <= 0.05 or item.quick:
            results.absolute("tilt, degrees", case.conditions(), angle, tilt(capillary, case.ratio),
                             4.0 if item.quick else 1.5)  # fmt: skip
        else:
            results.report("tilt, degrees", case.conditions(), angle, tilt(capillary, case.ratio))
        turns = mean_of_end(run, "tank_treading_frequency", case.end()) / case.rate()
        if case.capillary <= 0.05:
            results.relative("frequency of the surface over the rate, as of a sphere", case.conditions(), turns,
                             frequency(case.ratio), 0.1 if item.quick else 0.05)  # fmt: skip
        results.at_most("relative change of D over the end of the run", case.conditions(),
                        abs(drift_of_end(run, "taylor_deformation", case.end())) / found, 0.005)  # fmt: skip
        rows.append((case.conditions(), found, free, confined, 100 * (found / free - 1), 100 * (found / confined - 1),
                     angle, tilt(capillary, case.ratio), turns, frequency(case.ratio)))  # fmt: skip
    results.table("Deformation and tilt; D as Taylor has it and with the walls' share", (
        "drop", "D", "Taylor", "between walls", "off Taylor %", "off walls %", "tilt", "first order",
        "frequency", "of a sphere"), rows)  # fmt: skip
    item.finish()


if __name__ == "__main__":
    main()
