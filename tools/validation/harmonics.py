"""Shapes close to a sphere as sums of Legendre polynomials about an axis."""

import math

import numpy

from plotting.surface import read_surface


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
    """Rate of exponential decay of a_l between two steps, by least squares of log|a_l| over the surfaces written."""
    steps, logarithms = [], []
    for path in sorted((finished.directory / "surfaces").glob("surface_*.vtp")):
        step = int(path.stem.rpartition("_")[2])
        if first <= step <= last:
            steps.append(step)
            logarithms.append(math.log(abs(legendre_amplitude(read_surface(path), degree))))
    if len(steps) < 3:
        raise ValueError(f"{finished.directory}: {len(steps)} surfaces between steps {first} and {last}; need 3")
    return -float(numpy.polyfit(steps, logarithms, 1)[0])
