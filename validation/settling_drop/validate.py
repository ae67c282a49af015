#!/usr/bin/python3
"""Speed of a drop, and of a spherical vesicle, that a force drives through a periodic box."""

import math
import sys
from dataclasses import dataclass
from pathlib import Path

import numpy

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))

from validation.in_flow import viscosity_for
from validation.item import Item
from validation.simulations import Simulation

HERE = Path(__file__).parent
REYNOLDS = 0.03


def first_order(ratio, fraction):
    """The speed over F/(6 pi eta R): Hadamard and Rybczynski's, less the images' leading share (Hasimoto 1959)."""
    return (3 + 3 * ratio) / (2 + 3 * ratio) - 1.7601 * fraction ** (1 / 3)


def with_next_order(ratio, fraction):
    """With the share of the drop's size, by Faxen's law of a drop, on either side of the images: R^2/3 3 r/(2 + 3 r)
    times the Laplacian of the images' velocity, which the counter-force makes (2/3) F/(eta V)."""
    return first_order(ratio, fraction) + 3 * ratio / (2 + 3 * ratio) * fraction


@dataclass(frozen=True)
class Body:
    name: str
    ratio: float
    box: int
    radius: float = 12.0
    drop: bool = True

    def viscosity(self):
        return viscosity_for(self.ratio)

    def force(self):
        """Per volume inside, for a speed of about REYNOLDS nu/R."""
        speed = REYNOLDS * self.viscosity() / self.radius
        return float(f"{speed * 4.5 * self.viscosity() / self.radius**2 / first_order(self.ratio, self.fraction()):.3g}")

    def fraction(self, radius=None):
        return 4 / 3 * math.pi * (radius or self.radius) ** 3 / self.box**3

    def steps(self):
        """Nine times that in which the box's slowest flow decays."""
        return 100 * math.ceil(9 * self.box**2 / (4 * math.pi**2 * self.viscosity()) / 100)

    def conditions(self):
        return f"{'drop' if self.drop else 'vesicle'}, eta_in/eta_out = {self.ratio:g}, R = {self.radius:g}, box {self.box}"

    def simulation(self):
        return Simulation(self.name, HERE / ("drop.toml" if self.drop else "vesicle.toml"), {
            "lattice.size": [self.box] * 3, "vesicle[0].centre": [self.box / 2] * 3, "vesicle[0].radius": self.radius,
            "fluid.kinematic_viscosity": self.viscosity(), "vesicle_type.inside.viscosity_ratio": self.ratio,
            "vesicle_type.inside.buoyancy": [0.0, 0.0, self.force()], "run.steps": self.steps(),
        })  # fmt: skip


CASES = (
    Body("r0.5", 0.5, 80),
    Body("r1", 1.0, 80),
    Body("r5", 5.0, 80),
    Body("vesicle", 1.0, 80, drop=False),
    Body("r1-wide", 1.0, 112),
    Body("r1-R18", 1.0, 120, radius=18.0),
)
QUICK = (Body("r1", 1.0, 48, radius=8.0),)


def speed(run):
    """Of the centre over the last third, by a straight line."""
    if run.failure is not None:
        return math.nan
    steps, places = run.metrics["step"], run.metrics["z"]
    late = steps >= steps[-1] * 2 / 3
    return float(numpy.polyfit(steps[late], places[late], 1)[0])


def main():
    item = Item(__file__, "A settling drop")
    cases = QUICK if item.quick else CASES
    dearest_first = sorted(cases, key=lambda c: -(c.box**3) * c.steps())
    finished = item.run([case.simulation() for case in dearest_first])
    results = item.results
    rows = []
    for case in cases:
        run = finished[case.name]
        volume = run.last("volume")
        radius = (3 * volume / (4 * math.pi)) ** (1 / 3)
        stokes = case.force() * volume / (6 * math.pi * case.viscosity() * radius)
        found, fraction = speed(run) / stokes, case.fraction(radius)
        first, second = first_order(case.ratio, fraction), with_next_order(case.ratio, fraction)
        results.relative("speed over Stokes' of a solid sphere", case.conditions(), found, second,
                         0.05 if item.quick else 0.03)  # fmt: skip
        alone = found + (first_order(case.ratio, 0.0) - second)
        results.report("the same, images taken off, beside Hadamard's and Rybczynski's", case.conditions(), alone,
                       first_order(case.ratio, 0.0))  # fmt: skip
        drift = float(numpy.hypot(run.last("x") - case.box / 2, run.last("y") - case.box / 2))
        results.at_most("drift sideways, cells", case.conditions(), drift, 0.01)
        rows.append((case.conditions(), fraction, found, first, second, 100 * (found / first - 1), 100 * (found / second - 1)))
    results.table("Speed over F/(6 pi eta R), and in theory to first order in R/L and with the term in c", (
        "", "c", "measured", "first order", "with c", "off first %", "off second %"), rows)  # fmt: skip
    item.finish()


if __name__ == "__main__":
    main()
