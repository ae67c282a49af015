"""A vesicle's surface as triangles."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy


@dataclass(frozen=True, eq=False)
class Surface:
    """A closed surface; triangles counter-clockwise seen from outside.

    points (n, 3) in cells, triangles (m, 3) of indices, fields {name: (n,) or (n, 3)}: mean_curvature and
    gaussian_curvature; bending_force, tension_force (of the constant tension), area_force (of what holds the area) and
    their sum total_force, all per area and along the outward normal; velocity and normal (n, 3)."""

    points: numpy.ndarray
    triangles: numpy.ndarray
    fields: Mapping[str, Any]

    @property
    def H(self) -> numpy.ndarray:
        """(n,) mean curvature in 1/cells, positive on a sphere."""
        return self.fields["mean_curvature"]

    @property
    def K(self) -> numpy.ndarray:
        """(n,) Gaussian curvature in 1/cells^2."""
        return self.fields["gaussian_curvature"]

    def in_cells(self, cell: float) -> Surface:
        """The same surface when a cell is ``cell`` long in the units it was written in."""
        fields = dict(self.fields)
        if "mean_curvature" in fields:
            fields["mean_curvature"] = fields["mean_curvature"] * cell
        if "gaussian_curvature" in fields:
            fields["gaussian_curvature"] = fields["gaussian_curvature"] * cell**2
        return Surface(self.points / cell, self.triangles, fields)

    def face_areas(self) -> numpy.ndarray:
        """(m, 3): the triangles' outward normals times their areas."""
        a, b, c = (self.points[self.triangles[:, k]] for k in range(3))
        return 0.5 * numpy.cross(b - a, c - a)

    def point_areas(self) -> numpy.ndarray:
        """(n,): a third of the area of every triangle that meets in the point."""
        thirds = numpy.linalg.norm(self.face_areas(), axis=1) / 3.0
        return numpy.bincount(self.triangles.ravel(), numpy.repeat(thirds, 3), len(self.points))

    def area(self) -> float:
        """In cells^2."""
        return float(numpy.linalg.norm(self.face_areas(), axis=1).sum())

    def normals(self) -> numpy.ndarray:
        """(n, 3): outward unit normals of the points, averaged over their triangles."""
        sums = numpy.zeros_like(self.points)
        faces = self.face_areas()
        for k in range(3):
            numpy.add.at(sums, self.triangles[:, k], faces)
        return sums / numpy.maximum(numpy.linalg.norm(sums, axis=1, keepdims=True), 1e-300)

    def volume(self) -> float:
        """In cells^3."""
        middles = self.points[self.triangles].mean(axis=1)
        return float(numpy.einsum("ij,ij->", middles, self.face_areas()) / 3.0)

    def centre(self) -> numpy.ndarray:
        """(3,): centre of the enclosed volume, from tetrahedra over a point close by."""
        origin = self.points.mean(axis=0)
        a, b, c = (self.points[self.triangles[:, k]] - origin for k in range(3))
        volumes = numpy.einsum("ij,ij->i", a, numpy.cross(b, c)) / 6.0
        return origin + numpy.einsum("i,ij->j", volumes, (a + b + c) / 4.0) / volumes.sum()

    def principal_spreads(self) -> tuple[numpy.ndarray, numpy.ndarray]:
        """Ascending area-weighted mean squares of the distances from the centre along three axes, and the axes as columns
        of a right-handed frame."""
        offsets = self.points - self.centre()
        weights = self.point_areas()
        spreads, axes = numpy.linalg.eigh(numpy.einsum("i,ij,ik->jk", weights, offsets, offsets) / weights.sum())
        axes[:, 2] *= numpy.sign(numpy.linalg.det(axes))
        return spreads, axes
