#!/usr/bin/python3
"""Viscosity of a dilute emulsion in a box that shears without walls: one drop, and eight."""

import math
import sys
from dataclasses import dataclass
from pathlib import Path

import numpy

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))

from validation import periodic_stokeslet
from validation.in_flow import greatest_rate, steps_of_strain
from validation.item import Item
from validation.pair import greatest_mass_drift
from validation.periodic_stokeslet import PeriodicStokeslet
from validation.simulations import Simulation

ONE = Path(__file__).resolve().parents[1] / "drop_in_shear" / "drop.toml"
EIGHT = Path(__file__).with_name("eight.toml")
VISCOSITY, CAPILLARY = 0.5, 0.05
TAYLOR = 7 / 4  # (eta_eff/eta - 1)/c for c -> 0 at equal viscosities: (1 + 2.5 r)/(1 + r)


def shape_of_lattice(strain):
    """f in (eta_eff/eta - 1)/c = 7/4 (1 + f c + ...) of drops on the lattice that a cube's has been sheared into: what the
    images' dipoles strain a drop by, over the shear and over c. A drop's dipole at equal viscosities is 7/10 of that of
    a rigid sphere, (20 pi/3) eta a^3 E."""
    dipole = numpy.zeros((3, 3))
    dipole[0, 2] = dipole[2, 0] = 1.0
    lattice = PeriodicStokeslet([[1, 0, 0], [0, 1, 0], [strain, 0, 1]])
    per_fraction = 0.7 * (20 * math.pi / 3) / (8 * math.pi) / (4 * math.pi / 3)
    return per_fraction * lattice.strain_of_images(dipole)[0, 2]


@dataclass(frozen=True)
class Emulsion:
    radius: float
    edge: int
    strain: float = 2.0
    mean_from: float = 1.0  # a whole number of strains before the end: the images come by once in each
    drops: int = 1
    reynolds: float = 0.098

    def name(self):
        return f"n{self.drops}-R{self.radius:g}-L{self.edge}{'' if self.reynolds == 0.098 else '-half-Re'}"

    def conditions(self):
        what = "one drop" if self.drops == 1 else "eight drops"
        return f"{what}, R = {self.radius:g}, box {self.edge}{'' if self.reynolds == 0.098 else ', half of Re'}"

    def rate(self):
        return greatest_rate(self.radius, VISCOSITY, self.reynolds)

    def sigma(self):
        return float(f"{VISCOSITY * self.rate() * self.radius / CAPILLARY:.4g}")

    def every(self):
        return steps_of_strain(0.05, self.rate(), 10)

    def steps(self):
        return steps_of_strain(self.strain, self.rate(), self.every())

    def simulation(self):
        settings = {
            "lattice.size": [self.edge] * 3, "fluid.kinematic_viscosity": VISCOSITY, "flow.shear.rate": self.rate(),
            "flow.shear.with": "lees-edwards", "vesicle_type.drop.tension.sigma": self.sigma(),
            "run.steps": self.steps(), "output.metrics.every": self.every(),
            "output.checkpoint.every": max(500, self.steps() // 4),
        }  # fmt: skip
        if self.drops == 1:
            settings |= {"vesicle[0].centre": [self.edge / 2] * 3, "vesicle[0].radius": self.radius}
        return Simulation(self.name(), ONE if self.drops == 1 else EIGHT, settings)


HALF, BASE, TWICE = Emulsion(12.0, 76), Emulsion(12.0, 60), Emulsion(12.0, 48)
COARSE, FINE = Emulsion(8.0, 40), Emulsion(18.0, 90)
MANY = Emulsion(8.0, 80, drops=8)
SLOW = Emulsion(12.0, 60, reynolds=0.049)
CASES = (HALF, BASE, TWICE, COARSE, FINE, MANY, SLOW)
QUICK = (Emulsion(8.0, 40, 0.6, 0.4),)


@dataclass(frozen=True)
class Measured:
    fraction: float
    intrinsic: float  # (eta_eff/eta - 1)/c, the mean over whole periods of the lattice
    whole: float  # where the images stand above each other
    between: float  # where they stand half-way


def measure(run, case):
    samples = run.metrics
    strain = samples["step"] * case.rate()
    late = strain >= case.mean_from
    volume = sum(float(run.run.metrics(k)["volume"][late].mean()) for k in range(case.drops))
    fraction = volume / case.edge**3

    def intrinsic(at):
        return (numpy.interp(at, strain, samples["effective_viscosity"]) - 1.0) / fraction

    places = numpy.linspace(case.mean_from, case.strain, 400, endpoint=False)
    return Measured(fraction, float(intrinsic(places).mean()), float(intrinsic(case.strain)), float(intrinsic(case.strain - 0.5)))


def judge(item, found):
    """The laws of the whole campaign; `found` may lack what has failed."""
    results = item.results
    slope = float(numpy.mean([shape_of_lattice(k / 16) for k in range(16)]))
    swing = shape_of_lattice(0.5) - shape_of_lattice(0.0)
    for case, m in found.items():
        if case.reynolds == 0.098 and case.radius >= 12:
            results.relative("(eta_eff/eta - 1)/c against Taylor", case.conditions(), m.intrinsic, TAYLOR, 0.05)
        else:
            results.report("(eta_eff/eta - 1)/c, beside Taylor", case.conditions(), m.intrinsic, TAYLOR)
    if all(case in found for case in (HALF, BASE, TWICE)):
        points = [found[case] for case in (HALF, BASE, TWICE)]
        line = numpy.polyfit([m.fraction for m in points], [m.intrinsic for m in points], 1)
        results.relative("the same for c -> 0, by a straight line", "one drop, R = 12", float(line[1]), TAYLOR, 0.05)
        results.report("the line's slope in c, over 7/4, beside that of dipoles on a sheared lattice", "one drop, R = 12",
                       float(line[0]) / TAYLOR, slope)  # fmt: skip
        last = found[TWICE]
        results.report("its swing as images pass, over 7/4 c, beside that of dipoles", TWICE.conditions(),
                       (last.between - last.whole) / (TAYLOR * last.fraction), swing)  # fmt: skip
    if all(case in found for case in (COARSE, BASE, FINE)):
        line = numpy.polyfit([case.radius**-2 for case in (COARSE, BASE, FINE)],
                             [found[case].intrinsic for case in (COARSE, BASE, FINE)], 1)  # fmt: skip
        results.report("(eta_eff/eta - 1)/c for R -> infinity, by a straight line in R^-2, beside Taylor", "c = 3.4 %",
                       float(line[1]), TAYLOR * (1 + slope * found[FINE].fraction))  # fmt: skip
    if MANY in found and COARSE in found:
        results.relative("(eta_eff/eta - 1)/c of eight drops over that of one, at the same c and R", MANY.conditions(),
                         found[MANY].intrinsic / found[COARSE].intrinsic, 1.0, 0.05)  # fmt: skip
    results.table("Viscosity that drops add, over c; the mean over a whole period of the lattice, and at two places in it", (
        "emulsion", "c", "(eta_eff/eta - 1)/c", "off Taylor %", "images above each other", "half-way between"),
        [(case.conditions(), m.fraction, m.intrinsic, 100 * (m.intrinsic / TAYLOR - 1), m.whole, m.between)
         for case, m in found.items()])  # fmt: skip


def main():
    periodic_stokeslet.self_test()
    item = Item(__file__, "A dilute emulsion")
    cases = QUICK if item.quick else CASES
    dearest_first = sorted(cases, key=lambda c: -(c.edge**3) * c.steps())
    finished = item.run([case.simulation() for case in dearest_first])
    whole = [case for case in cases if finished[case.name()].failure is None]
    found = {case: measure(finished[case.name()], case) for case in whole}
    if item.quick:
        for case, m in found.items():
            item.results.relative("(eta_eff/eta - 1)/c against Taylor", case.conditions(), m.intrinsic, TAYLOR, 0.15)
    else:
        judge(item, found)
        if MANY in found:
            item.results.at_most("mass drift of the first two of eight, relative", MANY.conditions(),
                                 greatest_mass_drift(finished[MANY.name()]), 1e-10)  # fmt: skip
    item.finish()


if __name__ == "__main__":
    main()
