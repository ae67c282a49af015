"""The inertia tensor as the paper sums it (Eq 65): rho_red over whole cells, with the diffuse layer's share in it."""

import math

import h5py
import numpy


def last_field(finished, name, step=None):
    """Shape (nz, ny, nx) as written; of the last sample, or of a step."""
    paths = sorted((finished.directory / "fields").glob("step_*.h5"))
    if step is not None:
        paths = [p for p in paths if int(p.stem.rpartition("_")[2]) == step]
    with h5py.File(paths[-1]) as file:
        return file[name][...]


def field_steps(finished):
    return sorted(int(p.stem.rpartition("_")[2]) for p in (finished.directory / "fields").glob("step_*.h5"))


def raw_eigenvalues(phase):
    """Ascending; about the centre of what is summed. The vesicle must not cross the box's ends."""
    share = 0.5 * (1.0 + phase)
    share[share < 1e-9] = 0.0
    z, y, x = numpy.meshgrid(*[numpy.arange(n) + 0.5 for n in phase.shape], indexing="ij")
    points = numpy.stack((x.ravel(), y.ravel(), z.ravel()), axis=1)
    weights = share.ravel()
    kept = weights > 0.0
    points, weights = points[kept], weights[kept]
    points = points - numpy.average(points, axis=0, weights=weights)
    second = numpy.einsum("i,ij,ik->jk", weights, points, points)
    return numpy.linalg.eigvalsh(numpy.trace(second) * numpy.eye(3) - second)


def meridian_inertia(curve, layer_moment):
    """(axial, transverse) of the body inside an exact meridian, raw: with what a layer of second moment <s^2> adds,
    (<s^2>/2) int (n.grad q + 2 H q) dA = (<s^2>/2) d/ds int q dA over the parallel surfaces. 0: the solid body's own."""

    def body(m):
        disc = numpy.pi * m.r**2
        axial = abs(numpy.trapz(0.5 * disc * m.r**2, m.z))
        along = abs(numpy.trapz(disc * m.z**2, m.z))
        return numpy.array([axial, 0.5 * axial + along])

    if layer_moment == 0.0:
        return body(curve)
    # The layer blurs the body: int_V(s) q over parallel surfaces, second derivative in s.
    h = 0.05
    shifted = [body(parallel(curve, s)) for s in (-h, 0.0, h)]
    return shifted[1] + 0.5 * layer_moment * (shifted[0] - 2 * shifted[1] + shifted[2]) / h**2


def parallel(curve, s):
    """The meridian at distance s outside."""
    dr, dz = numpy.gradient(curve.r, curve.s), numpy.gradient(curve.z, curve.s)
    length = numpy.hypot(dr, dz)
    return type(curve)(numpy.maximum(curve.r - s * dz / length, 0.0), curve.z + s * dr / length, curve.s)


def torus_inertia(area, volume, layer_moment):
    """(axial, transverse) of the circular torus of this area and volume, raw likewise, and its radii (ring, tube)."""
    tube = 2 * volume / area
    ring = volume / (2 * math.pi**2 * tube**2)

    def body(a):
        mass = 2 * math.pi**2 * ring * a * a
        return mass * numpy.array([ring**2 + 0.75 * a * a, 0.5 * ring**2 + 0.625 * a * a])

    h = 0.05
    blur = 0.5 * layer_moment * (body(tube - h) - 2 * body(tube) + body(tube + h)) / h**2
    return body(tube) + blur, (ring, tube)
