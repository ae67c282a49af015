"""profile.png: the vesicle's meridian beside Helfrich's exact shape of the same reduced volume and volume."""

import math

import numpy

from vesica.plotting import style


@style.in_style
def draw(folded, comparison, reduced_volume, volume, title, remark=""):
    """Returns (figure, one line that says what it shows). `comparison` may be None: then the profile alone.
    Lengths in cells; the numbers also in R0 = (3 V/(4 pi))^(1/3)."""
    radius = (3.0 * volume / (4.0 * math.pi)) ** (1.0 / 3.0)
    figure, (shape, distance) = style.column(2, 8.0, 6.4, ratios=[2.6, 1.0], sharex=False)
    lying = numpy.ptp(folded.z) > 2.0 * folded.r.max()  # a prolate is drawn along the page
    _draw_shape(shape, folded, comparison, lying)
    shape.set_title(f"{title}: meridian profile at v = {reduced_volume:.4f}")
    notes = [_numbers(comparison, radius)] if comparison else [f"no exact shape is known at v = {reduced_volume:.4f}"]
    if folded.asymmetry > 0.02:
        notes.append(f"not a body of revolution: spreads across the axis differ by {100 * folded.asymmetry:.1f} %")
    if remark:
        notes.append(remark)

    if comparison:
        _draw_distance(distance, comparison, radius)
    else:
        distance.set_visible(False)
    figure.text(0.5, -0.01, "\n".join(notes), ha="center", va="top", fontsize=9)
    figure.draw_without_rendering()
    _grow_for_notes(figure, len(notes))
    return figure, f"meridian profile against Helfrich's exact shape; {notes[0]}"


def _numbers(comparison, radius):
    def both(length):
        return f"{length:.3f} cells = {length / radius:.4f} R0"

    return (
        f"{comparison.branch}: rms nearest-point distance {both(comparison.rms)}, "
        f"largest {both(comparison.farthest())}"
    )


def _draw_shape(axes, folded, comparison, lying):
    def place(r, z):
        return (z, r) if lying else (r, z)

    for side in (1.0, -1.0):
        label = "phase field's surface" if side > 0.0 else None
        axes.plot(*place(side * folded.r, folded.z), ".", color=style.RUN, markersize=2.2, alpha=0.35,
                  markeredgewidth=0, label=label, rasterized=True)
    if comparison:
        exact, name = comparison.exact, comparison.branch
        r = numpy.concatenate((exact.r, -exact.r[::-1]))
        z = numpy.concatenate((exact.z, exact.z[::-1]))
        axes.plot(*place(r, z), color=style.BRANCH_COLOURS[name], linewidth=1.4, label=f"Helfrich's {name}, exact")
    axes.set_aspect("equal", adjustable="datalim")
    names = ("distance from the axis r (cells)", "height along the axis z (cells)")
    axes.set_xlabel(names[1] if lying else names[0])
    axes.set_ylabel(names[0] if lying else names[1])
    legend = axes.legend(loc="upper left", bbox_to_anchor=(0.0, 1.0), ncol=2, markerscale=4.0)
    for handle in legend.legendHandles:
        handle.set_alpha(1.0)
    low, high = axes.get_ylim()
    axes.set_ylim(low, high + 0.14 * (high - low))  # room for the legend


def _draw_distance(axes, comparison, radius):
    length = comparison.exact.s[-1]
    axes.axhline(0.0, color=style.BRANCH_COLOURS[comparison.branch], linewidth=1.4)
    axes.axhspan(-comparison.rms, comparison.rms, color=style.RUN, alpha=0.12, linewidth=0, label="± rms")
    axes.plot(comparison.s / length, comparison.signed, ".", color=style.RUN, markersize=2.2, alpha=0.35,
              markeredgewidth=0, rasterized=True)
    limit = 1.15 * max(numpy.abs(comparison.signed).max(), 1e-12)
    axes.set_xlim(0.0, 1.0)
    axes.set_ylim(-limit, limit)
    axes.set_xlabel("arc length along the exact meridian, pole to pole (of its length)")
    axes.set_ylabel("distance (cells)\noutside +")
    axes.legend(loc="upper right")
    right = axes.secondary_yaxis("right", functions=(lambda d: d / radius, lambda d: d * radius))
    right.set_ylabel("distance (R0)")


def _grow_for_notes(figure, lines):
    """Turns the layout off and makes room at the foot for the notes, which stand outside the axes."""
    figure.set_layout_engine("none")
    width, height = figure.get_size_inches()
    extra = 0.2 * lines + 0.15
    scale = height / (height + extra)
    for axes in figure.axes:
        box = axes.get_position()
        axes.set_position([box.x0, 1.0 - (1.0 - box.y0) * scale, box.width, box.height * scale])
    figure.set_size_inches(width, height + extra)
    figure.texts[-1].set_y((extra - 0.05) / (height + extra))
