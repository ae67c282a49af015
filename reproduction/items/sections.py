"""Fig 2: the oblate's section at three resolutions, scaled to one diameter."""

import numpy

from items.grid_convergence import sphere_runs
from shared import HelfrichShapes, compare, fold

TITLE = "Sections of the oblate at three resolutions (Fig 2)"
PAPER = "Three sections, R = 15, 17.5, 22.5, scaled to one diameter, that lie on each other to the eye."


def plan(quick):
    return list(sphere_runs(quick).values())


def judge(item, finished):
    item.choose("kappa_B, sigma, path", "as in Table III", "the same runs")
    theory, paper = item.against("theory"), item.against("paper")
    sections, rows = {}, []
    for radius, simulation in sphere_runs(item.quick).items():
        run = finished[simulation.name]
        if run.failure is not None:
            continue
        folded = fold(run.surface())
        v = run.last("reduced_volume")
        exact = compare(folded, "oblate", HelfrichShapes().profile("oblate", v).of_volume(run.last("volume")))
        theory.at_most("distance from Helfrich's section over R, rms", f"R = {radius:g}, v = {v:.4f}", exact.rms / radius, 0.02 if item.quick else 0.005)
        rim = float(numpy.sort(folded.r)[-20:].mean())
        sections[radius] = (folded.r / rim, folded.z / rim)
        rows.append((radius, v, exact.rms, rim / radius))
    radii = sorted(sections)
    for coarse in radii[:-1]:
        paper.at_most("greatest distance between two sections of one diameter", f"R = {coarse:g} and {radii[-1]:g}, over the radius of the rim",
                      _apart(sections[coarse], sections[radii[-1]]), 0.03)  # fmt: skip
    item.table("Sections beside Helfrich's", ("R", "v", "rms distance, cells", "rim over R"), rows)
    item.csv("sections.csv", ("R", "r over the rim's", "z over the rim's"), [(radius, float(r), float(z)) for radius, (x, y) in sections.items()
             for r, z in list(zip(x, y))[:: max(1, len(x) // 250)]])  # fmt: skip
    item.picture("sections.png", _figure(sections), "Sections scaled to one diameter.")


def _median(section):
    """Upper outline in bins of r."""
    r, z = section
    edges = numpy.linspace(0.0, 0.95, 20)
    return numpy.array([numpy.mean(abs(z[(r >= a) & (r < b)])) for a, b in zip(edges, edges[1:])])


def _apart(one, other):
    return float(numpy.nanmax(abs(_median(one) - _median(other))))


def _figure(sections):
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(figsize=(8.0, 3.6), constrained_layout=True)
    for (radius, (r, z)), colour in zip(sections.items(), ("#E69F00", "#0072B2", "#009E73")):
        for side in (1, -1):
            axes.plot(side * r, z, ".", color=colour, markersize=1.5, label=f"R = {radius:g}" if side == 1 else None, rasterized=True)
    axes.set_aspect("equal")
    axes.set_xlabel("r over the rim's")
    axes.set_ylabel("z over the rim's")
    axes.legend(markerscale=6)
    return figure
