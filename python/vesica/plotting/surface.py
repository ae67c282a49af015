"""Reading surfaces, and folding their points into the meridian plane."""

from dataclasses import dataclass
from pathlib import Path

import numpy

from vesica.errors import Unavailable
from vesica.surface import Surface


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


def read_surface(path, vesicle=0, every=False):
    """One vesicle of a .vtp file, or every one, told apart by the field `vesicle`; OSError when it cannot be read,
    Unavailable when the vesicle is not in it."""
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
    if face_labels is not None and every:
        fields["vesicle"] = numpy.zeros(len(points), dtype=int)
        fields["vesicle"][triangles] = face_labels.astype(int)[:, None]
    elif face_labels is not None:
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
