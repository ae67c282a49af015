"""Energy, area and volume of a surface of revolution as functions of its meridian's sine series, with derivatives.

The meridian is psi(t) = pi t + sum_n a_n sin(n pi t), t = s/L from pole to pole, dr/ds = cos psi, dz/ds = -sin psi,
so that psi' and sin(psi)/r are the principal curvatures, positive on a sphere. With rho = r/L and m = (2H - C0) L =
dpsi/dt + sin(psi)/rho - C0 L, lengths in R_A = (A/4 pi)^(1/2) and energies in 8 pi kappa:

    energy   E/(8 pi kappa) = (1/8) int m^2 rho dt          from (kappa/2) int (2H - C0)^2 dA (Helfrich 1973)
    area     A/(4 pi)       = (L^2/2) int rho dt
    volume   V/(4 pi/3)     = (3 L^3/4) int rho^2 sin(psi) dt
    closure  [r(1)-r(0)]/L  = int cos(psi) dt

Either half of the meridian is integrated from its own pole, by Gauss-Legendre nodes that never are a pole, so that
sin(psi)/rho keeps its digits there; its limit dpsi/dt is needed only for drawing.
"""

from dataclasses import dataclass

import numpy as np
from numpy.polynomial import legendre


def cumulative_integral(count: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return Gauss-Legendre nodes and weights on (0, 1), and the matrix that integrates from 0 to each node.

    Exact for polynomials of degree count - 1, from int_-1^x P_k = (P_(k+1) - P_(k-1))/(2k + 1).
    """
    nodes, weights = legendre.leggauss(count)
    values = legendre.legvander(nodes, count)
    transform = values[:, :count] * weights[:, None] * (np.arange(count) + 0.5)
    primitive = np.empty((count, count))
    primitive[:, 0] = nodes + 1
    orders = np.arange(1, count)
    primitive[:, 1:] = (values[:, 2:] - values[:, :-2]) / (2 * orders + 1)
    return (nodes + 1) / 2, weights / 2, primitive @ transform.T / 2


#: The functionals' order in every array.
NAMES = ("energy", "area", "volume", "closure")


@dataclass(frozen=True)
class Lagrangian:
    """The functionals at one meridian, rows in the order of `NAMES`, derivatives with respect to (a_n ..., L)."""

    values: np.ndarray
    gradients: np.ndarray
    hessian: np.ndarray  #: of energy - sum multiplier * constraint


class MeridianFunctionals:
    """The four functionals for a fixed set of orders n, `nodes` quadrature points on either half."""

    def __init__(self, orders: np.ndarray, nodes: int = 0):
        self.orders = np.asarray(orders, dtype=int)
        half, weights, integral = cumulative_integral(nodes or max(48, int(self.orders.max()) + 24))
        count = half.size
        self.t = np.concatenate([half / 2, 1 - half[::-1] / 2])
        self.weights = np.concatenate([weights, weights[::-1]]) / 2
        # rho in the second half is -int_t^1 cos(psi): the same matrix, seen from the other pole.
        self.integral = np.zeros((2 * count, 2 * count))
        self.integral[:count, :count] = integral / 2
        self.integral[count:, count:] = -integral[::-1, ::-1] / 2
        phase = np.pi * np.outer(self.t, self.orders)
        self.sines = np.sin(phase)
        self.slopes = np.pi * self.orders * np.cos(phase)

    def evaluate(
        self, coefficients: np.ndarray, length: float, spontaneous_curvature: float, multipliers: np.ndarray
    ) -> Lagrangian:
        """Return the functionals and the Hessian of energy - multipliers . (area, volume, closure).

        `length` and 1/`spontaneous_curvature` are in R_A.
        """
        c, long = spontaneous_curvature, length
        psi = np.pi * self.t + self.sines @ coefficients
        slope = np.pi + self.slopes @ coefficients
        sine, cosine = np.sin(psi), np.cos(psi)
        rho = self.integral @ cosine
        ratio = sine / rho
        m = slope + ratio - c * long
        square, cube = rho**2, 0.75 * long**3
        zero, one = np.zeros_like(rho), np.ones_like(rho)
        densities = np.stack([m**2 * rho / 8, long**2 * rho / 2, cube * square * sine, cosine])
        # Their partial derivatives with respect to u = dpsi/dt, psi, rho and L.
        by_slope = np.stack([m * rho / 4, zero, zero, zero])
        by_psi = np.stack([m * cosine / 4, zero, cube * square * cosine, -sine])
        by_rho = np.stack([m**2 / 8 - m * ratio / 4, long**2 / 2 * one, 2 * cube * rho * sine, zero])
        by_length = np.stack([-c * m * rho / 4, long * rho, 2.25 * long**2 * square * sine, zero])
        change = -self.integral @ (sine[:, None] * self.sines)  # of rho with a_n
        w = self.weights
        by_length = by_length @ w
        gradients = np.column_stack(
            [(w * by_slope) @ self.slopes + (w * by_psi) @ self.sines + (w * by_rho) @ change, by_length]
        )
        # The second derivatives of the Lagrangian's density.
        weight_of = np.append(1.0, -np.asarray(multipliers))
        area, volume, closure = weight_of[1:]
        volume = volume * cube
        uu, up, ur, ul = rho / 4, cosine / 4, (m - ratio) / 4, -c * rho / 4
        pp = (cosine**2 / rho - m * sine) / 4 - volume * square * sine - closure * cosine
        pr = -ratio * cosine / (4 * rho) + 2 * volume * rho * cosine
        pl = -c * cosine / 4 + 3 / long * volume * square * cosine
        rr = ratio**2 / (4 * rho) + 2 * volume * sine
        rl = -c * (m - ratio) / 4 + area * long + 6 / long * volume * rho * sine
        ll = c**2 * rho / 4 + area * rho + 6 / long**2 * volume * square * sine
        # d2 rho/da da = -integral @ (cos(psi) sines sines), contracted with the derivative by rho.
        pp = w * pp - cosine * (self.integral.T @ (w * (weight_of @ by_rho)))
        # Symmetrised below, hence half of the diagonal terms.
        half = (
            self.slopes.T @ ((w * uu / 2)[:, None] * self.slopes + (w * up)[:, None] * self.sines
                             + (w * ur)[:, None] * change)
            + self.sines.T @ ((pp / 2)[:, None] * self.sines + (w * pr)[:, None] * change)
            + change.T @ ((w * rr / 2)[:, None] * change)
        )
        size = self.orders.size
        hessian = np.empty((size + 1, size + 1))
        hessian[:size, :size] = half + half.T
        hessian[:size, size] = (w * ul) @ self.slopes + (w * pl) @ self.sines + (w * rl) @ change
        hessian[size, :size] = hessian[:size, size]
        hessian[size, size] = w @ ll
        return Lagrangian(densities @ w, gradients, hessian)
