"""Whether a shape of revolution is stable against deformations that are none: w(s) cos(m phi) along the normal, m > 0.

The second variation of E/(8 pi kappa) - area_multiplier A/(4 pi) - volume_multiplier V/(4 pi/3), at m > 0 that of the
energy at fixed area and volume, by central differences of the deformed surface's own energy, area and volume.
"""

import numpy as np
import scipy.linalg
from axisymmetric_minimiser import Shape
from meridian_functionals import cumulative_integral

#: Displacement of the difference quotient, in R_A: its error is some 1e-6 by truncation, and as much by rounding.
STEP = 2e-4


class _Surface:
    """The surface of revolution at Gauss nodes times an even grid of phi, as a base of normal displacements.

    Vectors have the components (e_s, e_phi, n) of the undeformed surface, whose derivatives are
    d_s e_s = -psi' n, d_s n = psi' e_s, d_phi e_s = cos(psi) e_phi, d_phi n = sin(psi) e_phi,
    d_phi e_phi = -cos(psi) e_s - sin(psi) n.
    """

    def __init__(self, shape: Shape, m: int):
        self.shape, self.m = shape, m
        count = 64 + shape.coefficients.size
        self.t, weights, integral = cumulative_integral(count)
        orders = np.arange(1, shape.coefficients.size + 1)
        wave, phase = np.pi * orders / shape.length, np.pi * np.outer(self.t, orders)
        psi = np.pi * self.t + np.sin(phase) @ shape.coefficients
        self.bend = np.pi / shape.length + np.cos(phase) @ (wave * shape.coefficients)
        self.bend_slope = -np.sin(phase) @ (wave**2 * shape.coefficients)
        self.sine, self.cosine = np.sin(psi), np.cos(psi)
        self.z = -shape.length * (integral @ self.sine)
        left, right = integral @ self.cosine, -(integral[::-1, ::-1] @ self.cosine)
        self.r = shape.length * np.where(self.t < 0.5, left, right)
        angles = 8 * m  # resolves the squares' squares
        self.phi = 2 * np.pi * np.arange(angles) / angles
        self.ds = weights * shape.length
        self.patch = self.ds[:, None] * 2 * np.pi / angles

    def lagrangian(self, w: np.ndarray) -> float:
        """Return it for the displacement whose value and first two derivatives by s are the rows of `w`."""
        m, wave = self.m, np.cos(self.m * self.phi)
        value, by_s, by_ss = (row[:, None] * wave for row in w)
        by_phi, by_sphi = (-m * row[:, None] * np.sin(m * self.phi) for row in w[:2])
        by_phiphi = -(m**2) * value
        r, z, sine, cosine, bend, bend_slope = (
            x[:, None] for x in (self.r, self.z, self.sine, self.cosine, self.bend, self.bend_slope)
        )
        nil = np.zeros_like(value)
        along, around = 1 + value * bend, r + value * sine
        x_s, x_phi = np.stack([along, nil, by_s]), np.stack([nil, around, by_phi])
        x_ss = np.stack([2 * by_s * bend + value * bend_slope, nil, by_ss - along * bend])
        x_sphi = np.stack([by_phi * bend, along * cosine + by_s * sine, by_sphi])
        x_phiphi = np.stack([-around * cosine, 2 * by_phi * sine, by_phiphi - around * sine])
        normal = np.cross(x_s, x_phi, axis=0)
        size = np.sqrt((normal**2).sum(axis=0))
        unit = normal / size
        e, f, g = (x_s**2).sum(axis=0), (x_s * x_phi).sum(axis=0), (x_phi**2).sum(axis=0)
        l_, m_, n_ = ((x * unit).sum(axis=0) for x in (x_ss, x_sphi, x_phiphi))
        twice_mean = -(e * n_ + g * l_ - 2 * f * m_) / (e * g - f**2)
        position = np.stack([r * cosine - z * sine + nil, nil, r * sine + z * cosine + value])
        energy = ((twice_mean - self.shape.spontaneous_curvature) ** 2 * size * self.patch).sum() / (16 * np.pi)
        area = (size * self.patch).sum() / (4 * np.pi)
        volume = ((position * normal).sum(axis=0) * self.patch).sum() / (4 * np.pi)
        return energy - self.shape.area_multiplier * area - self.shape.volume_multiplier * volume

    def displacement(self, k: int) -> np.ndarray:
        """sin(pi t)^m cos(k pi t), smooth at the poles, with two derivatives by s."""
        m, wave = self.m, np.pi / self.shape.length
        x = np.pi * self.t
        power, power_by, power_by2 = (
            np.sin(x) ** m,
            m * np.sin(x) ** (m - 1) * np.cos(x),
            m * (m - 1) * np.sin(x) ** max(m - 2, 0) * np.cos(x) ** 2 - m * np.sin(x) ** m,
        )
        cosine, sine = np.cos(k * x), np.sin(k * x)
        return np.stack([
            power * cosine,
            wave * (power_by * cosine - k * power * sine),
            wave**2 * (power_by2 * cosine - 2 * k * power_by * sine - k**2 * power * cosine),
        ])


def stiffness_against(shape: Shape, m: int, functions: int = 10) -> np.ndarray:
    """Return the eigenvalues, rising, of the second variation for w(s) cos(m phi), m > 0, over int w^2 dA/(2 pi R_A^4).

    At m = 1 the lowest two are zero: a shift and a turn. `functions` is the number of w(s) tried.
    """
    if m < 1:
        raise ValueError(f"m is {m}; expected at least 1: Shape.stiffness has m = 0")
    surface = _Surface(shape, m)
    base = [surface.displacement(k) for k in range(functions)]
    values = np.stack([w[0] for w in base])
    # Of equal length each, so that one step suits all.
    norms = np.sqrt(values**2 @ (surface.r * surface.ds))
    base = [w / norm for w, norm in zip(base, norms)]
    values = values / norms[:, None]
    metric = (values * (surface.r * surface.ds)) @ values.T
    at = surface.lagrangian
    middle = at(np.zeros_like(base[0]))
    second = np.empty((functions, functions))
    for i, a in enumerate(base):
        second[i, i] = (at(STEP * a) + at(-STEP * a) - 2 * middle) / STEP**2
        for j, b in enumerate(base[:i]):
            # Even in the displacement at m > 0 (a turn by pi/m), hence two terms instead of four.
            second[i, j] = second[j, i] = (at(STEP * (a + b)) - at(STEP * (a - b))) / (2 * STEP**2)
    return scipy.linalg.eigh(second, metric, eigvals_only=True)


def unstable_orders(shape: Shape, highest: int = 4) -> list[int]:
    """Return the orders m <= `highest` of deformations that lower the energy; 0 for those of revolution."""
    orders = [0] if shape.unstable_directions else []
    return orders + [m for m in range(1, highest + 1) if stiffness_against(shape, m)[0] < -1e-2]
