#!/usr/bin/python3
"""The film between two vesicles that opposite buoyancy presses together head-on."""

import math
import sys
from dataclasses import dataclass
from pathlib import Path

import numpy

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))

from validation.item import Item
from validation.pair import both, judge_integrity, least_gap, surface_distance, surface_files
from validation.simulations import Simulation

CASE = Path(__file__).with_name("film.toml")
VISCOSITY = 0.3333333
WIDTH = 2 / 0.67  # of the interface, 2/beta
SETTLED = 500  # steps in which the layers, drawn from a shape, become the lattice's own
NOISE = 0.05  # cells: what the gap, a least value over lattice cells, may rise by as the membranes pass over them
FAR, NEAR = 10.0, 6.0  # cells: gaps between which neither film nor overlap of layers matters yet


@dataclass(frozen=True)
class Pair:
    name: str
    buoyancy: float
    steps: int
    size: tuple = (96, 48, 48)
    radius: float = 12.0
    distance: float = 36.0  # of the centres at the start

    def every(self):
        """As many samples as of any other at the same scaled time."""
        return max(40, self.steps // 240)

    def scaled(self, steps):
        """Time over eta/(b R0), in which a body under b goes about as far as any other."""
        return steps * self.buoyancy * self.radius / VISCOSITY

    def conditions(self):
        return f"b = {self.buoyancy:g}, R0 = {self.radius:g}"

    def simulation(self):
        middle = [length / 2 for length in self.size]
        settings = {"lattice.size": list(self.size), "run.steps": self.steps, "output.metrics.every": self.every(),
                    "output.surfaces.every": self.steps // 6, "output.checkpoint.every": self.steps // 4}  # fmt: skip
        for k, side in enumerate((-1, 1)):
            settings[f"vesicle[{k}].centre"] = [middle[0] + side * self.distance / 2, *middle[1:]]
            settings[f"vesicle[{k}].radius"] = self.radius
            settings[f"vesicle[{k}].buoyancy"] = [-side * self.buoyancy, 0.0, 0.0]
        return Simulation(self.name, CASE, settings)


CASES = (Pair("single", 2e-5, 24000), Pair("doubled", 4e-5, 12000))
QUICK = (Pair("single", 2e-4, 960, (56, 32, 32), 8.5, 24.0),)


def time_at(run, gap):
    """The first step, between samples, at which the gap is as small as this; NaN if it never is."""
    first, _ = both(run)
    steps, gaps = first["step"], first["gap"]
    below = numpy.flatnonzero(gaps <= gap)
    if len(below) == 0 or below[0] == 0:
        return math.nan
    k = below[0]
    return float(steps[k - 1] + (steps[k] - steps[k - 1]) * (gaps[k - 1] - gap) / (gaps[k - 1] - gaps[k]))


def judge_one(results, run, case):
    conditions = case.conditions()
    judge_integrity(results, run, conditions, SETTLED, 0.01)
    first, second = both(run)
    late = first["step"] >= SETTLED
    gap = first["gap"][late]
    results.at_most("rise of the gap above what it has been, cells", conditions,
                    (gap - numpy.minimum.accumulate(gap)).max(), NOISE)  # fmt: skip
    results.at_most("distance of the centres from mirror images, cells", conditions,
                    numpy.abs(first["x"] + second["x"] - case.size[0]).max(), 1e-6)  # fmt: skip
    sideways = max(float(numpy.hypot(m["y"] - m["y"][0], m["z"] - m["z"][0]).max()) for m in (first, second))
    results.report("greatest displacement across the line of centres, cells", conditions, sideways)
    results.report("least gap, cells, beside the interface's width 2/beta", conditions, least_gap(run), WIDTH)
    step, path = surface_files(run)[-1]
    results.report(f"distance of the surfaces' corners at step {step}, cells, beside the gap there", conditions,
                   surface_distance(path, case.size), run.at(step, "gap"))  # fmt: skip
    results.report("shortening of the first along the line of centres, by its inertia, cells", conditions,
                   half_length(first, 0) - half_length(first, -1))  # fmt: skip


def half_length(samples, k):
    """The half axis along the line of centres of the ellipsoid that has these principal moments, the largest being that
    about the line."""
    volume = samples["volume"][k]
    smaller = 0.5 * (samples["inertia_1"][k] + samples["inertia_2"][k])
    return math.sqrt(5 * (smaller - samples["inertia_3"][k] / 2) / volume)


def compare(results, single, doubled):
    """Forces in the ratio of two: linear as long as the shapes stay, and what flattening does to it."""
    one, two = CASES
    (first, _), (other, _) = both(single), both(doubled)
    approach = [c.scaled(time_at(r, NEAR) - time_at(r, FAR)) for c, r in zip(CASES, (single, doubled))]
    results.relative(f"scaled time from a gap of {FAR:g} to one of {NEAR:g} cells, twice the force over once", "doubled",
                     approach[1] / approach[0], 1.0, 0.10)  # fmt: skip
    step = time_at(single, NEAR)
    results.at_most(f"gap when the lesser force has brought it to {NEAR:g} cells", "doubled",
                    float(numpy.interp(step, other["step"], other["gap"])), NEAR)  # fmt: skip
    rows = []
    for time in numpy.linspace(0, one.scaled(one.steps), 13):
        gaps = [float(numpy.interp(time, c.scaled(m["step"]), m["gap"])) for c, m in zip(CASES, (first, other))]
        rows.append((time, *gaps, *[g / WIDTH for g in gaps]))
    results.report("gap at the same scaled time at the end, twice the force over once", "doubled", rows[-1][2] / rows[-1][1])
    results.table("Gap against t b R0/eta, in cells and over the interface's width", (
        "t b R0/eta", f"b = {one.buoyancy:g}", f"b = {two.buoyancy:g}", f"b = {one.buoyancy:g}, over 2/beta",
        f"b = {two.buoyancy:g}, over 2/beta"), rows)  # fmt: skip


def main():
    item = Item(__file__, "The film between two vesicles")
    cases = QUICK if item.quick else CASES
    finished = item.run([case.simulation() for case in cases])
    whole = [case for case in cases if finished[case.name].failure is None]
    for case in whole:
        judge_one(item.results, finished[case.name], case)
    if len(whole) == 2:
        compare(item.results, finished["single"], finished["doubled"])
    item.finish()


if __name__ == "__main__":
    main()
