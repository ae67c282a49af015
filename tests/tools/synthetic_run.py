"""A run's directory made from a known body of revolution, without any simulation."""

import math
import sys
from pathlib import Path

import numpy

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "python"))

COLUMNS = (
    "step,time,vesicle,area,area_ratio,volume,reduced_volume,bending_energy,mean_curvature_integral,"
    "gaussian_curvature_over_pi,inertia_1,inertia_2,inertia_3,x,y,z,vx,vy,vz,deformation_index,taylor_deformation,"
    "inclination,tension,max_speed,mass_drift,gap"
).split(",")

RESOLVED = """title = "A test vesicle"
[fluid]
kinematic_viscosity = 0.5
density = 1.0
[vesicle_type.rbc.bending]
modulus = 0.25
spontaneous_curvature = 0.0
[[vesicle]]
type = "rbc"
"""


def revolve(meridian, around=72, axis=(0.3, -0.5, 0.81), centre=(31.0, 33.0, 30.5)):
    """(points, triangles, curvature) of the meridian turned about the axis; triangles counter-clockwise from outside."""
    step = max(1, (len(meridian.s) - 1) // 80)
    keep = numpy.arange(0, len(meridian.s), step)
    r, z = meridian.r[keep], meridian.z[keep]
    angle = 2.0 * math.pi * numpy.arange(around) / around
    rings = numpy.stack((numpy.outer(r[1:-1], numpy.cos(angle)), numpy.outer(r[1:-1], numpy.sin(angle)),
                         numpy.repeat(z[1:-1, None], around, axis=1)), axis=-1)
    points = numpy.concatenate(([[0.0, 0.0, z[0]]], rings.reshape(-1, 3), [[0.0, 0.0, z[-1]]]))
    last = len(points) - 1
    triangles = []
    for j in range(around):
        k = (j + 1) % around
        triangles.append((0, 1 + j, 1 + k))
        triangles.append((last, last - around + k, last - around + j))
        for i in range(len(keep) - 3):
            a, b, c, d = (1 + i * around + j, 1 + i * around + k, 1 + (i + 1) * around + j, 1 + (i + 1) * around + k)
            triangles.extend(((a, c, b), (b, c, d)))
    psi = numpy.unwrap(numpy.arctan2(-numpy.gradient(meridian.z, meridian.s), numpy.gradient(meridian.r, meridian.s)))
    bend = numpy.gradient(psi, meridian.s)
    round_axis = numpy.where(meridian.r > 1e-6 * meridian.r.max(), numpy.sin(psi) / numpy.maximum(meridian.r, 1e-9), bend)
    H = 0.5 * (bend + round_axis)[keep]
    H[0], H[-1] = H[1], H[-2]
    curvature = numpy.concatenate((H[:1], numpy.repeat(H[1:-1], around), H[-1:]))
    return points @ _frame(axis) + numpy.asarray(centre), numpy.array(triangles), curvature


def write_run(folder, points=None, triangles=None, curvature=None, rows=None, resolved=RESOLVED, step=400):
    """Writes metrics.csv, resolved.toml and, when points are given, one surface with its series."""
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    if rows is not None:
        lines = [",".join(COLUMNS)]
        lines += [",".join(f"{row.get(name, 0.0):.17g}" for name in COLUMNS) for row in rows]
        (folder / "metrics.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")
    if resolved is not None:
        (folder / "resolved.toml").write_text(resolved, encoding="utf-8")
    if points is not None:
        surfaces = folder / "surfaces"
        surfaces.mkdir(exist_ok=True)
        name = f"surface_{step:09d}.vtp"
        write_surface(surfaces / name, points, triangles, curvature)
        (surfaces / "surfaces.pvd").write_text(
            '<?xml version="1.0"?>\n<VTKFile type="Collection" version="0.1"><Collection>'
            f'<DataSet timestep="{step}" file="{name}"/></Collection></VTKFile>\n', encoding="utf-8")
    return folder


def write_surface(path, points, triangles, curvature=None):
    from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
    from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

    data = vtkPolyData()
    nodes = vtkPoints()
    nodes.SetData(numpy_to_vtk(numpy.ascontiguousarray(points), deep=True))
    data.SetPoints(nodes)
    cells = vtkCellArray()
    offsets = numpy.arange(0, 3 * len(triangles) + 1, 3, dtype=numpy.int64)
    cells.SetData(numpy_to_vtkIdTypeArray(offsets, deep=True),
                  numpy_to_vtkIdTypeArray(numpy.ascontiguousarray(triangles, dtype=numpy.int64).ravel(), deep=True))
    data.SetPolys(cells)
    if curvature is not None:
        array = numpy_to_vtk(numpy.ascontiguousarray(curvature), deep=True)
        array.SetName("mean_curvature")
        data.GetPointData().AddArray(array)
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(data)
    writer.Write()


def sample(step, reduced_volume, volume, energy, **others):
    """A row of metrics.csv; columns not named are zero, `area_ratio` one."""
    area = (6.0 * math.sqrt(math.pi) * volume / reduced_volume) ** (2.0 / 3.0)
    row = {"step": step, "time": step, "vesicle": 0, "area": area, "area_ratio": 1.0, "volume": volume,
           "reduced_volume": reduced_volume, "bending_energy": energy}
    row.update(others)
    return row


def _frame(axis):
    """Rows: two directions across the axis, and the axis."""
    axis = numpy.asarray(axis, dtype=float) / numpy.linalg.norm(axis)
    across = numpy.cross(axis, (1.0, 0.0, 0.0) if abs(axis[0]) < 0.9 else (0.0, 1.0, 0.0))
    across /= numpy.linalg.norm(across)
    return numpy.array([across, numpy.cross(axis, across), axis])
