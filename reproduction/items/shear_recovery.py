"""Fig 8: eigenvalues of inertia of a discocyte that is sheared from step 40,000 to 80,000 and then left alone."""

import numpy

from runs import DEFLATION, RADIUS
from shared import OWN_CASES, Simulation

TITLE = "Eigenvalues in shear and after it (Fig 8)"
PAPER = ("kappa_B = 1, sigma = 1e-5, beta = .6, Upsilon = 1.31, R = 15, 75^3: shear from 40,000 to 80,000 steps, eigenvalues back by 110,000, "
         "area within .1 % throughout. The curves have no table, the rate is not given.")  # fmt: skip
CASE = OWN_CASES / "shear.toml"
RATE, NU, RAMP = 4e-4, 1 / 6, 12000
START, STOP, END = 40000, 80000, 110000


def times(quick):
    return (200, 600, 2000) if quick else (START, STOP, END)


def plan(quick):
    start, stop, end = times(quick)
    radius, size = (10.0, [44, 36, 44]) if quick else (RADIUS, [75, 75, 75])
    return [Simulation("shear-recovery" + ("-quick" if quick else ""), CASE, {
        "lattice.size": size, "vesicle[0].centre": [size[0] / 2, (size[1] // 2) + 0.5, size[2] / 2], "vesicle[0].radius": radius, "vesicle[0].reduced_volume": 0.65 if quick else DEFLATION**-1.5,
        "fluid.kinematic_viscosity": NU, "fluid.segregation": 0.6,
        "vesicle_type.cell.bending.modulus": 0.5 if quick else 0.25, "vesicle_type.cell.tension.sigma": 1e-5,
        "flow.shear.rate": 5e-4 if quick else RATE, "flow.shear.start": start, "flow.shear.stop": stop,
        "numerics.precision": "single", "run.steps": end, "output.metrics.every": end // 220 if quick else 200,
        "output.surfaces.every": 200 if quick else 10000, "output.fields.every": 0, "output.checkpoint.every": end // 10,
    })]  # fmt: skip


def choices(item):
    item.choose("shear rate", f"{RATE:g}", "not given; walls at +-.015, Ca_kappa = .9: well deformed, and steady long before step 80,000. Not fitted to any curve")
    item.choose("direction", "axis along the vorticity, walls across z", "as in Figs 6 and 7; 'perpendicular to the axis'")
    item.choose("start", "the exact discocyte, 40,000 steps at rest", "the paper deflates a sphere for as long; the shape is the same (Fig 5), and 18 bending times settle it")
    item.choose("nu, precision", "1/6, single", "not given; single precision halves the time")


def judge(item, finished):
    run = next(iter(finished.values()))
    start, stop, end = times(item.quick)
    choices(item)
    if run.failure is not None:
        return
    paper, metrics = item.against("paper"), run.metrics
    names = ("inertia_1", "inertia_2", "inertia_3")

    def near(step, column):
        return float(metrics[column][int(numpy.argmin(abs(metrics["step"] - step)))])

    before = [near(start, n) for n in names]
    for k, name in enumerate(names):
        paper.relative(f"eigenvalue {k + 1} at the end over that before the shear", f"step {end}", near(end, name) / before[k], 1.0, 0.1 if item.quick else 0.01)
        item.results.report(f"eigenvalue {k + 1} in shear over that before", f"step {stop}", near(stop, name) / before[k])
    settled = metrics["step"] >= start
    area = metrics["area"][settled]
    paper.at_most("fluctuation of the area, relative, %", f"from step {start} on", 100 * float(numpy.ptp(area) / area.mean()), 0.5 if item.quick else 0.1)
    paper.at_least("largest change of an eigenvalue in shear", "it does deform", max(abs(near(stop, n) / b - 1) for n, b in zip(names, before)), 0.001 if item.quick else 0.02)
    item.csv("inertia.csv", ("step", *names, "deformation_index", "area_ratio"),
             [(int(s), *map(float, rest)) for s, *rest in zip(*(metrics[n] for n in ("step", *names, "deformation_index", "area_ratio")))])  # fmt: skip
    item.picture("recovery.png", _figure(metrics, start, stop), "Eigenvalues over time; dashed while the shear is on, as in the paper.")


def _figure(metrics, start, stop):
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(figsize=(7.0, 4.0), constrained_layout=True)
    step = metrics["step"]
    for k, colour in enumerate(("#0072B2", "#D55E00", "#009E73")):
        values = metrics[f"inertia_{k + 1}"] / 1e6
        for chosen, style in ((step <= start, "-"), ((step >= start) & (step <= stop), "--"), (step >= stop, "-")):
            axes.plot(step[chosen], values[chosen], style, color=colour, label=rf"$\lambda_{k + 1}$" if style == "--" else None)
    axes.set_xlabel("time (steps)")
    axes.set_ylabel(r"eigenvalue $\times 10^{-6}$")
    axes.legend()
    return figure
