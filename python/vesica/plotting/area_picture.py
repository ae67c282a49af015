"""area.png: a vesicle's area beside its target over time, and its volume."""

import numpy

from vesica.errors import Unavailable
from vesica.plotting import style, time_axis


@style.in_style
def draw(metrics, title, bending_time=None):
    """Returns (figure, one line that says what it shows)."""
    steps, area, ratio, volume = (metrics[name] for name in ("step", "area", "area_ratio", "volume"))
    if not numpy.isfinite(area).any():
        raise Unavailable("every area in metrics.csv is nan")
    figure, (upper, middle, lower) = style.column(3, 8.0, 6.6, ratios=[1.6, 1.0, 1.0])
    points = time_axis.marker(steps)
    target = area / ratio
    upper.plot(steps, area, color=style.RUN, label="area of the surface", zorder=3, **points)
    says = "no target"
    if numpy.isfinite(target).any():
        upper.plot(steps, target, color=style.CYCLE[3], linestyle=(0, (6, 2)), linewidth=1.4, label="target", **points)
        middle.plot(steps, ratio - 1.0, color=style.RUN, **points)
        says = f"at the end {ratio[-1] - 1.0:+.1e} from its target"
    upper.set_ylabel("area A (cells²)")
    upper.legend(loc="best")
    middle.set_ylabel(r"$A/A_{\mathrm{target}} - 1$")
    first = volume[numpy.isfinite(volume)][0] if numpy.isfinite(volume).any() else numpy.nan
    lower.plot(steps, volume / first - 1.0, color=style.CYCLE[1], **points)
    lower.set_ylabel(r"$V/V_{\mathrm{first}} - 1$")
    for axes in (middle, lower):
        axes.axhline(0.0, color="#888888", linewidth=0.8)
        axes.ticklabel_format(axis="y", style="sci", scilimits=(-3, 3), useMathText=True)
    upper.set_title(f"{title}\narea, {says}", pad=10)
    time_axis.label(lower, upper, steps, bending_time)
    return figure, f"area over time, {says}"
