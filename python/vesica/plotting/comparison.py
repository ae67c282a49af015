"""How far a vesicle's surface is from an exact body of revolution."""

import math
from dataclasses import dataclass

import numpy
from scipy.spatial import cKDTree

from vesica.plotting.helfrich import Meridian


@dataclass(frozen=True)
class Comparison:
    """Distances in cells. `signed` is each surface point's distance to the nearest point of the exact meridian,
    positive outside of it, and `s` that nearest point's arc length."""

    branch: str
    exact: Meridian
    s: numpy.ndarray
    signed: numpy.ndarray
    rms: float  # over the surface, weighted by area
    largest: float  # of |signed|
    farthest_missed: float  # largest distance of a point of the exact meridian from the nearest of the surface's points

    def farthest(self):
        """The largest distance between the two, either way. The surface's points lie a cell apart: less than that is
        no sign of a part that the surface lacks."""
        return self.largest if self.farthest_missed < 1.0 else max(self.largest, self.farthest_missed)


def nearest_branch(folded, shapes, reduced_volume, volume):
    """Compares with every branch that exists, both ways up; the closest one, or None where none is known."""
    best = None
    for branch in shapes.existing(reduced_volume):
        exact = shapes.profile(branch, reduced_volume).of_volume(volume)
        for candidate in (exact, exact.upside_down()):
            found = compare(folded, branch, candidate)
            if best is None or found.rms < best.rms:
                best = found
    return best


def compare(folded, branch, exact):
    s, signed = _nearest(exact, folded.r, folded.z)
    rms = math.sqrt(numpy.average(signed**2, weights=folded.weights))
    missed, _ = cKDTree(numpy.column_stack((folded.r, folded.z))).query(numpy.column_stack((exact.r, exact.z)))
    return Comparison(branch, exact, s, signed, rms, float(numpy.abs(signed).max()), float(missed.max()))


def _nearest(exact, r, z):
    """Arc length and signed distance of the nearest point on the polyline: the nearest vertex, then its two edges."""
    vertices = numpy.column_stack((exact.r, exact.z))
    points = numpy.column_stack((r, z))
    _, index = cKDTree(vertices).query(points)
    best_distance = numpy.full(len(points), numpy.inf)
    best_s = numpy.zeros(len(points))
    side = numpy.ones(len(points))
    for shift in (-1, 0):
        start = numpy.clip(index + shift, 0, len(vertices) - 2)
        edge = vertices[start + 1] - vertices[start]
        offset = points - vertices[start]
        t = numpy.clip((offset * edge).sum(axis=1) / (edge**2).sum(axis=1), 0.0, 1.0)
        distance = numpy.linalg.norm(offset - t[:, None] * edge, axis=1)
        closer = distance < best_distance
        best_distance = numpy.where(closer, distance, best_distance)
        best_s = numpy.where(closer, exact.s[start] + t * (exact.s[start + 1] - exact.s[start]), best_s)
        # From the upper pole to the lower one the inside lies to the right of the path.
        outside = edge[:, 0] * offset[:, 1] - edge[:, 1] * offset[:, 0] > 0.0
        side = numpy.where(closer, numpy.where(outside, 1.0, -1.0), side)
    return best_s, side * best_distance
