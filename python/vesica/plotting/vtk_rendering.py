"""Draws a coloured surface with VTK into a file. A program of its own: where there is no display VTK ends the whole
process, and only another process can tell.

    python -m vesica.plotting.vtk_rendering SCENE.npz PICTURE.png
"""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import numpy

HEIGHT = 900  # pixels


def render(surface, colours, view, scene, picture):
    """Renders through a child process. Returns whether it worked. `scene` and `picture` are paths to write to."""
    numpy.savez(scene, points=surface.points, triangles=surface.triangles, normals=surface.normals(),
                colours=colours, frame=view.frame, centre=view.centre,
                half=[view.half_width, view.half_height])
    command = [sys.executable, "-m", "vesica.plotting.vtk_rendering", str(scene), str(picture)]
    if not os.environ.get("DISPLAY"):
        if not shutil.which("xvfb-run"):
            return False
        command = ["xvfb-run", "-a", "-s", "-screen 0 1600x1200x24"] + command
    environment = dict(os.environ, PYTHONPATH=str(Path(__file__).resolve().parents[2]))
    try:
        done = subprocess.run(command, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                              timeout=120, check=False)
    except (OSError, subprocess.TimeoutExpired):
        return False
    return done.returncode == 0 and Path(picture).is_file()


def _main(scene_path, picture_path):
    import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  (registers the renderer)
    from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
    from vtkmodules.vtkIOImage import vtkPNGWriter
    from vtkmodules.vtkRenderingCore import (vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow,
                                             vtkWindowToImageFilter)

    scene = numpy.load(scene_path)
    points = vtkPoints()
    points.SetData(numpy_to_vtk(scene["points"], deep=True))
    cells = vtkCellArray()
    triangles = scene["triangles"].astype(numpy.int64)
    offsets = numpy.arange(0, 3 * len(triangles) + 1, 3, dtype=numpy.int64)
    cells.SetData(numpy_to_vtkIdTypeArray(offsets, deep=True), numpy_to_vtkIdTypeArray(triangles.ravel(), deep=True))
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetPolys(cells)
    data.GetPointData().SetNormals(numpy_to_vtk(scene["normals"], deep=True))
    data.GetPointData().SetScalars(numpy_to_vtk((255 * scene["colours"][:, :3]).astype(numpy.uint8), deep=True))

    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    actor = vtkActor()
    actor.SetMapper(mapper)
    surface = actor.GetProperty()
    surface.SetInterpolationToPhong()
    surface.SetAmbient(0.35)
    surface.SetDiffuse(0.65)
    surface.SetSpecular(0.15)
    surface.SetSpecularPower(20)
    renderer = vtkRenderer()
    renderer.SetBackground(1.0, 1.0, 1.0)
    renderer.AddActor(actor)

    half_width, half_height = scene["half"]
    right, up, eye = scene["frame"]
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetFocalPoint(*scene["centre"])
    camera.SetPosition(*(scene["centre"] + 10.0 * max(half_width, half_height) * eye))
    camera.SetViewUp(*up)
    camera.SetParallelScale(half_height)
    renderer.ResetCameraClippingRange()

    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(int(round(HEIGHT * half_width / half_height)), HEIGHT)
    window.AddRenderer(renderer)
    window.Render()
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetFileName(picture_path)
    writer.SetInputConnection(grab.GetOutputPort())
    writer.Write()


if __name__ == "__main__":
    _main(*sys.argv[1:])
