#!/usr/bin/python3
"""Helfrich's rest shapes: energies, sizes, inertia, tension and pressure of exact shapes left to themselves."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))

from validation.item import Item
from validation.shapes_at_rest import at_rest, rest_case

CASE = Path(__file__).with_name("rest.toml")
OBLATES = (0.75, 0.70, 0.667, 0.65, 0.60)
SADDLES = (0.95, 0.90, 0.80)  # oblates unstable to m = 2: kept by the lattice's symmetry
PROLATES = (0.95, 0.90, 0.80, 0.70, 0.667, 0.65, 0.60)
RESOLVED = (0.80, 0.667)  # at R0 = 15 and 30 as well
# Published for axisymmetric Helfrich shapes: E/(8 pi kappa) at these reduced volumes.
PUBLISHED = {
    ("discocyte", 0.95): 1.1061, ("discocyte", 0.90): 1.2179, ("discocyte", 0.80): 1.4525,
    ("discocyte", 0.70): 1.6991, ("discocyte", 0.667): 1.7829, ("discocyte", 0.65): 1.8262,
    ("discocyte", 0.60): 1.9557, ("prolate", 0.95): 1.0956, ("prolate", 0.90): 1.1896,
    ("prolate", 0.80): 1.3874, ("prolate", 0.70): 1.6433, ("prolate", 0.667): 1.7602,
    ("prolate", 0.65): 1.8279, ("prolate", 0.60): 2.0603, ("stomatocyte", 0.60): 1.9774,
}  # fmt: skip
INERTIA = {"discocyte": (0.5097, 0.5097, 0.9333), "prolate": (0.1566, 1.8235, 1.8235)}  # at v = .667, over M R0^2


def planned(quick):
    """Name -> (shape, v, R0, Simulation)."""
    wanted = {}

    def add(shape, v, radius, kappa, nu, bending_times=2.0, tag="", settings=None):
        name = f"{shape}-v{v:.3f}-R{radius:g}{tag}"
        wanted[name] = (shape, v, radius, rest_case(CASE, name, shape, v, radius, bending_times, kappa=kappa, nu=nu,
                                                    settings=settings))  # fmt: skip

    if quick:
        add("discocyte", 0.667, 12, 0.4, 1 / 6, bending_times=1.0)
        return wanted
    for v in SADDLES + OBLATES:  # close to a sphere the area's controller has little to hold on to, and takes its time
        add("discocyte", v, 20, 1.0, 1 / 4, bending_times=2.0 if v < 0.95 else 4.0)
    for v in PROLATES:
        add("prolate", v, 20, 1.0, 1 / 4, bending_times=2.0 if v < 0.95 else 4.0)
    add("stomatocyte", 0.60, 21, 1.0, 1 / 4)  # at R0 = 20 its rim is too sharp for the program to accept
    # Other kappa and nu; tau_b is a third longer in both.
    add("discocyte", 0.667, 20, 1.5, 1 / 2, tag="-kappa1.5-nu0.5")
    add("discocyte", 0.667, 20, 0.5, 1 / 6, tag="-kappa0.5-nu0.167")
    for shape in ("discocyte", "prolate"):
        for v in RESOLVED:
            add(shape, v, 15, 0.5, 1 / 4)
    # The stomatocyte's mouth has a radius of .11 R_A, 2.7 cells at R0 = 21: the layers of its rim meet in it.
    single = {"numerics.precision": "single"}  # half the time, and the same energies: see the cost of accuracy
    for shape in ("discocyte", "prolate"):
        for v in RESOLVED:
            add(shape, v, 30, 3.375, 1 / 4, settings=single)
    add("stomatocyte", 0.60, 30, 2.25, 1 / 4, settings=single)
    add("discocyte", 0.60, 30, 3.375, 1 / 4, settings=single)  # its centre is 5.9 cells thick at R0 = 20: the layers of its faces overlap
    return wanted


def main():
    item = Item(__file__, "Rest shapes against Helfrich's theory")
    wanted = planned(item.quick)
    finished = item.run([entry[3] for entry in wanted.values()])
    results = item.results
    found = {}
    for name, (shape, v, radius, _) in wanted.items():
        if finished[name].failure is not None:
            continue
        rest = at_rest(finished[name], shape)
        if rest is None:
            results.at_most("a shape that theory knows", name, float("nan"), 0.0)
            continue
        found[name] = rest
        judge(results, name, shape, v, radius, rest)
    if not item.quick:
        compare_runs(results, found)
    results.table(
        "At rest after two bending times: run and theory at the run's own reduced volume",
        ("run", "v", "E", "E exact", "error %", "rms cells", "r_max", "exact", "height", "exact", "axis thickness",
         "exact", "sigma R_A²/kappa", "exact", "Δp R_A³/kappa", "exact"),
        [(name, r.v, r.energy, r.exact_energy, 100 * r.energy_error(), r.rms, r.r_max, r.exact_r_max, r.height,
          r.exact_height, r.thickness, r.exact_thickness, r.tension, r.exact_tension, r.pressure, r.exact_pressure)
         for name, r in found.items()],
    )  # fmt: skip
    item.finish()


def judge(results, name, shape, v, radius, rest):
    """Targets hold from R0 = 20 on; below, numbers are reported."""
    if radius < 20:
        results.report("energy, relative error", name, rest.energy_error())
        results.report("distance from the exact profile, rms cells", name, rest.rms)
        if radius < 15:  # the quick subset: wide enough for its resolution, narrow enough to fail on a mistake
            results.absolute("energy, relative error", name, rest.energy_error(), 0.0, 0.03)
            results.at_most("distance from the exact profile, rms cells", name, rest.rms, 0.15)
        return
    results.relative("energy at the run's own v", name, rest.energy, rest.exact_energy, 0.005)
    if (shape, v) in PUBLISHED:
        # The fluid inside gives way a little under the membrane's pressure, so v is not quite what was asked for.
        results.absolute("reduced volume against the one asked for", name, rest.v, v, 0.005)
        results.relative("energy published for the v asked for", name, rest.energy, PUBLISHED[shape, v], 0.01)
    results.at_most("distance from the exact profile, rms cells", name, rest.rms, 0.1)
    results.relative("largest radius over R_A", name, rest.r_max, rest.exact_r_max, 0.02)
    results.relative("total height over R_A", name, rest.height, rest.exact_height, 0.02)
    results.relative("thickness on the axis over R_A", name, rest.thickness, rest.exact_thickness, 0.02)
    results.absolute("departure from axial symmetry", name, rest.asymmetry, 0.0, 0.01)
    results.relative("int K dA over 4 pi", name, rest.total_gaussian_curvature, 1.0, 0.005)
    results.absolute("area over its target - 1", name, rest.area_error, 0.0, 1e-4)
    results.relative("tension, sigma R_A^2/kappa", name, rest.tension, rest.exact_tension, 0.05)
    results.relative("pressure jump, dp R_A^3/kappa", name, rest.pressure, rest.exact_pressure, 0.05)
    if v == 0.667 and shape in INERTIA:
        for k, exact in enumerate(INERTIA[shape]):
            results.relative(f"moment of inertia {k + 1} over M R0^2", name, rest.inertia[k], exact, 0.03)


def compare_runs(results, found):
    for shape in ("discocyte", "prolate"):
        for v in RESOLVED:
            errors = [abs(found[f"{shape}-v{v:.3f}-R{r}"].energy_error()) for r in (15, 20, 30)
                      if f"{shape}-v{v:.3f}-R{r}" in found]  # fmt: skip
            if len(errors) == 3:
                results.at_most("energy error at R0 = 30 over that at 15", f"{shape} v = {v}", errors[2] / errors[0], 1.0)
    base = found.get("discocyte-v0.667-R20")
    for tag in ("-kappa1.5-nu0.5", "-kappa0.5-nu0.167"):
        other = found.get("discocyte-v0.667-R20" + tag)
        if base and other:
            results.absolute("energy error with other kappa and nu, less that with the usual ones", tag[1:],
                             other.energy_error() - base.energy_error(), 0.0, 0.002)  # fmt: skip


if __name__ == "__main__":
    main()
