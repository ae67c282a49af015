"""What an item takes, before it is run: from the cells and steps of its runs."""

import tomllib
from pathlib import Path

SPEED = 20e6  # cells per second of one core in double precision; in single precision twice as many


def core_minutes(simulations):
    return sum(_cells_times_steps(s) / (SPEED * (2 if s.settings.get("numerics.precision") == "single" else 1)) for s in simulations) / 60


def _cells_times_steps(simulation):
    case = tomllib.loads(Path(simulation.case).read_text("utf-8"))
    x, y, z = simulation.settings.get("lattice.size", case["lattice"]["size"])
    return x * y * z * simulation.settings.get("run.steps", case["run"]["steps"])
