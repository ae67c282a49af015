"""A triangulated vesicle: reading it, its areas, its axis, and its points folded into the meridian plane."""

from dataclasses import dataclass
from pathlib import Path

import numpy

from plotting.run_directory import Unavailable


@dataclass(frozen=True)
class Surface:
    """A closed surface in cells; triangles counter-clockwise seen from outside."""

    points: numpy.ndarray  # (n, 3)
    triangles: numpy.ndarray  # (m, 3)
    fields: dict  # name -> (n,) or (n, k), values on the points

    def in_cells(self, cell):
        """The same surface when a cell is `cell` long in the units it was written in."""
        fields = dict(self.fields)
        if "mean_curvature" in fields:
            fields["mean_curvature"] = fields["mean_curvature"] * cell
        if "gaussian_curvature" in fields:
            fields["gaussian_curvature"] = fields["gaussian_curvature"] * cell**2
        return Surface(self.points / cell, self.triangles, fields)

    def face_areas(self):
        """(m, 3): the triangles' outward normals times their areas."""
        a, b, c = (self.points[self.triangles[:, k]] for k in range(3))
        return 0.5 * numpy.cross(b - a, c - a)

    def point_areas(self):
        """(n,): a third of the area of every triangle that meets in the point."""
        thirds = numpy.linalg.norm(self.face_areas(), axis=1) / 3.0
        return numpy.bincount(self.triangles.ravel(), numpy.repeat(thirds, 3), len(self.points))

    def area(self):
        return float(numpy.linalg.norm(self.face_areas(), axis=1).sum())

    def normals(self):
        """(n, 3): outward unit normals of the points, averaged over their triangles."""
        sums = numpy.zeros_like(self.points)
        faces = self.face_areas()
        for k in range(3):
            numpy.add.at(sums, self.triangles[:, k], faces)
        return sums / numpy.maximum(numpy.linalg.norm(sums, axis=1, keepdims=True), 1e-300)

    def volume(self):
        return float(numpy.einsum("ij,ij->", self._middles(), self.face_areas()) / 3.0)

    def centre(self):
        """Centre of the enclosed volume, from tetrahedra over a point close by."""
        origin = self.points.mean(axis=0)
        a, b, c = (self.points[self.triangles[:, k]] - origin for k in range(3))
        volumes = numpy.einsum("ij,ij->i", a, numpy.cross(b, c)) / 6.0
        return origin + numpy.einsum("i,ij->j", volumes, (a + b + c) / 4.0) / volumes.sum()

    def principal_spreads(self):
        """Ascending area-weighted mean squares of the distances from the centre along three axes, and the axes
        as columns of a right-handed frame."""
        offsets = self.points - self.centre()
        weights = self.point_areas()
        spreads, axes = numpy.linalg.eigh(numpy.einsum("i,ij,ik->jk", weights, offsets, offsets) / weights.sum())
        axes[:, 2] *= numpy.sign(numpy.linalg.det(axes))
        return spreads, axes

    def _middles(self):
        return self.points[self.triangles].mean(axis=1)


@dataclass(frozen=True)
class FoldedSurface:
    """The points of a surface in the plane (distance from its axis, height along it), origin in the centre."""

    r: numpy.ndarray
    z: numpy.ndarray
    weights: numpy.ndarray  # the points' areas
    axis: numpy.ndarray
    asymmetry: float  # 0 for a body of revolution: relative difference of the two spreads across the axis


def fold(surface):
    """Folds a surface about the principal axis whose spread differs most from those of the other two."""
    spreads, axes = surface.principal_spreads()
    along = 0 if spreads[1] - spreads[0] > spreads[2] - spreads[1] else 2
    across = [k for k in range(3) if k != along]
    axis = axes[:, along] * (1.0 if axes[numpy.abs(axes[:, along]).argmax(), along] > 0.0 else -1.0)
    offsets = surface.points - surface.centre()
    z = offsets @ axis
    r = numpy.sqrt(numpy.maximum((offsets**2).sum(axis=1) - z**2, 0.0))
    asymmetry = abs(spreads[across[1]] - spreads[across[0]]) / spreads[across].mean()
    return FoldedSurface(r, z, surface.point_areas(), axis, float(asymmetry))


def read_surface(path, vesicle=0):
    """One vesicle of a .vtp file; OSError when it cannot be read, Unavailable when the vesicle is not in it."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkCommonCore import vtkObject
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

    reader = vtkXMLPolyDataReader()
    if not Path(path).is_file() or not reader.CanReadFile(str(path)):
        raise OSError(f"{path}: is no surface that VTK can read (.vtp)")
    vtkObject.GlobalWarningDisplayOff()
    reader.SetFileName(str(path))
    reader.Update()
    data = reader.GetOutput()
    if reader.GetErrorCode() or data.GetNumberOfPoints() == 0 or data.GetNumberOfPolys() == 0:
        raise OSError(f"{path}: holds no triangles, or is damaged")

    points = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
    cells = vtk_to_numpy(data.GetPolys().GetConnectivityArray())
    sizes = numpy.diff(vtk_to_numpy(data.GetPolys().GetOffsetsArray()))
    if (sizes != 3).any():
        raise OSError(f"{path}: holds polygons; expected triangles only")
    triangles = cells.reshape(-1, 3).astype(numpy.int64)
    if not numpy.isfinite(points).all():
        raise OSError(f"{path}: holds points that are not finite")

    fields = _arrays(data.GetPointData(), vtk_to_numpy)
    labels = fields.get("vesicle")
    face_labels = labels[triangles[:, 0]] if labels is not None else _arrays(data.GetCellData(), vtk_to_numpy).get("vesicle")
    if face_labels is not None:
        triangles = triangles[face_labels == vesicle]
    if len(triangles) == 0:
        raise Unavailable(f"{path}: vesicle {vesicle} is not in it")
    return _without_unused(Surface(points, triangles, fields))


def _arrays(data, to_numpy):
    return {data.GetArrayName(k): to_numpy(data.GetArray(k)) for k in range(data.GetNumberOfArrays()) if data.GetArray(k)}


def _without_unused(surface):
    used, renumbered = numpy.unique(surface.triangles, return_inverse=True)
    fields = {name: values[used] for name, values in surface.fields.items()}
    compact = Surface(surface.points[used], renumbered.reshape(-1, 3), fields)
    if compact.volume() < 0.0:  # some writers turn the triangles inwards
        compact = Surface(compact.points, compact.triangles[:, ::-1].copy(), fields)
    return compact
