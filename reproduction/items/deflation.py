"""Fig 1: the sphere, and the discocyte it becomes when its membrane gains area."""

import math

import numpy

from drawing import frame_from, paint
from runs import DEFLATION, discocyte, sphere_volume
from shape_class import classify
from shared import BRANCH_OF, HelfrichShapes, compare, fold, read_surface, surface_files

TITLE = "A sphere deflated to a bicuspid vesicle (Fig 1)"
PAPER = "Two pictures: the sphere, and the bicuspid vesicle of area A0 = 1.31 A_sphere. No times and no numbers besides."


def plan(quick):
    return [discocyte(quick)]


def explain_path(item):
    item.choose("bending form", "helfrich", "the paper prints two coefficients of the Laplacian (Eqs 13, 32); only 1/2 has an energy. Table V runs both")
    item.choose("area constraint, alpha", "multiplier, A_target ramped over 5.3 tau_b",
                "alpha is not given. A jump of A0 buckles a sphere wherever K_A > 50 kappa/R^2; a ramp longer than 5 tau_b keeps the "
                "shape smooth, and a multiplier makes the final area exactly Upsilon A_sphere. Table V runs the jump")  # fmt: skip
    item.choose("perturbation of the sphere", "l = 2, m = 0, amplitude -1 %", "a perfect sphere has nothing to grow from; the sign chooses oblate over prolate")
    item.choose("nu, rho, ghost rates", "1/12, 1, regularised", "tau_b = eta R^3/kappa is then 4,500 steps; at rest neither matters to the shape")
    item.choose("lattice", "64 x 64 x 48", "9 cells beyond the sphere and 10 beyond the rim")


def judge(item, finished):
    run = next(iter(finished.values()))
    explain_path(item)
    if run.failure is not None:
        return
    metrics, last = run.metrics, run.surface()
    radius = run.run.resolved["vesicle"][0]["radius"]
    radius = float(radius if not isinstance(radius, dict) else radius["lattice"])
    time = run.run.bending_time(0, sphere_volume(radius))
    first_area = 4 * math.pi * radius**2
    paper, theory = item.against("paper"), item.against("theory")
    paper.relative("A/A_sphere at the end", f"R = {radius:g}", run.last("area") / first_area, DEFLATION, 0.002)
    shape = classify(last)
    paper.absolute("the shape is oblate without a hole (1: yes)", f"R = {radius:g}", float(shape.letter == "A" and shape.genus == 0), 1.0, 0.0)
    shapes = HelfrichShapes()
    v, volume = run.last("reduced_volume"), run.last("volume")
    exact = shapes.profile(BRANCH_OF["discocyte"], v)
    within = 0.05 if item.quick else 0.01
    theory.relative("bending energy over 8 pi kappa against Helfrich's oblate", f"v = {v:.4f}", run.last("bending_energy"), float(shapes.energy("oblate", v)), within)  # fmt: skip
    found = compare(fold(last), "oblate", exact.of_volume(volume))
    theory.at_most("distance from Helfrich's profile, rms, cells", f"v = {v:.4f}", found.rms, 0.2 if item.quick else 0.05)
    theory.relative("colour mass, end over start", f"{run.steps()} steps", 1 + run.last("mass_drift"), 1.0, 1e-10)
    _history(item, metrics, time, first_area)
    files = surface_files(run)
    chosen = [files[k] for k in _moments(metrics, [s for s, _ in files], first_area)]
    item.picture("deflation.png", _pictures(chosen, time), "From the sphere to the discocyte: times in steps and bending times "
                 "tau_b = eta R^3/kappa. Seen from 25 degrees above the equator; the last one semi-transparent, as the paper's.")  # fmt: skip


def _moments(metrics, steps, first_area):
    """Surfaces spread over the growth of the area, not over time: the first, four between, the last."""
    areas = numpy.interp(steps, metrics["step"], metrics["area"] / first_area)
    wanted = numpy.linspace(1.0, areas.max(), 5)[1:-1]
    between = [int(numpy.argmax(areas >= w)) for w in wanted]
    settled = int(numpy.argmax(areas >= 0.999 * areas.max()))
    return list(dict.fromkeys([0, *between, settled, len(steps) - 1]))


def _history(item, metrics, time, first_area):
    item.csv("history.csv", ("step", "time in tau_b", "area over that of the sphere", "reduced volume", "bending energy over 8 pi kappa",
                             "inertia_1", "inertia_2", "inertia_3"),
             [(int(s), s / time, a / first_area, v, e, *i) for s, a, v, e, *i in
              zip(*(metrics[n][::5] for n in ("step", "area", "reduced_volume", "bending_energy", "inertia_1", "inertia_2", "inertia_3")))])  # fmt: skip


def _pictures(chosen, time):
    from matplotlib import pyplot

    columns = min(3, len(chosen))
    rows = math.ceil(len(chosen) / columns)
    figure, panels = pyplot.subplots(rows, columns, figsize=(7.2, 2.4 * rows), constrained_layout=True, squeeze=False)
    frame = frame_from((math.cos(math.radians(25)), 0.0, math.sin(math.radians(25))))
    for axes in panels.flat:
        axes.axis("off")
    limit = None
    for axes, (step, path) in zip(panels.flat, chosen):
        surface = read_surface(path)
        paint(axes, surface, frame, alpha=0.55 if step == chosen[-1][0] else 1.0)
        axes.set_title(f"step {step}: {step / time:.1f} " + r"$\tau_b$", fontsize=9)
        limit = max(limit or 0.0, axes.get_xlim()[1])
    for axes in panels.flat:
        axes.set_xlim(-limit, limit)
        axes.set_ylim(-0.8 * limit, 0.8 * limit)
    return figure
