"""The axis that pictures over time share: steps below, bending times or strain above."""


def label(bottom, top, steps, unit, unit_label=None):
    """Labels the lowest and the highest panel of a column; `unit`, in steps, of the upper axis, by default the bending
    time, or None without one."""
    first, last = float(steps.min()), float(steps.max())
    margin = 0.02 * (last - first) or 1.0
    bottom.set_xlim(first - margin, last + margin)
    bottom.set_xlabel("time (steps)")
    bottom.ticklabel_format(axis="x", style="plain", useOffset=False)
    if unit:
        above = top.secondary_xaxis(
            "top", functions=(lambda t: t / unit, lambda t: t * unit)
        )
        above.set_xlabel(unit_label or r"time ($\tau_b = \eta R_0^3/\kappa$ = " + f"{unit:.0f} steps)")


def marker(steps):
    """Few samples are drawn as points, which a line would hide."""
    return {"marker": "o", "markersize": 4.0} if len(steps) < 3 else {}
