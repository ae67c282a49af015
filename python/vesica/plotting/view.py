"""Where the camera stands: a frame in which a vesicle shows its shape."""

import math
from dataclasses import dataclass

import numpy

TILT = math.radians(38.0)  # above the plane of the two larger extents, so that a dimple shows


@dataclass(frozen=True)
class View:
    """Parallel projection. Rows of `frame`: right, up, towards the eye."""

    frame: numpy.ndarray
    centre: numpy.ndarray
    half_width: float  # of the picture, cells
    half_height: float

    def project(self, points):
        return (points - self.centre) @ self.frame.T


def choose(surface):
    """Longest extent to the right, shortest upwards, tilted towards the eye; the side with the sharper rim on top."""
    _, axes = surface.principal_spreads()
    right, up = axes[:, 2], axes[:, 0]
    curvature = surface.fields.get("mean_curvature")
    heights = (surface.points - surface.centre()) @ up
    if curvature is not None and numpy.isfinite(curvature).all():
        lean = float((surface.point_areas() * heights * curvature**2).sum())
        scale = float((surface.point_areas() * numpy.abs(heights) * curvature**2).sum())
        if lean < -0.05 * scale:
            up = -up
    elif up[numpy.abs(up).argmax()] < 0.0:
        up = -up
    eye = numpy.cross(right, up)
    tilted_eye = math.cos(TILT) * eye + math.sin(TILT) * up
    frame = numpy.array([right, numpy.cross(tilted_eye, right), tilted_eye])

    corners = (surface.points - surface.points.mean(axis=0)) @ frame.T
    low, high = corners.min(axis=0), corners.max(axis=0)
    centre = surface.points.mean(axis=0) + frame.T @ (0.5 * (low + high))
    half = 0.5 * (high - low)
    return View(frame, centre, 1.06 * half[0], 1.06 * half[1])
