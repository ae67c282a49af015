#!/usr/bin/python3
"""Drops: Laplace's law, spurious currents, and the relaxation of an ellipsoidal drop at equal viscosities."""

import math
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))

from validation.harmonics import decay_rate
from validation.item import Item
from validation.shapes_at_rest import pressure_jump
from validation.simulations import Simulation

HERE = Path(__file__).parent
SIGMA = 0.01
RADII = (7.5, 10, 15, 22.5)
RIPPLE = {"radius": 12.0, "sigma": 0.003, "nu": 0.5, "steps": 3000}
BOXES = (56, 80)


def main():
    item = Item(__file__, "Drops without a membrane")
    radii = RADII[1:2] if item.quick else RADII
    resting = {}
    for radius in radii:
        box = 8 * math.ceil((2 * radius + 20) / 8)
        steps = 2400 if item.quick else 6000
        resting[radius] = Simulation(f"rest-R{radius:g}", HERE / "drop.toml", {
            "lattice.size": [box] * 3, "vesicle[0].centre": [box / 2] * 3, "vesicle[0].radius": radius,
            "run.steps": steps, "output.fields.every": steps, "output.surfaces.every": steps,
        })  # fmt: skip
    wide = None
    if not item.quick:  # spurious currents come from the narrowness of the layer: see README
        wide = Simulation("rest-R15-beta0.5", HERE / "drop.toml", {**resting[15].settings, "fluid.segregation": 0.5})
    rippled = {}
    for box in () if item.quick else BOXES:
        rippled[box] = Simulation(f"ripple-box{box}", HERE / "ripple.toml", {
            "lattice.size": [box] * 3, "vesicle[0].centre": [box / 2] * 3, "vesicle[0].radius": RIPPLE["radius"],
            "vesicle_type.drop.tension.sigma": RIPPLE["sigma"], "fluid.kinematic_viscosity": RIPPLE["nu"],
            "run.steps": RIPPLE["steps"], "output.surfaces.every": RIPPLE["steps"] // 20,
        })  # fmt: skip
        rippled[box, "none"] = Simulation(f"ripple-without-tension-box{box}", HERE / "ripple.toml", {
            **rippled[box].settings, "vesicle_type.drop.tension.sigma": 0.0})  # fmt: skip
    finished = item.run([*reversed(resting.values()), *([wide] if wide else []), *rippled.values()])
    results = item.results

    rows = []
    for radius in radii:
        run = finished[f"rest-R{radius:g}"]
        true_radius = (3 * run.last("volume") / (4 * math.pi)) ** (1 / 3)
        jump = pressure_jump(run)
        law = 2 * SIGMA / true_radius
        speed = run.last("max_speed") * (1 / 6) / SIGMA
        rows.append((radius, true_radius, jump, law, 100 * (jump / law - 1), speed))
        if radius >= 10:
            results.relative("Laplace: p_in - p_out against 2 sigma/R", f"R = {radius:g}", jump, law, 0.01)
        if radius >= 15 or item.quick:
            bound = 1e-4 if not item.quick else 3e-4
            results.at_most("spurious currents, Ca = eta u_max/sigma", f"R = {radius:g}", speed, bound)
    if wide:
        results.at_most("spurious currents, Ca = eta u_max/sigma", "R = 15, beta = 0.5",
                        finished[wide.name].last("max_speed") * (1 / 6) / SIGMA, 1e-4)  # fmt: skip
    results.table("Drops at rest after 6,000 steps", ("R0", "R", "p_in - p_out", "2 sigma/R", "error %",
                                                      "spurious Ca"), rows)  # fmt: skip

    if not item.quick:
        radius, last = RIPPLE["radius"], RIPPLE["steps"]
        law = 40 * 2 / (5 * 35) * RIPPLE["sigma"] / (RIPPLE["nu"] * radius)
        in_box = {b: decay_rate(finished[f"ripple-box{b}"], 2, 0.2 * last, last)
                  - decay_rate(finished[f"ripple-without-tension-box{b}"], 2, 0.2 * last, last) for b in BOXES}  # fmt: skip
        weight = (BOXES[1] / BOXES[0]) ** 3
        found = (weight * in_box[BOXES[1]] - in_box[BOXES[0]]) / (weight - 1)
        results.relative("relaxation rate of l = 2, images taken off", "equal viscosities", found, law, 0.05)
        for box in BOXES:
            results.report("relaxation rate of l = 2", f"box {box}", in_box[box], law)
    item.finish()


if __name__ == "__main__":
    main()
