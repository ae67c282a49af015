#!/usr/bin/python3
"""Relaxation rates of the modes l = 2, 3, 4 of a nearly spherical vesicle, at equal viscosities."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))

from validation.harmonics import decay_rate, inextensible_mobility, relaxation_rate
from validation.item import Item
from validation.simulations import Simulation

CASE = Path(__file__).with_name("sphere.toml")
RADIUS, NU = 12.0, 0.5
MEMBRANES = {"bending": 0.2, "none": 0.0}  # name -> kappa
BOXES = (56, 80)
# Two to three times 1/Gamma_l: later a static offset of the lattice's making, 1e-4 R at most, would show.
STEPS = {2: 3000, 3: 1200, 4: 600}


def degrees_of(box, quick):
    """The images are looked at in the slowest mode alone: their influence on the others falls faster with distance."""
    return (2,) if quick or box != BOXES[0] else tuple(STEPS)


def main():
    item = Item(__file__, "Quasi-spherical relaxation")
    boxes = BOXES[:1] if item.quick else BOXES
    membranes = ("bending", "none") if item.quick else tuple(MEMBRANES)
    simulations = {}
    for box in reversed(boxes):
        for membrane in membranes:
            for l in degrees_of(box, item.quick):
                kappa = MEMBRANES[membrane]
                steps = 1500 if item.quick else STEPS[l]
                name = f"{membrane}-l{l}-box{box}"
                simulations[membrane, l, box] = Simulation(name, CASE, {
                    "lattice.size": [box] * 3, "vesicle[0].centre": [box / 2] * 3, "vesicle[0].radius": RADIUS,
                    "vesicle[0].perturbation[0].l": l, "vesicle[0].perturbation[0].amplitude": 0.06 / l,
                    "vesicle_type.vesicle.bending.modulus": kappa, "vesicle_type.vesicle.tension.sigma": 0.0,
                    "run.steps": steps, "output.surfaces.every": steps // 10,
                })  # fmt: skip
    finished = item.run(simulations.values())

    def measured(membrane, l, box):
        last = 1500 if item.quick else STEPS[l]
        return decay_rate(finished[f"{membrane}-l{l}-box{box}"], l, 0.3 * last, last)

    rows = []
    for membrane in membranes:
        if membrane == "none":
            continue
        kappa = MEMBRANES[membrane]
        for l in degrees_of(BOXES[0], item.quick):
            # What the layer does without a membrane (its recolouring resists a little) is not the membrane's.
            in_box = {b: measured(membrane, l, b) - measured("none", l, b) for b in boxes if f"{membrane}-l{l}-box{b}" in finished}
            found = in_box[boxes[0]]
            if len(in_box) == 2:  # the images' influence on l = 2 falls with their volume fraction, 1/box^3
                weight = (boxes[1] / boxes[0]) ** 3
                found = (weight * in_box[boxes[1]] - in_box[boxes[0]]) / (weight - 1)
            paper = relaxation_rate(l, kappa, 0.0, RADIUS, NU)
            inextensible = relaxation_rate(l, kappa, 0.0, RADIUS, NU, inextensible_mobility)
            tolerance = 0.15 if item.quick else 0.05
            item.results.relative(f"relaxation rate of l = {l}", membrane, found, paper, tolerance)
            rows.append((membrane, l, *(in_box.get(b, "") for b in boxes), found, paper, inextensible))
    if not item.quick:
        item.results.table(
            "Relaxation rates per step, R = 12: in two boxes, without images, and in theory",
            ("membrane", "l", *(f"box {b}" for b in boxes), "no images", "normal force only (ours)",
             "locally inextensible"), rows)  # fmt: skip
        for l in STEPS:
            item.results.report("rate without a membrane, per step", f"l = {l}, box {boxes[0]}",
                                measured("none", l, boxes[0]))  # fmt: skip
    item.finish()


if __name__ == "__main__":
    main()
