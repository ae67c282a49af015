"""angle.png: inclination and tank-treading frequency in shear, against Keller's and Skalak's ellipsoid."""

import math

import numpy

from vesica.errors import Unavailable
from vesica.plotting import keller_skalak, style, time_axis


@style.in_style
def draw(metrics, title, shear_rate=None, viscosity_ratio=1.0):
    """Returns (figure, one line that says what it shows). `shear_rate` in 1/steps gives time as strain."""
    steps, angle = metrics["step"], metrics["inclination"]
    if not numpy.isfinite(angle).any():
        raise Unavailable("every inclination in metrics.csv is nan; it is measured in a shear or a channel's flow")
    figure, (upper, lower) = style.column(2, 8.0, 6.0, ratios=[1.6, 1.0])
    points = time_axis.marker(steps)
    # A tumbling vesicle leaves at -90 degrees and comes in at 90: no line across.
    jumps = numpy.abs(numpy.diff(angle, prepend=angle[0])) > 90.0
    upper.plot(steps, numpy.where(jumps, numpy.nan, angle), color=style.RUN, label="this run", zorder=3, **points)
    says = f"at the end {angle[-1]:.1f}°"
    axes_of = _semi_axes(metrics) if shear_rate else None
    if axes_of:
        theory = math.degrees(keller_skalak.inclination(axes_of, viscosity_ratio))
        if math.isfinite(theory):
            upper.axhline(theory, color=style.CYCLE[3], linestyle=(0, (6, 2)), linewidth=1.4,
                          label="Keller and Skalak, the last sample's ellipsoid")
            says += f", by Keller and Skalak {theory:.1f}°"
        else:
            says += "; by Keller and Skalak it tumbles"
    upper.axhline(0.0, color="#888888", linewidth=0.8)
    upper.set_ylabel("inclination (degrees)")
    upper.set_title(f"{title}\ninclination, {says}", pad=10)
    upper.legend(loc="best")
    frequency = metrics.get("tank_treading_frequency", numpy.full_like(angle, numpy.nan))
    if shear_rate and numpy.isfinite(frequency).any():
        lower.plot(steps, frequency / abs(shear_rate), color=style.RUN, **points)
        lower.axhline(0.5, color="#888888", linewidth=0.8)
        lower.annotate("a wheel's", (1.0, 0.5), xycoords=("axes fraction", "data"), xytext=(-4, -3),
                       textcoords="offset points", ha="right", va="top", fontsize=8, color="#666666")
        if axes_of and math.isfinite(keller_skalak.inclination(axes_of, viscosity_ratio)):
            lower.axhline(keller_skalak.tank_treading_frequency(axes_of, viscosity_ratio), color=style.CYCLE[3],
                          linestyle=(0, (6, 2)), linewidth=1.4)
        lower.set_ylabel(r"tank-treading $\omega/\dot\gamma$")
    else:
        lower.plot(steps, metrics["taylor_deformation"], color=style.RUN, **points)
        lower.set_ylabel("Taylor deformation D")
    time_axis.label(lower, upper, steps, 1.0 / abs(shear_rate) if shear_rate else None,
                    r"strain $\dot\gamma t$" if shear_rate else None)
    return figure, f"inclination over time, {says}"


def _semi_axes(metrics):
    """(long, short, third) of the ellipsoid of the last sample's moments of inertia, the longest and the shortest in the
    shear plane; None where they say nothing."""
    moments = [metrics[f"inertia_{k}"][-1] for k in (1, 2, 3)]
    squares = [0.5 * sum(moments) - moment for moment in moments]  # of the axes, over a fifth of the mass
    if not all(math.isfinite(square) and square > 0.0 for square in squares):
        return None
    long, middle, short = (math.sqrt(square) for square in squares)
    return (long, short, middle) if long / short > 1.01 else None
