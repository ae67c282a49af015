#!/usr/bin/python3
"""What accuracy costs: error of a discocyte's energy against resolution and run time, and what could lower it."""

import sys
from pathlib import Path

import numpy

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))

from validation.item import Item
from validation.shapes_at_rest import at_rest, bending_time, rest_case

CASE = Path(__file__).parents[1] / "rest_shapes" / "rest.toml"
V = 0.667
NU = 1 / 4
RADII = (8, 9, 10, 12, 15)
WANTED = 0.03
WAYS = {
    "mapped, double": {},
    "mapped, single": {"numerics.precision": "single"},
    "paper, double": {"numerics.geometry": "paper"},
}
REMEDIES = {
    "defaults": {},
    "beta 0.50": {"fluid.segregation": 0.50},
    "beta 0.60": {"fluid.segregation": 0.60},
    "beta 0.70": {"fluid.segregation": 0.70},
    "cutoff 0.1": {"numerics.cutoff": 0.1},
    "cutoff 0.001": {"numerics.cutoff": 1e-3},
}
REMEDY_RADII = (8, 9, 10, 12)
SHARPEST_BEND = 0.37  # smallest radius of curvature of the shape, over R0


def modulus(radius):
    """Keeps the compression by the membrane alike; tau_b grows with R0^2."""
    return radius / 20


def case(name, radius, settings):
    return rest_case(CASE, name, "discocyte", V, radius, 2, kappa=modulus(radius), nu=NU, settings=settings)


def resolved(settings, radius):
    """The program takes no bend whose radius is below two widths 1/beta of the layer."""
    return settings.get("fluid.segregation", 0.67) * SHARPEST_BEND * radius >= 1.95


def label(way, radius):
    return f"{way.replace(', ', '-').replace(' ', '-')}-R{radius}"


def main():
    item = Item(__file__, "The cost of accuracy")
    ways = {"mapped, double": {}} if item.quick else WAYS
    radii = (10,) if item.quick else RADII
    simulations = [case(label(way, r), r, settings) for r in reversed(radii) for way, settings in ways.items()]
    if not item.quick:
        simulations += [case(label(remedy, r), r, settings) for r in REMEDY_RADII
                        for remedy, settings in REMEDIES.items() if settings and resolved(settings, r)]  # fmt: skip
    finished = item.run(simulations)

    def rest_of(name):
        run = finished[name]
        return None if run.failure else at_rest(run, "discocyte")

    def kept(rest):
        """Where the faces of the thin centre are too few cells apart their layers merge, and the disc becomes a ring."""
        return rest is not None and rest.rms < 0.15 and abs(rest.total_gaussian_curvature - 1.0) < 0.15

    rows = []
    errors = {}
    for way in ways:
        for r in radii:
            name = label(way, r)
            rest, run = rest_of(name), finished[name]
            tau = bending_time(r, modulus(r), NU)
            per_bending_time = run.seconds * tau / run.steps()
            if not kept(rest):
                rows.append((way, r, round(tau), per_bending_time, "lost its shape"))
                continue
            errors[way, r] = rest.energy_error()
            rows.append((way, r, round(tau), per_bending_time, rest.v, 100 * rest.energy_error(), rest.rms,
                         100 * (rest.thickness / rest.exact_thickness - 1), rest.total_gaussian_curvature))  # fmt: skip
    item.results.table(
        f"A discocyte of v = {V} after two bending times; theory at the run's own v",
        ("geometry, precision", "R0", "tau_b in steps", "seconds per tau_b, one core", "v", "error of E, %", "rms, cells",
         "error of the axis thickness, %", "int K dA over 4 pi"), rows)  # fmt: skip
    base = [(r, abs(errors["mapped, double", r])) for r in radii if ("mapped, double", r) in errors]
    if item.quick:
        item.results.at_most("error of E", "R0 = 10", base[0][1], 0.05)
        item.finish()
    order = -numpy.polyfit(numpy.log([r for r, _ in base]), numpy.log([e for _, e in base]), 1)[0]
    item.results.at_least("order of convergence of E, mapped", f"R0 = {base[0][0]} to {base[-1][0]}", order, 1.6)
    for way in ways:
        enough = [r for r in radii if all(abs(errors.get((way, q), 1.0)) <= WANTED for q in radii if q >= r)]
        item.results.report(f"smallest R0 of those run from which on E is within {100 * WANTED:g} %", way,
                            min(enough, default=float("nan")))  # fmt: skip
    for r in radii:
        if ("mapped, single", r) in errors and ("mapped, double", r) in errors:
            item.results.absolute("E in single less E in double, relative", f"R0 = {r}",
                                  errors["mapped, single", r] - errors["mapped, double", r], 0.0, 1e-3)  # fmt: skip

    remedies = []
    for remedy in REMEDIES:
        row = [remedy]
        for r in REMEDY_RADII:
            name = label("mapped, double" if remedy == "defaults" else remedy, r)
            rest = rest_of(name) if name in finished else None
            row += [100 * rest.energy_error(), rest.rms] if kept(rest) else ["refused" if name not in finished else "lost", ""]
        remedies.append(row)
    item.results.table("What could lower the error: wider or sharper layers, larger or smaller cutoffs",
                       ("changed", *(f"{what}, R0 = {r}" for r in REMEDY_RADII for what in ("error of E, %", "rms"))),
                       remedies)  # fmt: skip
    item.finish()


if __name__ == "__main__":
    main()
