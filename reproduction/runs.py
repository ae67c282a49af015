"""Runs that several items look at, and what belongs to a radius: boxes, moduli, times."""

import math

from shared import OWN_CASES, Simulation, bending_time, rest_case

REST = OWN_CASES / "rest.toml"
DEFLATION = 1.31  # the paper's Upsilon
REDUCED_VOLUME = DEFLATION**-1.5
RADIUS = 15.0
KAPPA_B, SIGMA, NU = 0.25, 1e-5, 1 / 12
RAMP, LENGTH = 16 / 3, 8.0  # bending times


def discocyte(quick):
    """A sphere of R = 15 deflated to Upsilon = 1.31 with kappa_B = .25, sigma = 1e-5: the paper's bicuspid. Everything
    about it stands in cases/rest.toml. The quick one is smaller and stiffer: at R = 10 a soft one becomes a torus."""
    if quick:
        return from_sphere("discocyte-quick", 10.0, 1.6, nu=1 / 6)
    return Simulation("discocyte", REST, {})


def from_sphere(name, radius, paper_modulus, *, nu, sigma=SIGMA, settings=None):
    """The same path at another radius and modulus; ramp and length in bending times are those of R = 15."""
    time = bending_time(radius, paper_modulus / 4, nu)
    steps = 18 * _hundreds(LENGTH * time / 18)
    across, along = _fours(64 / 15 * radius), _fours(48 / 15 * radius)
    return Simulation(name, REST, {
        "lattice.size": [across, across, along],
        "fluid.kinematic_viscosity": nu,
        "vesicle[0].centre": [across / 2, across / 2, along / 2],
        "vesicle[0].radius": radius,
        "vesicle_type.vesicle.bending.paper_modulus": paper_modulus,
        "vesicle_type.vesicle.tension.sigma": sigma,
        "vesicle_type.vesicle.area.ramp": _hundreds(RAMP * time),
        "run.steps": steps,
        "output.fields.every": steps,
        "output.surfaces.every": steps // 18,
        "output.checkpoint.every": steps // 6,
        **(settings or {}),
    })  # fmt: skip


def exact(shape, radius, *, bending_times, reduced_volume=REDUCED_VOLUME, tag="", nu=1 / 4, settings=None):
    """Helfrich's exact shape let go: it has only the lattice's own errors to relax."""
    name = f"exact-{shape}-R{radius:g}{tag}"
    kappa = radius / 20
    return rest_case(OWN_CASES / "exact.toml", name, shape, reduced_volume, radius, bending_times, kappa=kappa, nu=nu,
                     settings=settings)  # fmt: skip


def sphere_volume(radius):
    return 4 / 3 * math.pi * radius**3


def _hundreds(steps):
    return int(100 * round(steps / 100))


def _fours(length):
    return int(4 * math.ceil(length / 4 - 1e-9))
