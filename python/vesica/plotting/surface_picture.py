"""surface.png: surfaces coloured by what is known on them."""

import math
import tempfile
from pathlib import Path

import numpy
from matplotlib import cm, colormaps, colors, image, tri
from matplotlib.collections import TriMesh

from vesica.plotting import style, view, vtk_rendering
from vesica.errors import Unavailable

LIGHT = numpy.array([-0.35, 0.5, 0.8])  # right, up, towards the eye


LABELS = {
    "mean_curvature": "mean curvature H (1/cells), sphere +",
    "gaussian_curvature": "Gaussian curvature K (1/cells²)",
    "bending_force": "bending force per area, outwards +",
    "tension_force": "constant tension's force per area, outwards +",
    "area_force": "area constraint's force per area, outwards +",
    "total_force": "membrane's force per area, outwards +",
    "velocity": "speed (cells per step)",
}
PLAIN = "#B5483A"


@style.in_style
def draw(surface, title, colour_by="mean_curvature", with_vtk=True):
    """Returns (figure, one line that says what it shows). With VTK where it can render without a display, else by
    matplotlib's painter, which the picture's line then says."""
    colours, norm, colour_map = paint(surface, colour_by)
    camera = view.choose(surface)
    shape_ratio = camera.half_height / camera.half_width
    figure = style.new_figure(8.0, 1.3 + 6.6 * min(shape_ratio, 1.2))
    axes = figure.add_axes([0.02, 0.05, 0.82, 0.85] if norm else [0.05, 0.05, 0.9, 0.85])
    extent = (-camera.half_width, camera.half_width, -camera.half_height, camera.half_height)
    pixels = pixels_of(surface, colours, camera) if with_vtk else None
    if pixels is not None:
        axes.imshow(pixels, extent=extent)
    else:
        _draw_with_matplotlib(axes, surface, colours, camera)
    axes.set_xlim(extent[:2])
    foot = 0.16 * min(camera.half_width, camera.half_height)  # room for the scale below the surface
    axes.set_ylim(extent[2] - foot, extent[3])
    axes.set_aspect("equal")
    axes.axis("off")
    many = "vesicle" in surface.fields and len(numpy.unique(surface.fields["vesicle"])) > 1
    radius = (3.0 * abs(surface.volume()) / (4.0 * math.pi)) ** (1.0 / 3.0)
    _draw_scale(axes, camera, foot, 10.0 if many else radius, "10 cells" if many else f"R0 = {radius:.1f} cells")
    if norm:
        _draw_bar(figure, norm, colour_map, LABELS.get(colour_by, colour_by))
    figure.text(0.02, 0.97, title, fontweight="bold", fontsize=11, va="top")
    how = "by VTK" if pixels is not None else "by matplotlib, since VTK finds no display to render with"
    colouring = colour_by.replace("_", " ") if colour_by else "one colour"
    return figure, f"the surface coloured by {colouring}, drawn {how}"


def paint(surface, colour_by):
    """(n, 4) colours of the points; the range and the map of their bar, or None without one."""
    if colour_by is None:
        return numpy.tile(colors.to_rgba(PLAIN), (len(surface.points), 1)), None, None
    values = surface.fields.get(colour_by)
    if colour_by == "vesicle":
        indices = numpy.zeros(len(surface.points), int) if values is None else values
        return numpy.array([colors.to_rgba(c) for c in style.CYCLE])[indices % len(style.CYCLE)], None, None
    if values is None or not numpy.isfinite(values).any():
        known = ", ".join([*surface.fields, "vesicle"])
        raise Unavailable(f"the surface carries no {colour_by}; what it carries: {known}")
    if values.ndim > 1:
        values = numpy.linalg.norm(values, axis=1)
    norm = _range(values, surface.point_areas())
    colour_map = "viridis"
    if colour_by.endswith("_force"):  # of either sign: white is none
        most = max(abs(norm.vmin), abs(norm.vmax))
        norm, colour_map = colors.Normalize(-most, most, clip=True), "RdBu_r"
    return colormaps[colour_map](norm(numpy.nan_to_num(values, nan=norm.vmin))), norm, colour_map


def _draw_bar(figure, norm, colour_map, label):
    beside = figure.add_axes([0.86, 0.14, 0.022, 0.66])
    beside.grid(False)
    bar = figure.colorbar(cm.ScalarMappable(norm, colour_map), cax=beside, extend="both")
    bar.outline.set_visible(False)
    bar.formatter.set_powerlimits((-3, 4))
    bar.formatter.set_useMathText(True)
    bar.set_label(label)


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


def pixels_of(surface, colours, camera):
    """(height, width, 3 or 4) as VTK renders it; None where it cannot."""
    with tempfile.TemporaryDirectory() as folder:
        picture = Path(folder) / "surface.png"
        if not vtk_rendering.render(surface, colours, camera, Path(folder) / "scene.npz", picture):
            return None
        return image.imread(picture)


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


def _draw_scale(axes, camera, foot, length, text):
    """A bar as long as R0 = (3 V/(4 pi))^(1/3), or as ten cells beside several vesicles."""
    right, low = 0.98 * camera.half_width, -camera.half_height - 0.6 * foot
    axes.plot([right - length, right], [low, low], color=style.INK, linewidth=2.0, solid_capstyle="butt", clip_on=False)
    axes.annotate(text, (right - length, low), xytext=(-6, 0), textcoords="offset points", ha="right", va="center",
                  fontsize=9)
