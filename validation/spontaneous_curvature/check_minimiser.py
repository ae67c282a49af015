#!/usr/bin/python3
"""Hold the minimiser to what is known without it; exit status 1 if anything fails.

Each check yields (what, error, tolerance).
"""

import csv
import sys
from collections.abc import Iterable, Iterator

import numpy as np
from axisymmetric_minimiser import Shape, follow, minimise
from off_axis_stability import stiffness_against
from reference import TABLE, reference_shape, tabulated_shape

Finding = tuple[str, float, float]
Key = tuple[float, str, float]

#: The stomatocytes of the table have this many modes, which is not enough for their necks: compared like with like.
STOMATOCYTE_MODES = 48
TABULATED = [
    ("oblate", (0.95, 0.9, 0.85, 0.8, 0.75, 0.7, 0.65, 0.6)),
    ("prolate", (0.95, 0.9, 0.85, 0.8, 0.75, 0.7, 0.65, 0.6)),
    ("stomatocyte", (0.65, 0.6)),
]
CURVED: list[Key] = [(-2.0, "oblate", 0.667), (1.0, "oblate", 0.8), (-2.0, "prolate", 0.8), (2.0, "prolate", 0.667)]


def against_table(entries: Iterable[tuple[str, Iterable[float]]]) -> Iterator[Finding]:
    """Without spontaneous curvature the shapes are those of data/helfrich/helfrich_c0_0.csv, found by other means."""
    with TABLE.with_name("helfrich_c0_0.csv").open() as file:
        table = {(line["shape"], float(line["v"])): line for line in csv.DictReader(file)}
    for branch, volumes in entries:
        for v in volumes:
            shape = tabulated_shape(branch, v, STOMATOCYTE_MODES if branch == "stomatocyte" else 0)
            across, along = shape.inertia
            for column, value, tolerance in (
                ("E_over_8pi_kappa", shape.energy, 1e-5),
                ("rmax_over_RA", shape.largest_radius, 1e-3),
                ("pole_to_pole_over_RA", shape.axis_thickness, 1e-3),
                ("total_height_over_RA", shape.total_height, 1e-3),
                ("Ixx_over_M_R0sq", across, 1e-4),
                ("Izz_over_M_R0sq", along, 1e-4),
                ("M_over_8pi_RA", shape.mean_curvature, 1e-4),
                ("lamA", shape.area_multiplier, 1e-3),
                ("lamV", shape.volume_multiplier, 1e-3),
            ):
                expected = float(table[branch, v][column])
                yield f"{branch} v = {v}: {column}", abs(value / expected - 1), tolerance


def multipliers(keys: Iterable[Key]) -> Iterator[Finding]:
    """The multipliers and the mean curvature are the slopes of the energy along the branch."""
    h = 1e-3
    for c, branch, v in keys:
        shape = reference_shape(c, branch, v)

        def slope(path) -> float:
            """Fourth-order central difference of the energy along `path`(x) = (v, C0 R_A)."""
            energy = {k: minimise(*path(k * h), shape).energy for k in (-2, -1, 1, 2)}
            return (8 * (energy[1] - energy[-1]) - (energy[2] - energy[-2])) / (12 * h)

        # At fixed V and C0 an area a times larger is v a^(-3/2) and C0 R_A a^(1/2); the energy has no length scale.
        by_area = slope(lambda x: (v * (1 + x) ** -1.5, c * (1 + x) ** 0.5))
        name = f"{branch} v = {v} C0 R_A = {c:g}: "
        yield name + "dE/dA", abs(by_area - shape.area_multiplier), 1e-6
        yield name + "dE/dV", abs(slope(lambda x: (v + x, c)) - shape.volume_multiplier), 1e-6
        yield name + "dE/dC0", abs(slope(lambda x: (v, c + x)) - (c / 2 - shape.mean_curvature)), 1e-6


def force_imbalance(shape: Shape) -> float:
    """Return the largest net normal force on the membrane over the largest of its terms.

    p_in - p_out - 2 sigma H + kappa [2 Lap_s H + (2H - C0)(2H^2 - 2K + C0 H)] = 0 (Zhong-can & Helfrich 1987), pointwise,
    away from the poles, where the derivatives lose digits.
    """
    t = np.linspace(0.05, 0.95, 181)
    orders = np.arange(1, shape.coefficients.size + 1)
    wave, phase = np.pi * orders / shape.length, np.pi * np.outer(t, orders)
    first = np.pi / shape.length + np.cos(phase) @ (wave * shape.coefficients)
    second = -np.sin(phase) @ (wave**2 * shape.coefficients)
    third = -np.cos(phase) @ (wave**3 * shape.coefficients)
    profile = shape.profile(2001)
    r, psi = profile.r[100:1901:10], profile.psi[100:1901:10]
    sine, cosine = np.sin(psi), np.cos(psi)
    parallel = sine / r
    by_s = cosine * (first - parallel) / r
    by_ss = (cosine * (second - by_s) - sine * first * (first - parallel)) / r - cosine**2 * (first - parallel) / r**2
    mean, gauss, c = (first + parallel) / 2, first * parallel, shape.spontaneous_curvature
    laplacian = (third + by_ss) / 2 + cosine / r * (second + by_s) / 2
    terms = np.stack([
        np.full_like(t, 6 * shape.volume_multiplier),  # (p_in - p_out) R_A^3/kappa
        4 * shape.area_multiplier * mean,  # sigma = -2 kappa area_multiplier/R_A^2
        2 * laplacian,
        (2 * mean - c) * (2 * mean**2 - 2 * gauss + c * mean),
    ])
    return float(np.abs(terms.sum(axis=0)).max() / np.abs(terms).max())


def balanced_forces(keys: Iterable[Key]) -> Iterator[Finding]:
    """The shape equation, which the minimiser does not use, holds at every point."""
    for c, branch, v in keys:
        yield f"{branch} v = {v} C0 R_A = {c:g}: force", force_imbalance(reference_shape(c, branch, v)), 1e-5


def convergence(keys: Iterable[tuple[Key, tuple[int, ...]]]) -> Iterator[Finding]:
    """The energy converges faster than any power with the number of modes: 12 more are worth a factor of ten or more."""
    for (c, branch, v), modes in keys:
        shape = reference_shape(c, branch, v)
        errors = [abs(minimise(v, c, shape, count).energy - shape.energy) for count in modes]
        name = f"{branch} v = {v} C0 R_A = {c:g}: energy's change from "
        for few, many, before, after in zip(modes, modes[1:], errors, errors[1:]):
            yield name + f"{few} to {many} modes, over that before", after / max(before, 1e-13), 0.1
        yield name + f"{modes[-1]} modes on", errors[-1], 1e-7


def paths(keys: Iterable[Key]) -> Iterator[Finding]:
    """The shape does not depend on the way to it: first C0, then the volume, or the reverse."""
    for c, branch, v in keys:
        other = follow(reference_shape(c, branch, round(v + 0.05, 3)), v, c)
        difference = np.abs(other.coefficients - reference_shape(c, branch, v).coefficients).max()
        yield f"{branch} v = {v} C0 R_A = {c:g}: difference by the path", float(difference), 1e-9


def off_axis() -> Iterator[Finding]:
    """Shifts and turns cost nothing; without C0 the oblate turns elliptic at v = .75 (Seifert, Berndl, Lipowsky 1991)."""
    for c, branch, v in CURVED[:3]:
        low = stiffness_against(reference_shape(c, branch, v), 1)
        yield f"{branch} v = {v} C0 R_A = {c:g}: m = 1, shift and turn over the next", abs(low[1] / low[2]), 1e-3
    for c, v, sign in ((0.0, 0.74, 1), (0.0, 0.76, -1)):
        low = stiffness_against(reference_shape(c, "oblate", v), 2)[0]
        yield f"oblate v = {v}: m = 2 on the wrong side", max(0.0, -sign * low), 0.0


def all_findings() -> Iterator[Finding]:
    yield from against_table(TABULATED)
    yield from multipliers(CURVED)
    yield from balanced_forces(CURVED)
    yield from off_axis()
    yield from paths(CURVED[:2])
    yield from convergence([((2.0, "oblate", 0.667), (8, 12, 16, 20)), ((2.0, "prolate", 0.667), (20, 32, 44, 56))])


def main() -> int:
    failures = 0
    worst: dict[str, float] = {}
    for what, error, tolerance in all_findings():
        kind = what.split(": ")[1]
        worst[kind] = max(worst.get(kind, 0.0), error)
        if not error <= tolerance:
            failures += 1
            print(f"FAILED {what}: {error:.2e}, at most {tolerance:.0e} expected")
    for kind, error in worst.items():
        print(f"{error:8.1e}  {kind}")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
