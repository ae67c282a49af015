"""Fig 9: surfaces of the discocyte of Fig 8, seen along its axis."""

import numpy

from drawing import frame_from, paint
from items import shear_recovery
from items.shear_recovery import choices, times
from shared import read_surface, surface_files

TITLE = "Surfaces in shear and after it (Fig 9)"
PAPER = "Surfaces of Fig 8's run along the axis of symmetry; those at 40,000 and 110,000 steps are 'identical'."


def plan(quick):
    return shear_recovery.plan(quick)[:1]


def judge(item, finished):
    run = next(iter(finished.values()))
    choices(item)
    if run.failure is not None:
        return
    start, stop, end = times(item.quick)
    files = dict(surface_files(run))
    shown = [s for s in files if s >= start][:8]
    surfaces = {s: read_surface(files[s]) for s in {start, stop, end, *shown} if s in files}
    paper = item.against("paper")
    within = 1.0 if item.quick else 0.15
    paper.at_most("distance of the last surface from that before the shear, rms, cells", f"steps {start} and {end}", _apart(surfaces[start], surfaces[end]), within)
    item.results.report("the same of the sheared surface, rms, cells", f"steps {start} and {stop}", _apart(surfaces[start], surfaces[stop]))
    item.csv("widths.csv", ("step", "along x", "along y", "along z"), [(s, *map(float, numpy.ptp(surface.points, axis=0))) for s, surface in sorted(surfaces.items())])
    item.picture("surfaces.png", _figure(sorted(surfaces.items()), start, stop), "Seen along the axis of symmetry, the flow to the right; the shear is on from the first to the time given.")


def _apart(one, other):
    """rms distance of one's points from the other's surface, its points being half a cell apart; after both are centred."""
    from scipy.spatial import cKDTree

    a, b = (s.points - s.centre() for s in (one, other))
    middles = b[other.triangles].mean(axis=1)
    faces = other.face_areas()
    _, nearest = cKDTree(middles).query(a)
    normals = faces[nearest] / numpy.linalg.norm(faces[nearest], axis=1, keepdims=True)
    distance = ((a - middles[nearest]) * normals).sum(axis=1)
    return float(numpy.sqrt((distance**2).mean()))


def _figure(surfaces, start, stop):
    from matplotlib import pyplot

    columns = min(4, len(surfaces))
    rows = -(-len(surfaces) // columns)
    figure, panels = pyplot.subplots(rows, columns, figsize=(8.0, 2.2 * rows), squeeze=False, constrained_layout=True)
    for axes in panels.flat:
        axes.axis("off")
    for axes, (step, surface) in zip(panels.flat, surfaces):
        paint(axes, surface, frame_from((0.0, -1.0, 0.0)))
        axes.set_title(f"{step}" + (", shear on" if start < step <= stop else ""), fontsize=9)
    return figure
