"""surface.png: the vesicle's surface coloured by its mean curvature."""

import math
import tempfile
from pathlib import Path

import numpy
from matplotlib import cm, colormaps, colors, image, pyplot, tri
from matplotlib.collections import TriMesh

from plotting import style, view, vtk_rendering
from plotting.run_directory import Unavailable

LIGHT = numpy.array([-0.35, 0.5, 0.8])  # right, up, towards the eye


def draw(surface, title, with_vtk=True):
    """Returns (figure, one line that says what it shows). With VTK where it can render without a display, else by
    matplotlib's painter, which the picture's line then says."""
    curvature = surface.fields.get("mean_curvature")
    if curvature is None or not numpy.isfinite(curvature).any():
        raise Unavailable("the surface carries no mean_curvature")
    norm = _range(curvature, surface.point_areas())
    colours = colormaps["viridis"](norm(numpy.nan_to_num(curvature, nan=norm.vmin)))
    camera = view.choose(surface)

    shape_ratio = camera.half_height / camera.half_width
    figure = pyplot.figure(figsize=(8.0, 1.3 + 6.6 * min(shape_ratio, 1.2)))
    axes = figure.add_axes([0.02, 0.05, 0.82, 0.85])
    rendered = with_vtk and _draw_with_vtk(axes, surface, colours, camera)
    if not rendered:
        _draw_with_matplotlib(axes, surface, colours, camera)
    axes.set_xlim(-camera.half_width, camera.half_width)
    axes.set_ylim(-camera.half_height, camera.half_height)
    axes.set_aspect("equal")
    axes.axis("off")
    radius = (3.0 * abs(surface.volume()) / (4.0 * math.pi)) ** (1.0 / 3.0)
    _draw_scale(axes, camera, radius)

    beside = figure.add_axes([0.86, 0.14, 0.022, 0.66])
    beside.grid(False)
    bar = figure.colorbar(cm.ScalarMappable(norm, "viridis"), cax=beside, extend="both")
    bar.outline.set_visible(False)
    bar.set_label("mean curvature H (1/cells), sphere +")
    figure.text(0.02, 0.97, f"{title}: the surface", fontweight="bold", fontsize=11, va="top")
    how = "by VTK" if rendered else "by matplotlib, since VTK finds no display to render with"
    return figure, f"the final surface coloured by mean curvature, drawn {how}"


def _range(curvature, areas):
    """From the 1st to the 99th percentile of the area: a few bad points must not take the colours."""
    finite = numpy.isfinite(curvature)
    order = numpy.argsort(curvature[finite])
    share = numpy.cumsum(areas[finite][order])
    low, high = numpy.interp([0.01, 0.99], share / share[-1], curvature[finite][order])
    if high - low < 1e-3 * max(abs(low), abs(high), 1e-12):  # a sphere: the colours would show round-off
        middle = 0.5 * (low + high)
        low, high = middle - 0.1 * abs(middle) - 1e-12, middle + 0.1 * abs(middle) + 1e-12
    return colors.Normalize(low, high, clip=True)


def _draw_with_vtk(axes, surface, colours, camera):
    with tempfile.TemporaryDirectory() as folder:
        picture = Path(folder) / "surface.png"
        if not vtk_rendering.render(surface, colours, camera, Path(folder) / "scene.npz", picture):
            return False
        pixels = image.imread(picture)
    axes.imshow(pixels, extent=(-camera.half_width, camera.half_width, -camera.half_height, camera.half_height))
    return True


def _draw_with_matplotlib(axes, surface, colours, camera):
    """Painter's algorithm: triangles that face the eye, from the farthest to the nearest, shaded at their corners."""
    projected = camera.project(surface.points)
    facing = surface.face_areas() @ camera.frame[2] > 0.0
    triangles = surface.triangles[facing]
    triangles = triangles[numpy.argsort(projected[triangles, 2].mean(axis=1))]
    light = LIGHT / numpy.linalg.norm(LIGHT)
    normals = surface.normals() @ camera.frame.T
    shade = 0.45 + 0.55 * numpy.maximum(normals @ light, 0.0)
    shine = 0.18 * numpy.maximum((2.0 * (normals @ light)[:, None] * normals - light)[:, 2], 0.0) ** 20
    lit = colours.copy()
    lit[:, :3] = numpy.clip(colours[:, :3] * shade[:, None] + shine[:, None], 0.0, 1.0)
    mesh = TriMesh(tri.Triangulation(projected[:, 0], projected[:, 1], triangles))
    mesh.set_facecolor(lit)
    axes.add_collection(mesh)


def _draw_scale(axes, camera, radius):
    """A bar as long as R0 = (3 V/(4 pi))^(1/3)."""
    right, low = 0.98 * camera.half_width, -0.99 * camera.half_height
    axes.plot([right - radius, right], [low, low], color=style.INK, linewidth=2.0, solid_capstyle="butt", clip_on=False)
    axes.annotate(f"R0 = {radius:.1f} cells", (right - 0.5 * radius, low), xytext=(0, 4), textcoords="offset points",
                  ha="center", va="bottom", fontsize=9)
