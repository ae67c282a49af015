#!/usr/bin/python3
"""What a reader of Spendlove et al. (2021) would have got: the paper's geometry and the paper's coefficient 3/2."""

import sys
from pathlib import Path

import numpy

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))

from validation.item import Item
from validation.shapes_at_rest import at_rest, rest_case

CASE = Path(__file__).parents[1] / "rest_shapes" / "rest.toml"
NU = 1 / 4
THREE_HALVES = {"vesicle_type.vesicle.bending.form": "paper", "vesicle_type.vesicle.bending.laplacian_coefficient": 1.5}
WAYS = {
    "defaults": {},
    "paper's geometry": {"numerics.geometry": "paper"},
    "coefficient 3/2": THREE_HALVES,
    "both": {"numerics.geometry": "paper", **THREE_HALVES},
}
SHAPES = (("discocyte", 0.667, 15), ("discocyte", 0.667, 20), ("discocyte", 0.8, 15), ("prolate", 0.8, 15),
          ("prolate", 0.8, 20))  # fmt: skip


def name_of(way, shape, v, radius):
    return f"{way.replace(chr(39), '').replace(' ', '-').replace('/', '-')}-{shape}-v{v:.3f}-R{radius}"


def main():
    item = Item(__file__, "The paper's formulas beside the defaults")
    shapes = (("discocyte", 0.667, 10),) if item.quick else SHAPES
    ways = dict(list(WAYS.items())[:2]) if item.quick else WAYS
    planned = {}
    for shape, v, radius in sorted(shapes, key=lambda s: -s[2]):
        for way, settings in ways.items():
            planned[way, shape, v, radius] = rest_case(
                CASE, name_of(way, shape, v, radius), shape, v, radius, 2 if not item.quick else 1,
                kappa=radius / 20, nu=NU, settings=settings)  # fmt: skip
    finished = item.run(planned.values())

    rows = []
    errors = {}
    for shape, v, radius in shapes:
        for way in ways:
            run = finished[name_of(way, shape, v, radius)]
            if run.failure is not None:
                rows.append((f"{shape} v = {v}", radius, way, "ended early: " + run.failure))
                continue
            rest = at_rest(run, shape)
            errors[way, shape, v, radius] = rest.energy_error()
            speed = numpy.linalg.norm([run.last(c) for c in ("vx", "vy", "vz")])
            rows.append((f"{shape} v = {v}", radius, way, rest.v, rest.energy, 100 * rest.energy_error(), rest.rms,
                         rest.thickness / rest.exact_thickness, speed))  # fmt: skip
    item.results.table(
        "Exact shapes after two bending times" if not item.quick else "An exact shape after one bending time",
        ("shape", "R0", "formulas", "v", "E", "against Helfrich's E at this v, %", "rms distance from Helfrich's shape, cells",
         "axis thickness over Helfrich's", "speed of the vesicle, cells per step"), rows)  # fmt: skip
    for (way, shape, v, radius), error in errors.items():
        if way == "defaults":
            item.results.absolute("energy error with the defaults", f"{shape} v = {v}, R0 = {radius}", error, 0.0,
                                  0.01 if radius >= 20 else 0.04)  # fmt: skip
    item.finish()


if __name__ == "__main__":
    main()
