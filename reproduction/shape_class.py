"""The paper's classes of shapes, (A) oblate, (B) prolate, (C) without an axis, from a surface alone; S is a sphere still."""

from dataclasses import dataclass

import numpy

from shared import fold

ROUND = 0.05  # relative spread of the outline about the axis up to which a shape counts as a body of revolution


SPHERE = 0.05  # length along the axis over width, off 1, up to which a shape has become nothing at all


@dataclass(frozen=True)
class ShapeClass:
    letter: str
    roughness: float  # relative spread of the outline about the axis
    genus: int
    pieces: int

    def words(self):
        holes = {0: "", 1: ", a hole"}.get(self.genus, f", {self.genus} holes")
        return ("sphere" if self.letter == "S" else self.letter) + holes + (f", {self.pieces} pieces" if self.pieces > 1 else "")


def classify(surface):
    folded = fold(surface)
    offsets = surface.points - surface.centre()
    along = offsets @ folded.axis
    across = numpy.linalg.svd(folded.axis[None, :])[2][1:]
    angle = numpy.arctan2(offsets @ across[1], offsets @ across[0])
    bins = ((angle + numpy.pi) / (2 * numpy.pi) * 36).astype(int) % 36
    outline = numpy.array([folded.r[bins == k].max() for k in range(36) if (bins == k).any()])
    roughness = float(outline.std() / outline.mean())
    widths = numpy.ptp(along) / (2 * folded.r.max())
    letter = "C" if roughness > ROUND else "S" if abs(widths - 1.0) < SPHERE else "A" if widths < 1.0 else "B"
    pieces, euler = _topology(surface)
    return ShapeClass(letter, roughness, pieces - euler // 2, pieces)


def _topology(surface):
    """(connected pieces, Euler number)."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    ends = numpy.sort(surface.triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    edges = numpy.unique(ends, axis=0)
    count = len(surface.points)
    graph = coo_array((numpy.ones(len(edges)), (edges[:, 0], edges[:, 1])), shape=(count, count))
    pieces, _ = connected_components(graph, directed=False)
    return int(pieces), int(count - len(edges) + len(surface.triangles))
