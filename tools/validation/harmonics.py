"""Shapes close to a sphere as sums of Legendre polynomials about an axis."""

import math

import numpy

from vesica.plotting.surface import read_surface


def legendre_amplitude(surface, degree, axis=(0.0, 0.0, 1.0)):
    """a_l in r = R (1 + sum a_l P_l(cos theta)), by quadrature over the triangles as seen from the centre of volume."""
    centre = surface.centre()
    corners = surface.points[surface.triangles] - centre
    middles = corners.mean(axis=1)
    distances = numpy.linalg.norm(middles, axis=1)
    solid_angles = numpy.einsum("ij,ij->i", middles, surface.face_areas()) / distances**3
    cosines = middles @ numpy.asarray(axis) / distances
    polynomial = numpy.polynomial.legendre.Legendre.basis(degree)(cosines)
    radius = (3.0 * surface.volume() / (4.0 * math.pi)) ** (1.0 / 3.0)
    return float((2 * degree + 1) / (4 * math.pi) * numpy.sum((distances / radius - 1.0) * polynomial * solid_angles))


def decay_rate(finished, degree, first, last):
    """Rate of exponential decay of a_l between two steps, by least squares of log|a_l| over the surfaces written; NaN
    for a run that ended early."""
    if finished.failure is not None:
        return math.nan
    steps, logarithms = [], []
    for path in sorted((finished.directory / "surfaces").glob("surface_*.vtp")):
        step = int(path.stem.rpartition("_")[2])
        if first <= step <= last:
            steps.append(step)
            logarithms.append(math.log(abs(legendre_amplitude(read_surface(path), degree))))
    if len(steps) < 3:
        raise ValueError(f"{finished.directory}: {len(steps)} surfaces between steps {first} and {last}; need 3")
    return -float(numpy.polyfit(steps, logarithms, 1)[0])


def mobility(l, ratio=1.0):
    """m_l of a membrane that pushes along its normal only and lets its material flow (the paper's); `ratio` is
    eta_in/eta_out."""
    one = 1 + ratio
    return l * (l + 1) * (2 * l + 1) * one / (
        (2 * l * l * one - 2 * ratio + 1) * (2 * l * l * one + 4 * l * one + 3 * ratio)
    )


def inextensible_mobility(l, ratio=1.0):
    """m_l of a membrane whose every patch keeps its area."""
    return l * (l + 1) / (2 * l**3 + 3 * l**2 + 4 + ratio * (2 * l**3 + 3 * l**2 - 5))


def relaxation_rate(l, kappa, sigma, radius, viscosity, m=mobility):
    """Gamma_l = kappa/(eta R^3) (l - 1)(l + 2) [l (l + 1) + sigma R^2/kappa] m_l per step, for density 1."""
    return (l - 1) * (l + 2) * (kappa * l * (l + 1) + sigma * radius**2) * m(l) / (viscosity * radius**3)
