"""Fig 6: the sheared discocyte's section with streaklines inside and outside, and the speed."""

import numpy
from scipy.interpolate import RegularGridInterpolator
from scipy.spatial import cKDTree

from items.shear_recovery import nearest
from raw_inertia import field_steps, last_field
from shared import read_surface, surface_files
from sheared import capillary, section, sheared

TITLE = "A sheared discocyte: section, streaklines, speed (Fig 6)"
PAPER = "One picture, DI = 29 %: outline, streaklines within and around it that follow it (the kinematic condition), a map of |u|."
PUBLISHED = 0.29
RADIUS, KAPPA, NU, RATE, STEPS, SIZE = 14.0, 0.2, 0.5, 1.16e-4, 14000, [72, 40, 72]
SAMPLE = 500  # steps between fields


def plan(quick):
    if quick:
        return [sheared("fig6-quick", radius=9.0, kappa=0.1, nu=0.5, rate=4e-4, steps=600, size=[40, 28, 40],
                        settings={"output.surfaces.every": 200, "vesicle[0].reduced_volume": 0.9})]  # fmt: skip
    return [sheared("fig6", radius=RADIUS, kappa=KAPPA, nu=NU, rate=RATE, steps=STEPS, size=SIZE,
                    settings={"output.fields.every": SAMPLE, "output.surfaces.every": SAMPLE, "output.metrics.every": 100})]  # fmt: skip


def judge(item, finished):
    name, run = next(iter(finished.items()))
    item.choose("shear rate", f"Ca_kappa = {capillary(RATE, RADIUS, KAPPA, NU):.1f}", "not given; slow enough for Re = .05 and fast enough for DI to pass 29 %")
    item.choose("moment", "when DI is nearest to 29 %", "in shear at this v the discocyte goes on towards a long ellipsoid; the paper's picture names DI, not a time")
    item.choose("viscosity ratio", "1", "the paper's collision knows one viscosity")
    item.choose("R, box, walls", f"{RADIUS:g}, {SIZE}, walls across z", "5 R between walls; the axis along the vorticity, as in the paper")
    if run.failure is not None:
        return
    step = run.steps() if item.quick else _moment(run)
    index, middle = nearest(run, step, "deformation_index"), nearest(run, step, "y")
    paper, theory = item.against("paper"), item.against("theory")
    if item.quick:
        paper.at_least("deformation index", "quick", index, 0.01)
    else:
        paper.absolute("deformation index", f"Ca = {capillary(RATE, RADIUS, KAPPA, NU):.1f}, step {step}", index, PUBLISHED, 0.01)
        item.results.report("deformation index at the end of the run", f"step {run.steps()}", run.last("deformation_index"))
    theory.absolute("A/A_target", "in shear", nearest(run, step, "area_ratio"), 1.0, 1e-3)
    item.results.report("inclination, degrees", "from the flow", nearest(run, step, "inclination"))

    velocity, phase = last_field(run, "velocity", step), last_field(run, "phase", step)
    plane = int(middle)  # the vesicle lies in the middle of a layer of cells
    u, w, inside = velocity[:, plane, :, 0], velocity[:, plane, :, 2], phase[:, plane, :]
    outline = section(read_surface(dict(surface_files(run))[step]), middle)
    others = [section(read_surface(dict(surface_files(run))[s]), middle) for s in _neighbours(run, step)]
    through, own = _through(outline, others, u, w, run)
    bound = 0.3 if item.quick else 0.05
    paper.at_most("the fluid's normal speed less the membrane's own, over the greatest tangential one", "kinematic condition, rms over the outline", through, bound)
    item.results.report("the membrane's own normal speed over the greatest tangential one", "it still deforms, rms", own)
    item.explain("The membrane still deforms at this moment, so its own normal speed is subtracted from the fluid's. What is left is "
                 f"{100 * through:.1f} % of the greatest tangential speed, and the bound is {100 * bound:g} %: where it comes from was not tested. The deformation index is {index:.3f} here and "
                 f"{run.last('deformation_index'):.3f} at the end of the run.")  # fmt: skip
    theory.at_most("speed out of the plane over the greatest, rms", "the plane of symmetry", float(numpy.sqrt((velocity[:, plane, :, 1] ** 2).mean()) / numpy.hypot(u, w).max()), 0.02)
    item.csv("outline.csv", ("x", "z"), [tuple(map(float, p)) for p in outline])
    item.csv("metrics.csv", ("step", "deformation_index", "inclination", "area_ratio"),
             [(int(s), float(d), float(i), float(a)) for s, d, i, a in zip(*(run.metrics[k][::2] for k in ("step", "deformation_index", "inclination", "area_ratio")))])  # fmt: skip
    item.picture("streaklines.png", _figure(u, w, inside, outline), "The section through the centre in the plane of the shear: outline (white), lines along the flow of this moment "
                 "outside (black) and inside (red), which in a steady flow are the streaklines, |u| as colour.")  # fmt: skip


def _moment(run):
    return min(field_steps(run), key=lambda s: abs(nearest(run, s, "deformation_index") - PUBLISHED))


def _interpolator(values):
    z, x = (numpy.arange(n) + 0.5 for n in values.shape)
    return RegularGridInterpolator((z, x), values, bounds_error=False, fill_value=None)


def _neighbours(run, step):
    """The surfaces written before and after."""
    steps = [s for s, _ in surface_files(run)]
    k = steps.index(step)
    return steps[max(0, k - 1)], steps[min(len(steps) - 1, k + 1)]


def _through(outline, others, u, w, run):
    """(normal speed of the fluid less that of the outline, of the outline alone), rms over the greatest tangential speed.
    The outline's own comes from where it was and will be."""
    places = outline[:, ::-1]
    speed = numpy.column_stack((_interpolator(u)(places), _interpolator(w)(places)))
    smooth = numpy.array([numpy.roll(outline, k, axis=0) for k in range(-3, 4)]).mean(axis=0)
    tangent = numpy.roll(smooth, -3, axis=0) - numpy.roll(smooth, 3, axis=0)
    tangent /= numpy.linalg.norm(tangent, axis=1, keepdims=True)
    normal = numpy.column_stack((tangent[:, 1], -tangent[:, 0]))
    steps = [s for s, _ in surface_files(run)]
    apart = (2 if len(others) == 2 and not numpy.array_equal(others[1], outline) else 1) * (steps[-1] - steps[-2])
    before, after = (_displacement(outline, normal, other) for other in others)
    own = (after - before) / apart
    along = numpy.abs((speed * tangent).sum(axis=1)).max()
    across = (speed * normal).sum(axis=1)
    return float(numpy.sqrt(((across - own) ** 2).mean()) / along), float(numpy.sqrt((own**2).mean()) / along)


def _displacement(outline, normal, other):
    """Along the normal, from each point to the nearest of the other outline, which is filled up with points."""
    closed = numpy.vstack((other, other[:1]))
    dense = numpy.concatenate([closed[:-1] + share * numpy.diff(closed, axis=0) for share in numpy.linspace(0.0, 0.9, 10)])
    _, nearest = cKDTree(dense).query(outline)
    return ((dense[nearest] - outline) * normal).sum(axis=1)


def _figure(u, w, phase, outline):
    from matplotlib import pyplot

    height, width = u.shape
    x, z = numpy.arange(width) + 0.5, numpy.arange(height) + 0.5
    figure, axes = pyplot.subplots(figsize=(7.0, 5.4), constrained_layout=True)
    shown = axes.imshow(numpy.hypot(u, w), origin="lower", extent=(0, width, 0, height), cmap="viridis", interpolation="bilinear")
    for chosen, colour, density in ((phase < 0.0, "black", 1.4), (phase >= 0.0, "#ff6655", 2.2)):
        axes.streamplot(x, z, numpy.ma.array(u, mask=~chosen), numpy.ma.array(w, mask=~chosen), color=colour, density=density, linewidth=0.6, arrowsize=0.6)
    closed = numpy.vstack((outline, outline[:1]))
    axes.plot(closed[:, 0], closed[:, 1], color="white", linewidth=1.5)
    axes.grid(False)
    axes.set_xlim(0, width)
    axes.set_ylim(0, height)
    axes.set_xlabel("x (cells), along the flow")
    axes.set_ylabel("z (cells), along its gradient")
    figure.colorbar(shown, ax=axes, label="|u|, cells per step", shrink=0.8)
    return figure
