"""Surfaces in Matplotlib's axes: several in one figure, coloured or in one semi-transparent colour as in the paper."""

import numpy
from matplotlib import colormaps, colors, tri
from matplotlib.collections import PolyCollection, TriMesh

LIGHT = numpy.array([-0.35, 0.5, 0.8])  # right, up, towards the eye
PAPER_RED = "#C8442F"


def frame_from(eye, up=(0.0, 0.0, 1.0)):
    """Rows right, up, towards the eye."""
    eye = numpy.asarray(eye, dtype=float) / numpy.linalg.norm(eye)
    right = numpy.cross(up, eye)
    if numpy.linalg.norm(right) < 1e-9:
        right = numpy.cross((0.0, 1.0, 0.0), eye)
    right /= numpy.linalg.norm(right)
    return numpy.array([right, numpy.cross(eye, right), eye])


def paint(axes, surface, frame, *, values=None, norm=None, cmap="viridis", colour=PAPER_RED, alpha=1.0, centre=None):
    """Painter's algorithm. With alpha below 1 the far side shows through."""
    centre = surface.centre() if centre is None else numpy.asarray(centre)
    projected = (surface.points - centre) @ frame.T
    faces = surface.face_areas() @ frame[2]
    normals = surface.normals() @ frame.T
    light = LIGHT / numpy.linalg.norm(LIGHT)
    if values is not None:
        norm = norm or colors.Normalize(*numpy.percentile(values, (1, 99)), clip=True)
        base = colormaps[cmap](norm(values))
    else:
        base = numpy.tile(colors.to_rgba(colour), (len(projected), 1))
    for front in (False, True) if alpha < 1.0 else (True,):
        side = 1.0 if front else -1.0
        triangles = surface.triangles[side * faces > 0.0]
        triangles = triangles[numpy.argsort(projected[triangles, 2].mean(axis=1))]
        shade = 0.5 + 0.5 * numpy.maximum(side * normals @ light, 0.0)
        lit = base.copy()
        lit[:, :3] = numpy.clip(base[:, :3] * shade[:, None], 0.0, 1.0)
        lit[:, 3] = alpha
        if alpha < 1.0:  # smooth shading would show the seams of the triangles
            corners = projected[triangles][:, :, :2]
            axes.add_collection(PolyCollection(corners, facecolors=lit[triangles].mean(axis=1), linewidths=0, antialiased=False, rasterized=True))
            continue
        mesh = TriMesh(tri.Triangulation(projected[:, 0], projected[:, 1], triangles), rasterized=True)
        mesh.set_facecolor(lit)
        axes.add_collection(mesh)
    half = 1.05 * numpy.abs(projected[:, :2]).max()
    axes.set_xlim(-half, half)
    axes.set_ylim(-half, half)
    axes.set_aspect("equal")
    axes.axis("off")
    return norm
