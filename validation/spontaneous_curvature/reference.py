#!/usr/bin/python3
"""The rest shapes that a run with spontaneous curvature is held to; as a program, writes reference.csv beside it."""

import csv
import json
from functools import lru_cache
from pathlib import Path

import numpy as np
from axisymmetric_minimiser import Shape, follow, minimise
from off_axis_stability import unstable_orders

HERE = Path(__file__).resolve().parent
TABLE = HERE.parents[1] / "data" / "helfrich" / "helfrich_c0_0_fourier.json"
#: Highest order of the sine series: the narrower the neck, the more.
MODES = {"oblate": 32, "prolate": 64, "stomatocyte": 110}
ENTRIES = [
    (c, branch, v)
    for c in (-2.0, -1.0, 0.0, 1.0, 2.0)
    for branch, v in (("oblate", 0.8), ("oblate", 0.667), ("prolate", 0.8), ("prolate", 0.667))
]


@lru_cache(maxsize=1)
def _table() -> dict:
    return json.loads(TABLE.read_text())


def tabulated_shape(branch: str, reduced_volume: float, modes: int = 0) -> Shape:
    """Return the C0 = 0 shape of `branch` that data/helfrich tabulates at `reduced_volume`, converged anew.

    `branch` is oblate, prolate or stomatocyte; `modes` as in `minimise`. Raises KeyError for a volume not in the table.
    """
    entry = _table()[f"{branch}_{reduced_volume:g}"]
    coefficients = np.zeros(max(order for order, _ in entry["a"]))
    for order, value in entry["a"]:
        coefficients[order - 1] = value
    guess = Shape(
        coefficients, entry["L"], 0.0, reduced_volume, 1.0, 0.0, 0.0, 0.0, mirror=branch != "stomatocyte"
    )
    return minimise(reduced_volume, 0.0, guess, modes or MODES[branch])


def reference_shape(c0_RA: float, branch: str, v: float) -> Shape:  # noqa: N803
    """Return the rest shape at C0 R_A = `c0_RA` and reduced volume `v`, on `branch` as it continues from C0 = 0.

    `branch` is oblate, prolate or stomatocyte. Raises NoShape where it ends before.
    """
    known = [float(name.split("_")[1]) for name in _table() if name.startswith(f"{branch}_")]
    if not known:
        raise ValueError(f"the branch is {branch!r}; expected oblate, prolate or stomatocyte")
    start = tabulated_shape(branch, min(known, key=lambda x: abs(x - v)))
    return follow(follow(start, v, 0.0, largest_step=0.5), v, c0_RA, largest_step=0.5)


def row(shape: Shape, branch: str) -> dict[str, str]:
    """Return the columns of reference.csv for one shape."""
    across, along = shape.inertia
    numbers = {
        "energy": shape.energy, "r_max": shape.largest_radius, "axis_thickness": shape.axis_thickness,
        "total_height": shape.total_height, "neck_radius": shape.neck_radius, "sharpest_radius": shape.sharpest_radius, "inertia_across": across,
        "inertia_along": along, "mean_curvature": shape.mean_curvature, "area_multiplier": shape.area_multiplier,
        "volume_multiplier": shape.volume_multiplier,
    }
    key = {"c0_times_R_A": f"{shape.spontaneous_curvature:g}", "branch": branch, "v": f"{shape.reduced_volume:g}"}
    values = {name: "" if np.isnan(value) else f"{value:.6f}" for name, value in numbers.items()}
    return key | values | {"unstable_orders": " ".join(map(str, unstable_orders(shape)))}


def main() -> None:
    rows = [row(reference_shape(c, branch, v), branch) for c, branch, v in ENTRIES]
    with (HERE / "reference.csv").open("w", newline="") as file:
        writer = csv.DictWriter(file, rows[0].keys(), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


if __name__ == "__main__":
    main()
