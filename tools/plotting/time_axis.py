"""The axis that pictures over time share: steps below, bending times above."""


def label(bottom, top, steps, bending_time):
    """Labels the lowest and the highest panel of a column; `bending_time` in steps or None."""
    first, last = float(steps.min()), float(steps.max())
    margin = 0.02 * (last - first) or 1.0
    bottom.set_xlim(first - margin, last + margin)
    bottom.set_xlabel("time (steps)")
    bottom.ticklabel_format(axis="x", style="plain", useOffset=False)
    if bending_time:
        above = top.secondary_xaxis(
            "top", functions=(lambda t: t / bending_time, lambda t: t * bending_time)
        )
        above.set_xlabel(r"time ($\tau_b = \eta R_0^3/\kappa$ = " + f"{bending_time:.0f} steps)")


def marker(steps):
    """Few samples are drawn as points, which a line would hide."""
    return {"marker": "o", "markersize": 4.0} if len(steps) < 3 else {}
