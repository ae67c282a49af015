"""conservation.png: how well area, volume and colour mass are held."""

import numpy

from vesica.plotting import style, time_axis


@style.in_style
def draw(metrics, title):
    """Returns (figure, one line that says what it shows)."""
    steps, volume = metrics["step"], metrics["volume"]
    area, area_label = metrics["area_ratio"] - 1.0, r"$A/A_{\mathrm{target}} - 1$"
    area_name = "area against its target"
    if not numpy.isfinite(area).any() and "area" in metrics:
        area, area_label = _change(metrics["area"]), r"$A/A_{\mathrm{first}} - 1$"
        area_name = "area against its first sample (no target)"
    panels = (
        (area, area_label, area_name, style.RUN),
        (_change(volume), r"$V/V_{\mathrm{first}} - 1$", "volume against its first sample", "#E69F00"),
        (metrics["mass_drift"], r"$m/m_0 - 1$", "colour mass against step 0", "#009E73"),
    )
    figure, column = style.column(3, 8.0, 6.4)
    last = []
    for axes, (values, label, name, colour) in zip(column, panels):
        axes.plot(steps, values, color=colour, **time_axis.marker(steps))
        axes.axhline(0.0, color="#888888", linewidth=0.8)
        axes.set_ylabel(label)
        axes.ticklabel_format(axis="y", style="sci", scilimits=(-3, 3), useMathText=True)
        said = "all nan" if not numpy.isfinite(values).any() else f"last {values[-1]:+.2e}, largest {_largest(values):.2e}"
        last.append(f"{name.split()[0]} {values[-1]:+.1e}")
        axes.text(1.0, 1.02, f"{name}: {said}", transform=axes.transAxes, ha="right", va="bottom", fontsize=9)
    figure.suptitle(f"{title}: conservation", x=0.01, ha="left", fontsize=11, fontweight="bold")
    time_axis.label(column[-1], column[0], steps, None)
    return figure, "relative changes of area, volume and colour mass over time; at the end " + ", ".join(last)


def _change(values):
    finite = values[numpy.isfinite(values)]
    return values / finite[0] - 1.0 if len(finite) and finite[0] != 0.0 else numpy.full_like(values, numpy.nan)


def _largest(values):
    return float(numpy.nanmax(numpy.abs(values)))
