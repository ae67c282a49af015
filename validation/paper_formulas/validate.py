#!/usr/bin/python3
"""What a reader of Spendlove et al. (2021) would have got: the paper's geometry and the paper's coefficient 3/2."""

import importlib.util
import json
import sys
from pathlib import Path

import numpy

HERE = Path(__file__).resolve().parent
FOLDERS = HERE.parent
sys.path.insert(0, str(FOLDERS.parent / "tools"))

from validation.harmonics import decay_rate, relaxation_rate
from validation.item import Item
from validation.shapes_at_rest import at_rest, bending_time, pressure_jump, rest_case
from validation.simulations import Simulation

NU = 1 / 4
THREE_HALVES = {"vesicle_type.vesicle.bending.form": "paper", "vesicle_type.vesicle.bending.laplacian_coefficient": 1.5}
PAPER_GEOMETRY = {"numerics.geometry": "paper"}
WAYS = {
    "defaults": {},
    "paper's geometry": PAPER_GEOMETRY,
    "coefficient 3/2": THREE_HALVES,
    "both": {**PAPER_GEOMETRY, **THREE_HALVES},
}
SHAPES = (("discocyte", 0.667, 15), ("discocyte", 0.8, 15), ("prolate", 0.8, 15))
DROP = {"radius": 10, "sigma": 0.01, "box": 40, "steps": 6000}
SPHERE = {"radius": 12.0, "kappa": 0.2, "nu": 0.5, "box": 56, "steps": 3000}
CURVED = [(-2.0, "oblate", 0.8), (1.0, "oblate", 0.667), (2.0, "prolate", 0.8)]
OBLATE = {"v": (0.70, 0.80), "radius": 10, "kappa": 0.5, "bending_times": 8}


def label(way, what):
    return f"{way.replace(chr(39), '').replace(' ', '-').replace('/', '-')}-{what}"


def rest_name(way, shape, v, radius):
    return label(way, f"{shape}-v{v:.3f}-R{radius}")


def planned_at_rest(shapes, ways, bending_times):
    return [rest_case(FOLDERS / "rest_shapes" / "rest.toml", rest_name(way, shape, v, radius), shape, v, radius, bending_times,
                      kappa=radius / 20, nu=NU, settings=settings)
            for shape, v, radius in sorted(shapes, key=lambda s: -s[2]) for way, settings in ways.items()]  # fmt: skip


def planned_drops():
    box, steps = DROP["box"], DROP["steps"]
    return [Simulation(label(way, "drop"), FOLDERS / "drops" / "drop.toml", {
        "lattice.size": [box] * 3, "vesicle[0].centre": [box / 2] * 3, "vesicle[0].radius": DROP["radius"],
        "vesicle_type.drop.tension.sigma": DROP["sigma"], "run.steps": steps, "output.fields.every": steps,
        "output.surfaces.every": steps, **WAYS[way]}) for way in ("defaults", "paper's geometry")]  # fmt: skip


def planned_spheres():
    box, steps = SPHERE["box"], SPHERE["steps"]

    def sphere(name, kappa, settings):
        return Simulation(name, FOLDERS / "quasi_spherical" / "sphere.toml", {
            "lattice.size": [box] * 3, "vesicle[0].centre": [box / 2] * 3, "vesicle[0].radius": SPHERE["radius"],
            "vesicle[0].perturbation[0].l": 2, "vesicle[0].perturbation[0].amplitude": 0.03,
            "vesicle_type.vesicle.bending.modulus": kappa, "fluid.kinematic_viscosity": SPHERE["nu"],
            "run.steps": steps, "output.surfaces.every": steps // 10, **settings})  # fmt: skip

    return [sphere("no-membrane-sphere", 0.0, {}),
            *(sphere(label(way, "sphere"), SPHERE["kappa"], settings) for way, settings in WAYS.items())]  # fmt: skip


def planned_oblates():
    return [rest_case(FOLDERS / "stability" / "oblate.toml", label(way, f"oblate-v{v:g}"), "discocyte", v, OBLATE["radius"],
                      OBLATE["bending_times"], kappa=OBLATE["kappa"], nu=NU,
                      settings={"output.metrics.every": 50, **settings})
            for v in OBLATE["v"] for way, settings in WAYS.items()]  # fmt: skip


def rest_table(item, finished, shapes, ways):
    rows = []
    for shape, v, radius in shapes:
        for way in ways:
            run = finished[rest_name(way, shape, v, radius)]
            if run.failure is not None:
                rows.append((f"{shape} v = {v}", radius, way, "ended early: " + run.failure))
                continue
            rest = at_rest(run, shape)
            if rest is None:
                rows.append((f"{shape} v = {v}", radius, way, run.last("reduced_volume"), run.last("bending_energy"),
                             "no such shape in theory"))  # fmt: skip
                continue
            if way == "defaults":
                item.results.absolute("energy error with the defaults", f"{shape} v = {v}, R0 = {radius}",
                                      rest.energy_error(), 0.0, 0.01)  # fmt: skip
            speed = numpy.linalg.norm([run.last(c) for c in ("vx", "vy", "vz")])
            rows.append((f"{shape} v = {v}", radius, way, rest.v, rest.energy, 100 * rest.energy_error(), rest.rms,
                         rest.thickness / rest.exact_thickness, rest.tension / rest.exact_tension,
                         rest.pressure / rest.exact_pressure, rest.total_gaussian_curvature, speed))  # fmt: skip
    item.results.table(
        "Exact shapes after two bending times" if not item.quick else "An exact shape after one bending time",
        ("shape", "R0", "formulas", "v", "E", "against Helfrich's E at this v, %", "rms distance from Helfrich's shape, cells",
         "axis thickness over Helfrich's", "tension over Helfrich's", "pressure jump over Helfrich's", "int K dA over 4 pi", "speed of the vesicle, cells per step"), rows)  # fmt: skip


def drop_table(item, finished):
    rows = []
    for way in ("defaults", "paper's geometry"):
        run = finished[label(way, "drop")]
        radius = (3 * run.last("volume") / (4 * numpy.pi)) ** (1 / 3)
        error = pressure_jump(run) / (2 * DROP["sigma"] / radius) - 1
        rows.append((way, 100 * error, run.last("max_speed") / 6 / DROP["sigma"]))
    item.results.table(f"A drop at rest, R = {DROP['radius']}",
                       ("geometry", "p_in - p_out against 2 sigma/R, %", "spurious Ca"), rows)  # fmt: skip


def sphere_table(item, finished):
    def rate(name):
        last = SPHERE["steps"]
        return decay_rate(finished[name], 2, 0.3 * last, last)

    without = rate("no-membrane-sphere")
    theory = relaxation_rate(2, SPHERE["kappa"], 0.0, SPHERE["radius"], SPHERE["nu"])
    rows = [(way, found, theory, found / theory) for way in WAYS for found in [rate(label(way, "sphere")) - without]]
    item.results.table(
        f"Decay of l = 2 on a sphere of R = {SPHERE['radius']:g} in a box of {SPHERE['box']} cells, whose images slow it",
        ("formulas", "rate per step", "Helfrich's membrane without images", "ratio"), rows)  # fmt: skip


def oblate_table(item, finished):
    time = bending_time(OBLATE["radius"], OBLATE["kappa"], NU)
    rows = []
    for v, way in ((v, way) for v in OBLATE["v"] for way in WAYS):
        run = finished[label(way, f"oblate-v{v:g}")]
        if run.failure is not None:
            rows.append((v, way, "ended early: " + run.failure))
            continue
        steps = run.metrics["step"]
        ellipse = (run.metrics["inertia_2"] - run.metrics["inertia_1"]) / run.metrics["inertia_3"]
        chosen = (steps >= 2 * time) & (steps <= 8 * time) & (ellipse > 0)
        rate = float(numpy.polyfit(steps[chosen], numpy.log(ellipse[chosen]), 1)[0]) * time if chosen.sum() > 2 else numpy.nan
        rows.append((v, way, rate, float(ellipse[0]), float(ellipse[-1]), run.last("reduced_volume")))
    item.results.table(
        f"A 2 % ellipse in the plane of an oblate, R0 = {OBLATE['radius']}, {OBLATE['bending_times']} bending times",
        ("v asked for", "formulas", "growth per bending time", "(I2 - I1)/I3 at first", "at last", "v at last"), rows)  # fmt: skip


def spontaneous_curvature():
    """The validation of that name, as a module: shapes, runs and comparison are its own."""
    folder = FOLDERS / "spontaneous_curvature"
    sys.path.append(str(folder))
    description = importlib.util.spec_from_file_location("spontaneous_curvature", folder / "validate.py")
    module = importlib.util.module_from_spec(description)
    description.loader.exec_module(module)
    return module


def curved_table(item, module, plans, finished):
    rows = []
    for (c0, branch, v), (shape, simulation) in plans.items():
        run = finished[simulation.name]
        name = f"C0 R_A = {c0:g}, {branch}, v = {v:g}"
        if run.failure is not None:
            rows.append((name, "ended early: " + run.failure))
            continue
        rows.append((name, *module.compared(run, shape, c0, branch, v)))
    item.results.table(
        "Spontaneous curvature with the paper's geometry; the defaults stand in `spontaneous_curvature`",
        ("shape", "v", "C0 R_A", "E", "E exact", "rms, cells", "sigma R_A²/kappa", "exact", "Δp R_A³/kappa", "exact"), rows)  # fmt: skip


def numerics_table(item):
    """What `numerics` found on exact layers, with the defaults and with the paper's formulas."""
    path = FOLDERS / "numerics" / "results.json"
    if not path.is_file():
        item.results.note("The laws on exact layers are missing: run `validation/numerics/validate.py` first.")
        return
    wanted = ("bending force on the torus", "net force", "48 symmetries", "flat membrane")
    rows = [(row["law"], row["conditions"], row["measured"]) for row in json.loads(path.read_text("utf-8"))["rows"]
            if row["law"].startswith(wanted)]  # fmt: skip
    item.results.table("The laws that differ, from `numerics`", ("law", "conditions", "measured"), rows)


def main():
    item = Item(__file__, "The paper's formulas beside the defaults")
    shapes = (("discocyte", 0.667, 10),) if item.quick else SHAPES
    ways = dict(list(WAYS.items())[:2]) if item.quick else WAYS
    simulations = planned_at_rest(shapes, ways, 1 if item.quick else 2)
    if not item.quick:
        module = spontaneous_curvature()
        plans = module.planned(item, CURVED, "-papers-geometry", PAPER_GEOMETRY)
        simulations += [*planned_spheres(), *planned_oblates(), *planned_drops(), *(s for _, s in plans.values())]
    finished = item.run(simulations)
    rest_table(item, finished, shapes, ways)
    if not item.quick:
        drop_table(item, finished)
        sphere_table(item, finished)
        oblate_table(item, finished)
        curved_table(item, module, plans, finished)
        numerics_table(item)
    item.finish()


if __name__ == "__main__":
    main()
