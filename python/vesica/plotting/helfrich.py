"""Helfrich's exact axisymmetric vesicle shapes without spontaneous curvature, by reduced volume.

The tables hold psi(s) = pi s/L + sum_n a_n sin(n pi s/L), the tangent's angle along the meridian
(r' = cos psi, z' = -sin psi), and the energy in units of 8 pi kappa. Lengths are in R_A = sqrt(A/(4 pi)).
Between the tabulated reduced volumes the coefficients are interpolated in sqrt(1 - v), in which oblates and
prolates are smooth at the sphere, and the argument is then corrected until the curve has the volume asked for.
"""

import csv
import json
import math
from dataclasses import dataclass
from pathlib import Path

import numpy
from scipy.interpolate import PchipInterpolator
from scipy.optimize import brentq

_HERE = Path(__file__).resolve()
# Beside the package where it is installed, else the sources' own.
DATA = next((p for p in (_HERE.parents[1] / "data" / "helfrich", _HERE.parents[3] / "data" / "helfrich") if p.is_dir()),
            _HERE.parents[1] / "data" / "helfrich")
BRANCHES = ("oblate", "prolate", "stomatocyte")


@dataclass(frozen=True)
class Meridian:
    """From pole to pole: distance from the axis r >= 0, height z along it (0 at the centre of volume), arc length s."""

    r: numpy.ndarray
    z: numpy.ndarray
    s: numpy.ndarray

    def area(self):
        return 2.0 * math.pi * numpy.trapz(self.r, self.s)

    def volume(self):
        return -math.pi * numpy.trapz(self.r**2, self.z)

    def reduced_volume(self):
        return 6.0 * math.sqrt(math.pi) * self.volume() / self.area() ** 1.5

    def inertia(self):
        """(along the axis, across it) of a solid body of density one about its centre."""
        dz = -numpy.gradient(self.z, self.s)
        along = 0.5 * math.pi * numpy.trapz(self.r**4 * dz, self.s)
        across = 0.5 * along + math.pi * numpy.trapz(self.r**2 * self.z**2 * dz, self.s)
        return along, across

    def scaled(self, factor):
        return Meridian(factor * self.r, factor * self.z, factor * self.s)

    def of_volume(self, volume):
        return self.scaled((volume / self.volume()) ** (1.0 / 3.0))

    def upside_down(self):
        return Meridian(self.r[::-1], -self.z[::-1], self.s[-1] - self.s[::-1])


class HelfrichShapes:
    """The three branches, read from `data/helfrich` (or from the folder given)."""

    def __init__(self, folder=DATA):
        with open(Path(folder) / "helfrich_c0_0.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        series = json.loads((Path(folder) / "helfrich_c0_0_fourier.json").read_text(encoding="utf-8"))
        self._branches = {name: _Branch(name, rows, series) for name in BRANCHES}

    def range(self, branch):
        """The reduced volumes between which the branch is known."""
        return self._branches[branch].range

    def energy(self, branch, reduced_volume):
        """Bending energy over 8 pi kappa; nan where the branch is not known. Scalars or arrays."""
        return self._branches[branch].energy(reduced_volume)

    def profile(self, branch, reduced_volume, points=2001):
        """The meridian in units of R_A, or None where the branch is not known."""
        return self._branches[branch].profile(reduced_volume, points)

    def existing(self, reduced_volume):
        """Names of the branches that are known at this reduced volume."""
        return [b for b in BRANCHES if self.range(b)[0] <= reduced_volume <= self.range(b)[1]]


class _Branch:
    def __init__(self, name, rows, series):
        table = {float(row["v"]): float(row["E_over_8pi_kappa"]) for row in rows if row["shape"] == name}
        coefficients = {}
        for key, entry in series.items():
            shape, _, v = key.rpartition("_")
            if shape == name:
                coefficients[float(v)] = (entry["L"], dict(entry["a"]))
        if name != "stomatocyte":  # both end in the sphere, of energy 1
            table[1.0] = 1.0
            coefficients[1.0] = (math.pi, {})
        volumes = numpy.array(sorted(table))
        self.range = (float(volumes[0]), float(volumes[-1]))
        self._energy = PchipInterpolator(volumes, [table[v] for v in volumes], extrapolate=False)

        keys = sorted(coefficients, reverse=True)
        self._orders = sorted({n for _, a in coefficients.values() for n in a})
        values = [[coefficients[v][0]] + [coefficients[v][1].get(n, 0.0) for n in self._orders] for v in keys]
        self._series = PchipInterpolator([math.sqrt(1.0 - v) for v in keys], values, extrapolate=True)

    def energy(self, reduced_volume):
        return self._energy(numpy.asarray(reduced_volume, dtype=float))

    def profile(self, reduced_volume, points):
        lowest, highest = self.range
        if not lowest <= reduced_volume <= highest:
            return None
        target = math.sqrt(1.0 - reduced_volume)

        def excess(x):
            return self._curve(x, points).reduced_volume() - reduced_volume

        # The interpolated curve misses the volume asked for by little: look close by, else keep it as it is.
        x = target
        low, high = max(0.0, target - 0.01), target + 0.01
        if excess(low) * excess(high) < 0.0:
            x = brentq(excess, low, high, xtol=1e-12)
        curve = self._curve(x, points)
        return curve.scaled(math.sqrt(4.0 * math.pi / curve.area()))

    def _curve(self, x, points):
        length, *coefficients = self._series(x)
        s = numpy.linspace(0.0, length, points)
        psi = math.pi * s / length
        for n, a in zip(self._orders, coefficients):
            psi = psi + a * numpy.sin(n * math.pi * s / length)
        r = _integral(numpy.cos(psi), s)
        r = numpy.maximum(r - r[-1] * s / length, 0.0)  # closes the curve where interpolation left a gap
        z = _integral(-numpy.sin(psi), s)
        disc = r**2 * numpy.gradient(z, s)
        z = z - numpy.trapz(z * disc, s) / numpy.trapz(disc, s)
        return Meridian(r, z, s)


def _integral(values, s):
    """Integral from the first point to each, by the trapezium rule."""
    steps = 0.5 * (values[1:] + values[:-1]) * numpy.diff(s)
    return numpy.concatenate(([0.0], numpy.cumsum(steps)))
