"""Two vesicles of one run: what each keeps, how close they come, and the symmetry between them.

Everything is of the samples of metrics.csv or of the surfaces written; `finished` is a run that has ended as it should.
"""

import numpy
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from vesica.plotting.surface import read_surface


def both(finished):
    """The samples of vesicle 0 and of vesicle 1, column -> array."""
    return finished.run.metrics(0), finished.run.metrics(1)


def greatest_area_error(finished, settled):
    """Of |A/A_0 - 1| in either, A_0 the area of its exact first shape, from step `settled` on: the first steps are those
    in which a layer drawn from a shape becomes the lattice's own."""
    return max(float(numpy.abs(m["area_ratio"] - 1.0)[m["step"] >= settled].max()) for m in both(finished))


def greatest_mass_drift(finished):
    """Relative, of either, over all samples."""
    return max(float(numpy.abs(m["mass_drift"]).max()) for m in both(finished))


def least_gap(finished):
    """The least of all samples, of those where the two are close enough to have one; NaN if they never are."""
    gaps = numpy.concatenate([m["gap"] for m in both(finished)])
    return float(numpy.nanmin(gaps)) if numpy.isfinite(gaps).any() else float("nan")


def separation(finished, axis):
    """Of vesicle 1 from vesicle 0 along "x", "y" or "z", over the samples."""
    first, second = both(finished)
    return second[axis] - first[axis]


def half_turn_asymmetry(finished, size):
    """The greatest distance, in cells, of vesicle 1 from where a half turn about the line x = size_x/2, z = size_z/2
    would put vesicle 0, over all samples."""
    first, second = both(finished)
    off = (first["x"] + second["x"] - size[0], first["y"] - second["y"], first["z"] + second["z"] - size[2])
    return float(numpy.abs(off).max())


def surface_files(finished):
    """(step, path) of the surfaces written, ascending."""
    paths = sorted((finished.directory / "surfaces").glob("surface_*.vtp"))
    return [(int(path.stem.rpartition("_")[2]), path) for path in paths]


def is_one_sphere(surface):
    """Whether the triangles are one piece of Euler number 2."""
    ends = numpy.sort(surface.triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    edges = numpy.unique(ends, axis=0)
    count = len(surface.points)
    graph = coo_array((numpy.ones(len(edges)), (edges[:, 0], edges[:, 1])), shape=(count, count))
    pieces, _ = connected_components(graph, directed=False)
    return pieces == 1 and count - len(edges) + len(surface.triangles) == 2


def torn_surfaces(finished):
    """How many of the vesicles' surfaces written are not one piece of Euler number 2."""
    cell = finished.run.cell_length()
    return sum(not is_one_sphere(read_surface(path, vesicle).in_cells(cell))
               for _, path in surface_files(finished) for vesicle in (0, 1))  # fmt: skip


def surface_distance(path, periods):
    """Between the nearest points of the two surfaces in a file, over the images that `periods` (0: none) has; what the
    metrics' gap, which comes from the layers, can be laid beside. Too large by up to the square of a triangle's edge
    over eight times the distance, being between corners."""
    first, second = (read_surface(path, vesicle).points for vesicle in (0, 1))
    tree = cKDTree(first)
    shifts = numpy.array(numpy.meshgrid(*[(-p, 0.0, p) if p else (0.0,) for p in periods])).reshape(3, -1).T
    return float(min(tree.query(second + shift)[0].min() for shift in shifts))


def judge_integrity(results, finished, conditions, settled, area_within):
    """The laws that any two vesicles keep, however close they come."""
    results.at_least("least gap between them, cells", conditions, least_gap(finished), 0.0)
    files = len(surface_files(finished))
    results.at_most(f"surfaces that are not one piece of Euler number 2, of {2 * files}", conditions,
                    torn_surfaces(finished) if files else float("nan"), 0)  # fmt: skip
    results.at_most("mass drift of either, relative", conditions, greatest_mass_drift(finished), 1e-10)
    results.at_most(f"change of either's area, relative, from step {settled} on", conditions,
                    greatest_area_error(finished, settled), area_within)  # fmt: skip
