"""A closed triangle mesh of a shape of revolution, for `shape = "mesh"` of a case file."""

from pathlib import Path

import numpy as np
from axisymmetric_minimiser import Shape


def write_ply(shape: Shape, path: Path | str, equivalent_radius: float, meridian_points: int = 201) -> None:
    """Write `shape` as a binary PLY, its axis along z and its centre of volume at the origin.

    `equivalent_radius` is R0 = (3V/4 pi)^(1/3) in cells, `meridian_points` counts the poles. The vertices are then
    scaled so that the polyhedron itself has that volume. Raises ValueError for a shape that intersects itself.
    """
    if not shape.is_embedded:
        raise ValueError("the shape intersects itself; expected the surface of a body")
    vertices, triangles = revolve(shape, meridian_points)
    corners = vertices[triangles]
    volumes = np.einsum("ij,ij->i", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])) / 6
    volume = volumes.sum()
    vertices = vertices - (volumes @ corners.sum(axis=1)) / (4 * volume)
    vertices = vertices * (equivalent_radius / np.cbrt(3 * volume / (4 * np.pi)))
    faces = np.empty(len(triangles), dtype=[("count", "u1"), ("corners", "<i4", 3)])
    faces["count"], faces["corners"] = 3, triangles
    header = (
        "ply\nformat binary_little_endian 1.0\n"
        f"element vertex {len(vertices)}\nproperty double x\nproperty double y\nproperty double z\n"
        f"element face {len(triangles)}\nproperty list uchar int vertex_indices\nend_header\n"
    )
    Path(path).write_bytes(header.encode() + vertices.astype("<f8").tobytes() + faces.tobytes())


def revolve(shape: Shape, meridian_points: int = 201) -> tuple[np.ndarray, np.ndarray]:
    """Return vertices (in R_A) and triangles of even size, counter-clockwise seen from outside.

    The mesh has the mirror planes and the four-fold axis of the lattice, and the shape's own mirror plane, lest its
    facets push a shape off a saddle that these symmetries keep.
    """
    profile = shape.profile(meridian_points)
    step = profile.s[1]
    rows: list[np.ndarray] = []
    vertices = [np.array([[0.0, 0.0, profile.z[0]]])]
    first = 1
    for r, z in zip(profile.r[1:-1], profile.z[1:-1]):
        count = 8 * max(1, round(2 * np.pi * r / (8 * step)))
        angle = 2 * np.pi * np.arange(count) / count
        vertices.append(np.column_stack([r * np.cos(angle), r * np.sin(angle), np.full(count, z)]))
        rows.append(first + np.arange(count))
        first += count
    vertices.append(np.array([[0.0, 0.0, profile.z[-1]]]))
    top, bottom = rows[0], rows[-1]
    triangles = [(0, a, b) for a, b in zip(top, np.roll(top, -1))]
    triangles += [(first, b, a) for a, b in zip(bottom, np.roll(bottom, -1))]
    for j, (upper, lower) in enumerate(zip(rows[:-1], rows[1:])):
        if 2 * j < len(rows) - 1:
            triangles += _stitch(upper, lower)
        else:
            triangles += [(a, c, b) for a, b, c in _stitch(lower, upper)]
    return np.concatenate(vertices), np.array(triangles, dtype=np.int32)


def _stitch(upper: np.ndarray, lower: np.ndarray) -> list[tuple[int, int, int]]:
    """Return the triangles between two rings, octant by octant, every other one the mirror image of its neighbours."""
    many, few = upper.size // 8, lower.size // 8
    triangles = []
    for octant in range(8):
        mirrored = octant % 2 == 1
        i = j = 0
        while i < many or j < few:
            along_upper = j == few or (i < many and (i + 1) * few <= (j + 1) * many)
            corners = [(i, j), (i + 1, j) if along_upper else (i, j + 1)]
            a, b = (
                upper[(octant * many + (many - k if mirrored else k)) % upper.size] for k in (corners[0][0], corners[1][0])
            )
            c, d = (
                lower[(octant * few + (few - k if mirrored else k)) % lower.size] for k in (corners[0][1], corners[1][1])
            )
            triangle = (a, c, b) if along_upper else (a, c, d)
            triangles.append((triangle[0], triangle[2], triangle[1]) if mirrored else triangle)
            i, j = corners[1]
    return triangles
