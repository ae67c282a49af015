#!/usr/bin/python3
"""A discocyte in shear, its axis along the vorticity: deformation against rate, and its return when the shear ends."""

import math
import sys
from pathlib import Path

import numpy

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))

from validation.in_flow import drift_of_end, mean_of_end
from validation.item import Item
from validation.simulations import Simulation

CASE = Path(__file__).with_name("cell.toml")
RADIUS, NU, KAPPA = 14.0, 0.5, 0.2
RATES = (2.5e-5, 5.4e-5, 1.16e-4, 2.5e-4)
START, STEPS = 2000, 24000
STOP, RETURNED = 20000, 50000
END = 2000  # steps that means are over


def capillary(rate):
    return NU * rate * RADIUS**3 / KAPPA


def sheared(rate, steps=STEPS):
    return Simulation(f"rate{rate:g}", CASE, {
        "flow.shear.rate": rate, "flow.shear.start": START, "run.steps": steps,
        "vesicle_type.cell.bending.modulus": KAPPA,
    })  # fmt: skip


def released():
    return Simulation("released", CASE, {
        "flow.shear.rate": RATES[-1], "flow.shear.start": START, "flow.shear.stop": STOP, "run.steps": RETURNED,
        "vesicle_type.cell.bending.modulus": KAPPA, "output.checkpoint.every": 10000,
    })  # fmt: skip


def quick(item):
    run = item.run([Simulation("short", CASE, {
        "lattice.size": [40, 28, 40], "vesicle[0].centre": [20, 14.5, 20], "vesicle[0].radius": 11.0,
        "vesicle[0].reduced_volume": 0.9, "flow.shear.rate": 4e-4, "flow.shear.start": 0, "run.steps": 1000,
        "vesicle_type.cell.bending.modulus": 0.1,
    })])["short"]  # fmt: skip
    if run.failure is not None:
        return
    item.results.at_least("an oblate in shear grows longer", "v = 0.9, strain 0.4", run.last("deformation_index"), 0.02)
    item.results.absolute("A/A_target", "v = 0.9, strain 0.4", run.last("area_ratio"), 1.0, 1e-3)


def judge_rates(item, finished):
    rows, found = [], []
    for rate in RATES:
        run = finished[f"rate{rate:g}"]
        index = mean_of_end(run, "deformation_index", END)
        found.append(index)
        conditions = f"Ca = {capillary(rate):.2g}"
        item.results.absolute("A/A_target in steady shear", conditions, mean_of_end(run, "area_ratio", END), 1.0, 1e-3)
        item.results.absolute("centre off the middle, cells", conditions,
                              math.hypot(run.last("x") - 36, run.last("y") - 20.5, run.last("z") - 36), 0.0, 0.1)  # fmt: skip
        rows.append((rate, capillary(rate), 100 * index, 100 * drift_of_end(run, "deformation_index", END),
                     mean_of_end(run, "taylor_deformation", END), mean_of_end(run, "inclination", END),
                     mean_of_end(run, "tank_treading_frequency", END) / rate))  # fmt: skip
    item.results.at_least("smallest rise of the deformation index from one rate to the next", "a decade of rates",
                          float(numpy.diff(found).min()), 0.0)  # fmt: skip
    item.results.table("A discocyte in shear, v = 0.667", (
        "rate", "Ca", "DI %", "its change over the last 2000 steps, %", "D in the shear plane", "inclination",
        "tank-treading frequency over the rate"), rows)  # fmt: skip


def judge_return(item, run):
    if run.failure is not None:
        return
    names = ("inertia_1", "inertia_2", "inertia_3")
    for k, name in enumerate(names, 1):
        before, during, after = (run.at(step, name) for step in (START, STOP, RETURNED))
        item.results.relative(f"eigenvalue {k} of inertia after the shear against before", "Ca = 1.7", after, before, 0.01)
        item.results.report(f"eigenvalue {k} in shear over that before", "Ca = 1.7", during / before)
    after_start = run.metrics["step"] >= START
    worst = float(numpy.abs(run.metrics["area_ratio"][after_start] - 1).max())
    item.results.at_most("|A/A_target - 1| all along", "Ca = 1.7, from the shear's start on", worst, 1e-3)
    volumes = run.metrics["volume"][after_start]
    item.results.at_most("change of the volume", "Ca = 1.7, from the shear's start on",
                         float(numpy.abs(volumes / volumes[0] - 1).max()), 5e-3)  # fmt: skip
    item.results.absolute("deformation index after the return", "Ca = 1.7", run.last("deformation_index"), 0.0, 0.01)
    rows = []
    for step in (START, 5000, 10000, STOP, 22000, 25000, 30000, 40000, RETURNED):
        before = [run.at(START, name) for name in names]
        rows.append((float(step), *(run.at(step, name) / b for name, b in zip(names, before)),
                     100 * run.at(step, "deformation_index"), run.at(step, "area_ratio") - 1))  # fmt: skip
    item.results.table(f"Shear on from step {START} to {STOP}: eigenvalues over those before", (
        "step", "smallest", "middle", "largest", "DI %", "A/A_target - 1"), rows)  # fmt: skip


def main():
    item = Item(__file__, "A discocyte in shear")
    if item.quick:
        quick(item)
        item.finish()
    finished = item.run([released(), *(sheared(rate) for rate in RATES)])
    judge_rates(item, finished)
    judge_return(item, finished["released"])
    item.finish()


if __name__ == "__main__":
    main()
