"""Evans and Fung's profile of a red cell (1972), the paper's Eq 66, as printed and as it must be read."""

import numpy

MICROMETRES = (0.81, 7.83, -4.39)  # C0, C1, C2: lengths, for a cell of R0 = 3.91 micrometres
RADIUS = 3.91


def half_thickness(r, radius, coefficients=tuple(c / RADIUS for c in MICROMETRES)):
    """z(r) = (R0/2) sqrt(1 - r^2/R0^2) (C0 + C1 r^2/R0^2 + C2 r^4/R0^4), with C in units of R0. Eq 66 prints the
    coefficients in micrometres, which makes the cell 3.91 times too thick."""
    x = numpy.clip((numpy.asarray(r) / radius) ** 2, 0.0, 1.0)
    c0, c1, c2 = coefficients
    return 0.5 * radius * numpy.sqrt(1.0 - x) * (c0 + c1 * x + c2 * x * x)


def outline(radius, points=2001, coefficients=None):
    """(r, z) of the upper half from the axis to the rim, dense where it is steep."""
    r = radius * numpy.sin(numpy.linspace(0.0, numpy.pi / 2, points))
    return r, half_thickness(r, radius) if coefficients is None else half_thickness(r, radius, coefficients)
