"""Any columns of metrics.csv over time."""

import numpy

from vesica.plotting import style, time_axis


@style.in_style
def draw(metrics, names, title):
    """Returns (figure, one line that says what it shows)."""
    steps = metrics["step"]
    figure, panels = style.column(len(names), 8.0, 1.6 + 2.2 * len(names))
    for axes, name, colour in zip(panels, names, numpy.resize(style.CYCLE, len(names))):
        axes.plot(steps, metrics[name], color=colour, **time_axis.marker(steps))
        axes.set_ylabel(name.replace("_", " "))
        axes.ticklabel_format(axis="y", style="sci", scilimits=(-3, 4), useMathText=True)
    panels[0].set_title(title, pad=10)
    time_axis.label(panels[-1], panels[0], steps, None)
    return figure, f"{', '.join(names)} over time"
