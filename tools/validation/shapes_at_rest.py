"""A vesicle at rest beside Helfrich's exact shape at the reduced volume it has."""

import math
from dataclasses import dataclass

import h5py
import numpy

from validation.simulations import Simulation
from vesica.plotting.comparison import compare
from vesica.plotting.helfrich import HelfrichShapes
from vesica.plotting.surface import fold

BRANCH_OF = {"discocyte": "oblate", "prolate": "prolate", "stomatocyte": "stomatocyte"}
THEORY = HelfrichShapes()


def rest_case(case, name, shape, reduced_volume, radius, bending_times, *, kappa, nu, margin=11, settings=None):
    """The exact shape in a box with `margin` cells beyond it on each side, for a number of bending times."""
    curve = THEORY.profile(BRANCH_OF[shape], reduced_volume).of_volume(4 / 3 * math.pi * radius**3)
    across = _rounded_up(2 * (curve.r.max() + margin), 8)
    along = _rounded_up(curve.z.max() - curve.z.min() + 2 * margin, 4)
    middle = 0.5 * along - 0.5 * (curve.z.max() + curve.z.min())  # the curve's origin is its centre of volume
    middle = round(2 * middle) / 2
    steps = int(round(bending_times * bending_time(radius, kappa, nu), -2))
    changes = {
        "lattice.size": [across, across, along],
        "vesicle[0].centre": [across / 2, across / 2, middle],
        "vesicle[0].shape": shape,
        "vesicle[0].reduced_volume": reduced_volume,
        "vesicle[0].radius": radius,
        "vesicle_type.vesicle.bending.modulus": kappa,
        "fluid.kinematic_viscosity": nu,
        "run.steps": steps,
        "output.fields.every": steps,
        "output.surfaces.every": steps,
        "output.checkpoint.every": steps // 2,
    }
    return Simulation(name, case, {**changes, **(settings or {})})


def bending_time(radius, kappa, nu):
    """tau_b = eta R0^3/kappa with density 1, in steps."""
    return nu * radius**3 / kappa


def _rounded_up(length, multiple):
    return int(math.ceil(length / multiple)) * multiple


@dataclass(frozen=True)
class AtRest:
    """What a finished run ended with; lengths in R_A, energies in 8 pi kappa, theory at the run's own v."""

    v: float
    energy: float
    exact_energy: float
    r_max: float
    exact_r_max: float
    height: float
    exact_height: float
    thickness: float  # along the axis
    exact_thickness: float
    rms: float  # of the surface's distance from the exact meridian, cells
    asymmetry: float
    inertia: tuple  # ascending, over M R0^2
    tension: float  # sigma R_A^2/kappa
    exact_tension: float
    pressure: float  # (p_in - p_out) R_A^3/kappa
    exact_pressure: float
    total_gaussian_curvature: float  # over 4 pi
    area_error: float  # A/A_target - 1

    def energy_error(self):
        return self.energy / self.exact_energy - 1.0


def at_rest(finished, shape):
    """None if theory has no shape of this branch at the reduced volume the run has come to."""
    branch = BRANCH_OF[shape]
    v, area, volume = (finished.last(name) for name in ("reduced_volume", "area", "volume"))
    kappa = finished.run.resolved["vesicle_type"]["vesicle"]["bending"]["modulus"]
    kappa = kappa["lattice"] if isinstance(kappa, dict) else kappa
    if THEORY.profile(branch, v) is None:
        return None
    length = math.sqrt(area / (4 * math.pi))
    radius = (3 * volume / (4 * math.pi)) ** (1 / 3)
    slope = float((THEORY.energy(branch, v + 1e-4) - THEORY.energy(branch, v - 1e-4)) / 2e-4)

    folded = fold(finished.surface())
    unit = THEORY.profile(branch, v)
    comparisons = [compare(folded, branch, c) for c in (unit.of_volume(volume), unit.of_volume(volume).upside_down())]
    closest = min(comparisons, key=lambda c: c.rms)
    near_axis = folded.r < 0.06 * length
    upper = folded.z[near_axis].mean()
    top, bottom = folded.z[near_axis & (folded.z > upper)], folded.z[near_axis & (folded.z <= upper)]
    density = 1.0
    inertia = tuple(finished.last(f"inertia_{k}") / (density * volume * radius**2) for k in (1, 2, 3))
    return AtRest(
        v=v,
        energy=finished.last("bending_energy"),
        exact_energy=float(THEORY.energy(branch, v)),
        r_max=float(numpy.sort(folded.r)[-20:].mean() / length),
        exact_r_max=float(unit.r.max()),
        height=float((numpy.sort(folded.z)[-20:].mean() - numpy.sort(folded.z)[:20].mean()) / length),
        exact_height=float(unit.z.max() - unit.z.min()),
        thickness=float((top.mean() - bottom.mean()) / length),
        exact_thickness=float(unit.z[0] - unit.z[-1]),
        rms=closest.rms,
        asymmetry=folded.asymmetry,
        inertia=inertia,
        tension=finished.last("tension") * length**2 / kappa,
        # At rest sigma = - dE/dA at constant V and p_in - p_out = dE/dV at constant A.
        exact_tension=3 * v * slope,
        pressure=pressure_jump(finished) * length**3 / kappa,
        exact_pressure=6 * slope,
        total_gaussian_curvature=finished.last("gaussian_curvature_over_pi") / 4,
        area_error=finished.last("area_ratio") - 1.0,
    )


def pressure_jump(finished):
    """p_in - p_out far from the layer, from the last fields written."""
    path = sorted((finished.directory / "fields").glob("step_*.h5"))[-1]
    with h5py.File(path) as file:
        phase, pressure = file["phase"][...], file["pressure"][...]
    inside, outside = phase > 0.9999, phase < -0.9999
    if not inside.any():  # thinner than the layer's tails
        inside = phase > phase.max() - 1e-3
    return float(pressure[inside].mean() - pressure[outside].mean())
