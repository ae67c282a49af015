"""Vesicles of revolution at rest: stationary points of the bending energy at given area and volume.

E = (kappa/2) int (2H - C0)^2 dA (Helfrich 1973) for closed surfaces of spherical topology, mirror symmetric or not, with
H = (1/2) div n positive on a sphere. Lengths are in R_A = (A/4 pi)^(1/2), energies in 8 pi kappa, so a sphere has 2H = 2,
and C0 R_A = 2 is its own curvature. Newton's method on the Lagrangian

    E/(8 pi kappa) - area_multiplier [A/(4 pi) - 1] - volume_multiplier [V/(4 pi/3) - v]

with exact second derivatives (meridian_functionals.py) converges to rounding error, and to saddles as well as to minima:
`Shape.unstable_directions` tells them apart.
"""

from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np
import scipy.linalg
from meridian_functionals import MeridianFunctionals

#: Newton's method ends when every equation holds to this; what is left is rounding.
TOLERANCE = 1e-10


class NoShape(RuntimeError):
    """Newton's method found no stationary shape near the guess, or one that intersects itself."""


@lru_cache(maxsize=16)
def _functionals(modes: int, mirror: bool) -> MeridianFunctionals:
    return MeridianFunctionals(np.arange(2, modes + 1, 2) if mirror else np.arange(1, modes + 1))


@dataclass(frozen=True)
class Profile:
    """A meridian from pole to pole, arrays over its points, lengths in R_A; z falls along s, 0 midway between the poles."""

    s: np.ndarray
    r: np.ndarray
    z: np.ndarray
    psi: np.ndarray
    curvature: np.ndarray  #: 2H, positive on a sphere


@dataclass(frozen=True)
class Shape:
    """A stationary shape; lengths in R_A, energies in 8 pi kappa."""

    coefficients: np.ndarray  #: a_1 ... a_N of psi(s) = pi s/L + sum a_n sin(n pi s/L)
    length: float  #: L of the meridian
    spontaneous_curvature: float  #: C0 R_A
    reduced_volume: float  #: V/(4 pi/3)
    area: float  #: A/(4 pi): 1 up to rounding
    energy: float
    area_multiplier: float  #: d energy/d[A/(4 pi)] at fixed volume and C0; the membrane's tension is -2 kappa/R_A^2 times it
    volume_multiplier: float  #: d energy/d[V/(4 pi/3)] at fixed area and C0; p_in - p_out is 6 kappa/R_A^3 times it
    mirror: bool  #: only even orders were allowed

    def profile(self, points: int = 401) -> Profile:
        """Return the meridian at `points` equal steps of arc length."""
        s = np.linspace(0.0, self.length, points)
        nodes, weights = np.polynomial.legendre.leggauss(8)
        step = self.length / (points - 1)
        inner = (s[:-1, None] + step * (nodes + 1) / 2) / self.length
        psi = self._psi(inner)
        r = np.append(0.0, np.cumsum(np.cos(psi) @ weights * step / 2))
        z = -np.append(0.0, np.cumsum(np.sin(psi) @ weights * step / 2))
        r[-1] = 0.0
        psi = self._psi(s / self.length)
        orders = np.arange(1, self.coefficients.size + 1)
        slope = (np.pi + np.cos(np.pi * np.outer(s / self.length, orders)) @ (np.pi * orders * self.coefficients))
        slope /= self.length
        second = slope.copy()  # sin(psi)/r -> dpsi/ds at a pole
        second[1:-1] = np.sin(psi[1:-1]) / r[1:-1]
        return Profile(s, r, z - z[-1] / 2, psi, slope + second)

    def _psi(self, t: np.ndarray) -> np.ndarray:
        orders = np.arange(1, self.coefficients.size + 1)
        return np.pi * t + np.sin(np.pi * t[..., None] * orders) @ self.coefficients

    @cached_property
    def _fine(self) -> Profile:
        return self.profile(2001)

    @property
    def largest_radius(self) -> float:
        """Of the shape, from a parabola through the three outermost of 2001 points."""
        return _peak(self._fine.r)

    @property
    def axis_thickness(self) -> float:
        """Distance of the poles along the axis; negative where they have passed through each other."""
        return float(self._fine.z[0] - self._fine.z[-1])

    @property
    def total_height(self) -> float:
        """Extent along the axis."""
        return _peak(self._fine.z) + _peak(-self._fine.z)

    @property
    def neck_radius(self) -> float:
        """Smallest radius between two bulges of the meridian; nan without a neck."""
        r = self._fine.r
        inner = np.flatnonzero((r[1:-1] < r[:-2]) & (r[1:-1] <= r[2:])) + 1
        return float(r[inner].min()) if inner.size else float("nan")

    @property
    def sharpest_radius(self) -> float:
        """Smallest radius of either principal curvature, of either sign."""
        ds, r, psi, slope = self._gauss
        return float(1 / max(np.abs(slope).max(), np.abs(np.sin(psi) / r).max()))

    @cached_property
    def _gauss(self) -> tuple[np.ndarray, ...]:
        """ds, r, psi and dpsi/ds at nodes whose weighted sums are exact to rounding."""
        f = _functionals(self.coefficients.size, mirror=False)
        psi = np.pi * f.t + f.sines @ self.coefficients
        return (
            f.weights * self.length, self.length * (f.integral @ np.cos(psi)), psi,
            (np.pi + f.slopes @ self.coefficients) / self.length,
        )

    @property
    def mean_curvature(self) -> float:
        """int 2H dA/(8 pi R_A), 1 on a sphere. d energy/d(C0 R_A) = C0 R_A/2 - mean_curvature at fixed area and volume."""
        ds, r, psi, slope = self._gauss
        return float(ds @ (slope * r + np.sin(psi)) / 4)

    @property
    def inertia(self) -> tuple[float, float]:
        """Across and along the axis, of the solid body through its centre, over M R0^2; 0.4 for a sphere."""
        ds, r, psi, _ = self._gauss
        f = _functionals(self.coefficients.size, mirror=False)
        # The matrix integrates the second half from the other pole.
        z = -self.length * (f.integral @ np.sin(psi)) - np.where(f.t > 0.5, ds @ np.sin(psi), 0.0)
        slab = ds * r**2 * np.sin(psi)  # dV/pi
        volume = slab.sum()
        z = z - slab @ z / volume
        square = self.reduced_volume ** (2 / 3)  # R0^2/R_A^2
        along = slab @ r**2 / (2 * volume * square)
        return float(slab @ z**2 / (volume * square) + along / 2), float(along)

    @property
    def is_embedded(self) -> bool:
        """Whether r > 0 between the poles, which have not passed each other, and the meridian does not meet itself."""
        p = self.profile(401)
        return bool(np.all(p.r[1:-1] > 0)) and self.axis_thickness > 0 and not _meets_itself(p.r, p.z)

    @cached_property
    def stiffness(self) -> np.ndarray:
        """Eigenvalues, rising, of the energy's second variation at fixed area and volume, among shapes of revolution.

        In the coordinates n a_n and L; only their signs do not depend on that choice. Shapes without mirror symmetry
        are always allowed here.
        """
        functionals = _functionals(self.coefficients.size, mirror=False)
        scale = 1 / np.append(functionals.orders, 1.0)
        at = (self.coefficients, self.length, self.spontaneous_curvature)
        multipliers = np.array([self.area_multiplier, self.volume_multiplier, 0.0])
        energy, *constraints = functionals.evaluate(*at, multipliers).gradients
        # A shape found under mirror symmetry has no multiplier of closure yet.
        multipliers = np.linalg.lstsq(np.transpose(constraints), energy, rcond=None)[0]
        hessian = functionals.evaluate(*at, multipliers).hessian
        basis = scipy.linalg.null_space(constraints * scale)
        return np.linalg.eigvalsh(basis.T @ (scale[:, None] * hessian * scale) @ basis)

    @property
    def unstable_directions(self) -> int:
        """Number of independent deformations of revolution that lower the energy: 0 at a minimum."""
        return int(np.sum(self.stiffness < -1e-7))


def _peak(values: np.ndarray) -> float:
    """Return the maximum of equally spaced values, from a parabola unless it lies at an end."""
    i = int(np.argmax(values))
    if i in (0, values.size - 1):
        return float(values[i])
    left, mid, right = values[i - 1 : i + 2]
    return float(mid + (left - right) ** 2 / (8 * (2 * mid - left - right)))


def _meets_itself(r: np.ndarray, z: np.ndarray) -> bool:
    """Whether two segments of the polygon that have no corner in common cross."""
    a, b = np.stack([r[:-1], z[:-1]], 1), np.stack([r[1:], z[1:]], 1)

    def side(p, q, x):
        return (q[:, None, 0] - p[:, None, 0]) * (x[None, :, 1] - p[:, None, 1]) - (q[:, None, 1] - p[:, None, 1]) * (
            x[None, :, 0] - p[:, None, 0]
        )

    apart = side(a, b, a) * side(a, b, b) < 0
    return bool(np.any(np.triu(apart & apart.T, 2)))


def _padded(coefficients: np.ndarray, modes: int) -> np.ndarray:
    kept = np.zeros(modes)
    kept[: min(modes, coefficients.size)] = coefficients[:modes]
    return kept


def minimise(
    reduced_volume: float, spontaneous_curvature: float, guess: Shape, modes: int = 0, mirror: bool | None = None
) -> Shape:
    """Return the stationary shape that Newton's method reaches from `guess`.

    `spontaneous_curvature` is C0 R_A; `modes` is the highest order of the sine series (default: the guess's); `mirror`
    allows even orders only (default: as the guess). The guess should be close: see `follow`. Raises NoShape.
    """
    if not 0 < reduced_volume < 1:
        raise ValueError(f"the reduced volume is {reduced_volume}; expected 0 to 1, both excluded")
    modes = modes or guess.coefficients.size
    mirror = guess.mirror if mirror is None else mirror
    functionals = _functionals(modes, mirror)
    # Closure is automatic under mirror symmetry, where cos(psi) is odd about the equator.
    count = 2 if mirror else 3
    targets = np.array([1.0, reduced_volume, 0.0])[:count]
    size = functionals.orders.size + 1
    x = np.append(_padded(guess.coefficients, modes)[functionals.orders - 1], guess.length)
    multipliers = np.array([guess.area_multiplier, guess.volume_multiplier, 0.0])
    # The gradient by a_n carries rounding errors that grow with n.
    weights = 1 / np.append(functionals.orders, np.ones(1 + count))
    previous = np.inf
    for _ in range(40):
        f = functionals.evaluate(x[:-1], x[-1], spontaneous_curvature, multipliers)
        constraints = f.gradients[1 : 1 + count]
        residual = np.append(
            f.gradients[0] - multipliers[:count] @ constraints, targets - f.values[1 : 1 + count]
        )
        error = np.max(np.abs(residual) * weights)
        if not np.isfinite(error) or error > 1e6:
            break
        if error < TOLERANCE and error > 0.1 * previous:
            coefficients = np.zeros(modes)
            coefficients[functionals.orders - 1] = x[:-1]
            return Shape(
                coefficients, float(x[-1]), spontaneous_curvature, reduced_volume, *map(float, f.values[1::-1]),
                *map(float, multipliers[:2]), mirror,
            )
        previous = error
        matrix = np.zeros((size + count,) * 2)
        matrix[:size, :size] = f.hessian
        matrix[:size, size:] = -constraints.T
        matrix[size:, :size] = -constraints
        step = np.linalg.solve(matrix, -residual)
        damping = min(1.0, 0.5 / max(1e-300, np.abs(step[:size]).max()))
        x = x + damping * step[:size]
        multipliers[:count] += damping * step[size:]
    raise NoShape(f"no stationary shape near the guess at v = {reduced_volume}, C0 R_A = {spontaneous_curvature}")


def follow(
    start: Shape, reduced_volume: float, spontaneous_curvature: float, modes: int = 0, largest_step: float = 0.1
) -> Shape:
    """Return the shape on the branch of `start` at another reduced volume and C0 R_A, reached in small steps.

    A step is halved when the shape changes by more than the step warrants or Newton's method fails, so that the path
    stays on its branch. Raises NoShape where the branch ends or folds back.
    """
    target = np.array([reduced_volume, spontaneous_curvature])
    shape = minimise(start.reduced_volume, start.spontaneous_curvature, start, modes)
    step = largest_step
    while True:
        here = np.array([shape.reduced_volume, shape.spontaneous_curvature])
        # A reduced volume's change of .02 counts as much as one of .1 in C0 R_A.
        distance = float(np.max(np.abs(target - here) * (5.0, 1.0)))
        if distance == 0:
            return shape
        there = target if distance <= step else here + (target - here) * (step / distance)
        try:
            following = minimise(float(there[0]), float(there[1]), shape)
            moved = float(np.max(np.abs(following.coefficients - shape.coefficients)))
        except (NoShape, np.linalg.LinAlgError):
            moved = np.inf
        if moved > 0.15:
            step /= 2
            if step < 1e-4:
                raise NoShape(f"the branch ends near v = {here[0]:.5f}, C0 R_A = {here[1]:.4f}")
            continue
        shape, step = following, min(largest_step, 1.5 * step)
