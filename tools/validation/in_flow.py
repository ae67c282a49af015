"""What runs in a flow have in common: their parameters from Re, and means and trends of the samples of their end."""

import math

import numpy


def greatest_rate(radius, viscosity, reynolds=0.098):
    """The shear rate of Re = rate R^2/nu, two digits, rounded down: `vesica check` warns beyond Re = 0.1."""
    rate = reynolds * viscosity / radius**2
    unit = 10.0 ** (math.floor(math.log10(rate)) - 1)
    return float(f"{math.floor(rate / unit) * unit:.2g}")


def viscosity_for(ratio, greatest=0.5):
    """Kinematic viscosity outside: as large as may be with a relaxation time of at most 3.5 inside."""
    return min(greatest, math.floor(990.0 / ratio) / 1000.0)


def steps_of_strain(strain, rate, multiple=500):
    """Steps in which walls at this rate shear the fluid by `strain`, a multiple of that of the samples."""
    return multiple * math.ceil(strain / rate / multiple)


def middle_of(size):
    """Of the box, but in the middle of a layer of cells along y, across the shear: the tank-treading frequency is
    taken from a slab of whole layers about the vesicle's centre."""
    return [size[0] / 2, size[1] / 2 + 0.5, size[2] / 2]


def _end(finished, column, steps):
    time, values = finished.metrics["step"], finished.metrics[column]
    chosen = time >= time[-1] - steps
    return time[chosen], values[chosen]


def mean_of_end(finished, column, steps):
    """Of the samples of the last `steps`; NaN for a run that ended early."""
    return math.nan if finished.failure is not None else float(_end(finished, column, steps)[1].mean())


def drift_of_end(finished, column, steps):
    """The change over the last `steps`, by a straight line; NaN for a run that ended early."""
    if finished.failure is not None:
        return math.nan
    time, values = _end(finished, column, steps)
    if len(time) < 3:
        raise ValueError(f"{finished.directory}: {len(time)} samples of {column} in the last {steps} steps; need 3")
    return float(numpy.polyfit(time - time[0], values, 1)[0]) * steps
