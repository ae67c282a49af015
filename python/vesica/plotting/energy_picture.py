"""energy.png: bending energy and reduced volume over time, against Helfrich's branches at the same v."""

import numpy

from vesica.plotting import style, time_axis
from vesica.plotting.helfrich import BRANCHES
from vesica.errors import Unavailable


@style.in_style
def draw(metrics, shapes, title, bending_time=None, spontaneous_curvature=0.0):
    """Returns (figure, one line that says what it shows). Theory is drawn for C0 = 0 only."""
    steps, energy, v = metrics["step"], metrics["bending_energy"], metrics["reduced_volume"]
    if not numpy.isfinite(energy).any():
        raise Unavailable("every bending_energy in metrics.csv is nan")
    figure, (upper, lower) = style.column(2, 8.0, 6.0, ratios=[2.0, 1.0])
    points = time_axis.marker(steps)
    upper.plot(steps, energy, color=style.RUN, label="this run", zorder=3, **points)
    closest = None
    for name in BRANCHES if spontaneous_curvature == 0.0 else ():
        theory = shapes.energy(name, v)
        if not numpy.isfinite(theory).any():
            continue
        upper.plot(steps, theory, color=style.BRANCH_COLOURS[name], linestyle=style.BRANCH_DASHES[name],
                   linewidth=1.4, label=f"Helfrich's {name} at the run's v", **points)
        if numpy.isfinite(energy[-1]) and numpy.isfinite(theory[-1]):
            deviation = energy[-1] / theory[-1] - 1.0
            if closest is None or abs(deviation) < abs(closest[1]):
                closest = (name, deviation)
    if numpy.nanmin(energy) < 1.02:
        upper.axhline(1.0, color="#888888", linewidth=0.8)
        upper.annotate("sphere", (1.0, 1.0), xycoords=("axes fraction", "data"), xytext=(-4, 3),
                       textcoords="offset points", ha="right", fontsize=8, color="#666666")
    upper.set_ylabel(r"bending energy / $8\pi\kappa$")
    upper.set_title(_title(title, closest, spontaneous_curvature), pad=10)
    upper.legend(loc="best")

    lower.plot(steps, v, color=style.RUN, **points)
    lower.set_ylabel("reduced volume v")
    time_axis.label(lower, upper, steps, bending_time)
    says = f"; the last sample is {100 * closest[1]:+.2f} % from the {closest[0]}" if closest else ""
    return figure, f"bending energy and reduced volume over time against theory{says}"


def _title(title, closest, spontaneous_curvature):
    if closest:
        return f"{title}\nbending energy, at the end {100 * closest[1]:+.2f} % from the {closest[0]}"
    if spontaneous_curvature != 0.0:
        return f"{title}\nbending energy (C0 = {spontaneous_curvature:g}; theory is for C0 = 0)"
    return f"{title}\nbending energy"
