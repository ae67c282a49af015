#!/usr/bin/python3
"""Which viscosities inside and outside a sheared vesicle survives."""

import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))

from validation.item import Item
from validation.simulations import Simulation, run_all

CASE = Path(__file__).with_name("vesicle.toml")
RATIOS = (0.1, 0.5, 2.0, 10.0, 50.0)
OUTER = (0.005, 0.02, 0.1, 0.5)
GHOSTS = ("regularised", "trt")
USUAL = 0.1  # viscosities outside from here on are asked to bear every ratio


def name_of(outer, ratio, ghosts):
    return f"nu{outer:g}-r{ratio:g}-{ghosts}"


def simulation(outer, ratio, ghosts):
    settings = {"fluid.kinematic_viscosity": outer, "vesicle_type.lipid.viscosity_ratio": ratio}
    if ghosts != "regularised":
        settings["fluid.collision.ghost_rates"] = ghosts
    return Simulation(name_of(outer, ratio, ghosts), CASE, settings)


def verdict(run):
    """"ends", or when and of what the run died."""
    if run.failure is None:
        return "ends"
    step = re.search(r"step (\d+)", run.failure)
    cause = re.search(r"\b(density|speed|force|tension)\b", run.failure)
    return " ".join(["fails", *(["at step", step[1]] if step else []), *([f"({cause[1]})"] if cause else [])])


def main():
    item = Item(__file__, "Viscosity contrast: where it stops being stable")
    outer = (0.1,) if item.quick else OUTER
    ratios = (0.1, 50.0) if item.quick else RATIOS
    grid = [(nu, ratio, ghosts) for ghosts in GHOSTS for nu in outer for ratio in ratios]
    finished = run_all([simulation(*point) for point in grid], item.scratch, item.program, item.processes)
    item.results.seconds += sum(run.seconds for run in finished.values())
    for ghosts in GHOSTS:
        rows = []
        for nu in outer:
            verdicts = [verdict(finished[name_of(nu, ratio, ghosts)]) for ratio in ratios]
            rows.append((f"{nu:g}", *verdicts))
            if nu >= USUAL:
                item.results.at_most("ratios of viscosity at which a run fails", f"nu outside = {nu:g}, {ghosts}",
                                     sum(word != "ends" for word in verdicts), 0)  # fmt: skip
        item.results.table(f"What becomes of a run, {ghosts}", ("nu outside", *(f"ratio {ratio:g}" for ratio in ratios)), rows)
    item.finish()


if __name__ == "__main__":
    main()
