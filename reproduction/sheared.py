"""A discocyte whose axis lies along the vorticity: the paper's Wheeler test and its shear recovery."""

import math

import numpy

from runs import REDUCED_VOLUME
from shared import OWN_CASES, Simulation

CASE = OWN_CASES / "shear.toml"


def capillary(rate, radius, kappa, viscosity):
    """Ca_kappa = eta gamma R0^3/kappa."""
    return viscosity * rate * radius**3 / kappa


def sheared(name, *, radius, kappa, nu, rate, steps, size, ratio=1.0, start=0, stop=None, settings=None, options=()):
    """An exact discocyte of Upsilon = 1.31 between walls; gradient z, flow x, axis y."""
    return Simulation(name, CASE, {
        "lattice.size": size,
        "vesicle[0].centre": [size[0] / 2, size[1] / 2 + 0.5, size[2] / 2],  # in the middle of a layer across the shear
        "vesicle[0].radius": radius, "vesicle[0].reduced_volume": REDUCED_VOLUME,
        "fluid.kinematic_viscosity": nu, "vesicle_type.cell.viscosity_ratio": ratio,
        "vesicle_type.cell.bending.modulus": kappa,
        "flow.shear.rate": rate, "flow.shear.start": start, **({} if stop is None else {"flow.shear.stop": stop}),
        "numerics.precision": "single", "run.steps": steps,
        "output.metrics.every": max(10, steps // 100), "output.fields.every": steps, "output.surfaces.every": steps,
        "output.checkpoint.every": max(500, steps // 4), **(settings or {}),
    }, options)  # fmt: skip


def mean_of_end(run, column, share=0.1):
    """Over the last share of the samples."""
    values = run.metrics[column]
    return float(values[-max(2, int(share * len(values))) :].mean())


def equatorial_diameters(surface, axis=1):
    """(least, greatest) width of a surface at rest across its axis, over directions in the plane."""
    points = numpy.delete(surface.points - surface.centre(), axis, axis=1)
    widths = [numpy.ptp(points @ (math.cos(a), math.sin(a))) for a in numpy.linspace(0.0, math.pi, 60, endpoint=False)]
    return float(min(widths)), float(max(widths))


def section(surface, level, axis=1):
    """Points where the triangles' edges cross the plane axis = level, ordered round their centre: an outline."""
    offset = surface.points[:, axis] - level
    points = []
    for a, b in ((0, 1), (1, 2), (2, 0)):
        i, j = surface.triangles[:, a], surface.triangles[:, b]
        crossing = (offset[i] <= 0.0) & (offset[j] > 0.0)
        i, j = i[crossing], j[crossing]
        share = (offset[i] / (offset[i] - offset[j]))[:, None]
        points.append(surface.points[i] * (1 - share) + surface.points[j] * share)
    points = numpy.delete(numpy.concatenate(points), axis, axis=1)
    middle = points.mean(axis=0)
    return points[numpy.argsort(numpy.arctan2(*(points - middle).T[::-1]))]
