#!/usr/bin/python3
"""Two discocytes driven past each other by opposite buoyancy."""

import sys
from dataclasses import dataclass
from pathlib import Path

import numpy

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

from validation.item import Item
from validation.pair import both, half_turn_asymmetry, judge_integrity, least_gap, separation, surface_distance, surface_files
from validation.simulations import Simulation

CASE = ROOT / "cases" / "pair-passing.toml"
WIDTH = 2 / 0.67  # of the interface, 2/beta
SETTLED = 500  # steps in which the layers, drawn from a shape, become the lattice's own


@dataclass(frozen=True)
class Case:
    name: str
    conditions: str
    size: tuple
    settings: dict

    def simulation(self):
        return Simulation(self.name, CASE, self.settings)


WHOLE = Case("pair", "v = 0.65, R0 = 15", (128, 64, 88), {})
QUICK = Case("pair", "v = 0.95, R0 = 8.5", (64, 32, 48), {
    "lattice.size": [64, 32, 48], "run.steps": 800, "output.metrics.every": 50, "output.surfaces.every": 400,
    "output.checkpoint.every": 100000,
    "vesicle_type.forwards.buoyancy": [3e-4, 0.0, 0.0], "vesicle_type.backwards.buoyancy": [-3e-4, 0.0, 0.0],
    **{f"vesicle[{k}].{key}": value for k, centre in enumerate(([19, 16, 21], [45, 16, 27]))
       for key, value in (("shape", "prolate"), ("reduced_volume", 0.95), ("radius", 8.5), ("centre", centre),
                          ("axis", [0, 0, 1]))},
})  # fmt: skip


def judge(results, run, case):
    conditions = case.conditions
    judge_integrity(results, run, conditions, SETTLED, 0.005)
    results.at_most("distance from the half turn about the middle, cells", conditions, half_turn_asymmetry(run, case.size), 1e-6)
    first, _ = both(run)
    along, across = separation(run, "x"), separation(run, "z")
    if case is WHOLE:
        results.at_most("second's place ahead of the first along x at the end, cells, at the start 40", conditions,
                        along[-1], 0.0)  # fmt: skip
        abreast = int(numpy.argmax(along <= 0.0))
        results.report("step at which they are abreast", conditions, first["step"][abreast] if along[-1] < 0 else float("nan"))
    results.report("least gap over the interface's width 2/beta", conditions, least_gap(run) / WIDTH)
    results.report("greatest displacement of the first along z, cells", conditions, numpy.abs(first["z"] - first["z"][0]).max())
    results.report("displacement of the first along y, which the symmetry forbids, cells", conditions,
                   numpy.abs(first["y"] - first["y"][0]).max())  # fmt: skip
    results.report("offset along z at the end, cells, beside that at the start", conditions, across[-1], across[0])
    early = max(float(numpy.abs(m["area_ratio"] - 1.0)[m["step"] <= SETTLED].max()) for m in both(run))
    results.report(f"change of either's area, relative, in the first {SETTLED} steps", conditions, early)
    distances = {step: surface_distance(path, case.size) for step, path in surface_files(run)}
    rows = []
    for step, distance in distances.items():
        k = int(numpy.flatnonzero(first["step"] == step)[0])
        rows.append((step, along[k], across[k], first["gap"][k], distance, first["area_ratio"][k] - 1.0,
                     first["reduced_volume"][k], first["bending_energy"][k]))  # fmt: skip
    if len(rows) > 13:
        rows = [rows[k] for k in numpy.linspace(0, len(rows) - 1, 13).round().astype(int)]
    results.table("On the way: the second's place from the first, their gap, and the first's shape", (
        "step", "x", "z", "gap", "between the surfaces", "A/A0 - 1", "v", "E/(8 pi kappa)"), rows)  # fmt: skip


def main():
    item = Item(__file__, "Two discocytes that pass each other")
    case = QUICK if item.quick else WHOLE
    run = item.run([case.simulation()])[case.name]
    if run.failure is None:
        judge(item.results, run, case)
    item.finish()


if __name__ == "__main__":
    main()
