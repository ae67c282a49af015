"""inertia.png: the principal moments of inertia over time, against those of Helfrich's shape at the same reduced volume."""

import math

import numpy

from vesica.errors import Unavailable
from vesica.plotting import style, time_axis

SUBSCRIPTS = ("1", "2", "3")


@style.in_style
def draw(metrics, shapes, title, density=1.0, bending_time=None, spontaneous_curvature=0.0):
    """Returns (figure, one line that says what it shows). Moments over that of the sphere of equal volume."""
    steps, volume, v = metrics["step"], metrics["volume"], metrics["reduced_volume"]
    radius = numpy.cbrt(3.0 * volume / (4.0 * math.pi))
    sphere = 0.4 * density * volume * radius**2
    moments = [metrics[f"inertia_{k}"] / sphere for k in SUBSCRIPTS]
    if not numpy.isfinite(moments).any():
        raise Unavailable("every moment of inertia in metrics.csv is nan")
    branch = _nearest_branch(metrics, shapes) if spontaneous_curvature == 0.0 else None
    theory = _moments_of(shapes, branch, v) if branch else None
    figure, (upper, lower) = style.column(2, 8.0, 6.0, ratios=[2.2, 1.0])
    points = time_axis.marker(steps)
    for k, (moment, name) in enumerate(zip(moments, SUBSCRIPTS)):
        colour = style.CYCLE[(0, 2, 1)[k]]
        upper.plot(steps, moment, color=colour, label=f"$I_{name}$", zorder=3, **points)
        if theory is not None:
            upper.plot(steps, theory[k], color=style.INK, linestyle=style.BRANCH_DASHES[branch], linewidth=1.1, zorder=4,
                       label=f"Helfrich's {branch} at the run's v" if k == 2 else None, **points)
            lower.plot(steps, 100.0 * (moment / theory[k] - 1.0), color=colour, **points)
    upper.set_ylabel(r"$I_k$ / $\frac{2}{5}\,\rho V R_0^2$")
    upper.legend(loc="best", ncol=2)
    says = "principal moments of inertia over time"
    if theory is not None:
        lower.axhline(0.0, color="#888888", linewidth=0.8)
        lower.set_ylabel("from theory (%)")
        last = max((moment[-1] / theory[k][-1] - 1.0 for k, moment in enumerate(moments)), key=abs)
        says += f"; at the end within {100 * abs(last):.2f} % of the {branch}'s"
        upper.set_title(f"{title}\nmoments of inertia, at the end within {100 * abs(last):.2f} % of the {branch}'s", pad=10)
    else:
        lower.plot(steps, v, color=style.RUN, **points)
        lower.set_ylabel("reduced volume v")
        upper.set_title(f"{title}\nmoments of inertia", pad=10)
    time_axis.label(lower, upper, steps, bending_time)
    return figure, says


def _nearest_branch(metrics, shapes):
    """The branch whose energy the last sample is nearest to; None where none is known."""
    v, energy = metrics["reduced_volume"][-1], metrics["bending_energy"][-1]
    known = shapes.existing(v) if numpy.isfinite(v) and numpy.isfinite(energy) else []
    return min(known, key=lambda name: abs(energy - float(shapes.energy(name, v))), default=None)


def _moments_of(shapes, branch, reduced_volume):
    """(3, samples) ascending, over the sphere's; nan where the branch is not known."""
    low, high = shapes.range(branch)
    low, high = (float(numpy.clip(edge, low, high)) for edge in (numpy.nanmin(reduced_volume), numpy.nanmax(reduced_volume)))
    nodes = numpy.linspace(low, high, 24 if high > low else 1)
    table = []
    for v in nodes:
        along, across = shapes.profile(branch, v).of_volume(4.0 / 3.0 * math.pi).inertia()
        table.append(sorted((along, across, across)))
    table = numpy.array(table) / (0.4 * 4.0 / 3.0 * math.pi)
    return [numpy.interp(reduced_volume, nodes, column, left=numpy.nan, right=numpy.nan) for column in table.T]
