"""Stokes flow from point forces and force dipoles in a periodic box (Hasimoto 1959), summed after Ewald.

Lengths are in any unit; velocities are those of a unit force over 8 pi eta, so that a single force's is
(1 + n n)/r without images. The fluid as a whole is at rest: a uniform force pushes it back by as much as the point pushes.
`cell` holds the box's three edges as rows; a cube's may be given by its edge alone.
"""

import math

import numpy
from scipy.special import erfc

HASIMOTO = 2.837297  # of the cube: a sphere's speed is F/(6 pi eta a) (1 - 2.837297 a/L + ...)
REACH = 5.5  # exp(-REACH^2) is what the sums leave out


class PeriodicStokeslet:
    def __init__(self, cell, sharpness=None):
        edges = numpy.asarray(cell, float)
        self.cell = edges * numpy.eye(3) if edges.ndim == 0 else edges
        self.volume = abs(float(numpy.linalg.det(self.cell)))
        length = self.volume ** (1 / 3)
        self.xi = (sharpness or math.sqrt(math.pi)) / length
        self.step = 5e-4 * length  # of differences
        reciprocal = 2 * math.pi * numpy.linalg.inv(self.cell).T
        self.shifts = _lattice_points(self.cell, REACH / self.xi + length)
        k = _lattice_points(reciprocal, 2 * REACH * self.xi)
        self.k = k[(k**2).sum(axis=1) > 1e-12 / length**2]
        square = (self.k**2).sum(axis=1)
        weight = 8 * math.pi / self.volume * (1 + square / (4 * self.xi**2)) * numpy.exp(-square / (4 * self.xi**2)) / square**2
        across = square[:, None, None] * numpy.eye(3) - self.k[:, :, None] * self.k[:, None, :]
        self.waves = weight[:, None, None] * across

    def _far(self, x):
        return numpy.tensordot(numpy.cos(self.k @ x), self.waves, axes=1)

    def _near(self, x, shifts):
        r = x + shifts
        distance = numpy.linalg.norm(r, axis=1)
        gauss = 2 * self.xi / math.sqrt(math.pi) * numpy.exp(-((self.xi * distance) ** 2))
        pair = (gauss + erfc(self.xi * distance) / distance) / distance**2
        both = distance[:, None, None] ** 2 * numpy.eye(3) + r[:, :, None] * r[:, None, :]
        return numpy.einsum("n,nij->ij", pair, both) - 2 * gauss.sum() * numpy.eye(3)

    def velocity(self, x):
        """(3, 3): column j is the velocity at x, from a force along j at the origin and at all its images."""
        return self._near(numpy.asarray(x, float), self.shifts) + self._far(numpy.asarray(x, float))

    def of_images(self, x):
        """The same without the share of the force at the origin itself: smooth there. For |x| well below the edges."""
        x = numpy.asarray(x, float)
        others = self.shifts[(self.shifts**2).sum(axis=1) > 0]
        return self._near(x, others) + self._far(x) + self._screened(x)

    def _screened(self, x):
        """(What `_near` has of the origin) - (1 + n n)/r, by its series in r where the two nearly cancel."""
        r2 = float(x @ x)
        if r2 * self.xi**2 > 0.04:
            r = math.sqrt(r2)
            return self._near(x, numpy.zeros((1, 3))) - (numpy.eye(3) + numpy.outer(x, x) / r2) / r
        # With q = erf(xi r)/r = (2 xi/sqrt pi) sum (-1)^n (xi r)^2n/(n! (2n + 1)): (g - q)/r^2 (r^2 + x x) - 2 g, g the Gaussian.
        scale, y = 2 * self.xi / math.sqrt(math.pi), self.xi**2 * r2
        gauss = math.exp(-y)
        slope = sum((-1) ** n * y ** (n - 1) / math.factorial(n) * (1 - 1 / (2 * n + 1)) for n in range(1, 12))
        return scale * (self.xi**2 * slope * (r2 * numpy.eye(3) + numpy.outer(x, x)) - 2 * gauss * numpy.eye(3))

    def laplacian(self, x, images_only=False):
        """Of `velocity` at x (or of `of_images`)."""
        function = self.of_images if images_only else self.velocity
        x, h = numpy.asarray(x, float), self.step
        total = -6 * function(x)
        for axis in numpy.eye(3):
            total = total + function(x + h * axis) + function(x - h * axis)
        return total / h**2

    def gradient(self, x, images_only=False):
        """(3, 3, 3): [k, i, j] is the derivative along k of [i, j] of `velocity` at x (or of `of_images`)."""
        function = self.of_images if images_only else self.velocity
        x, h = numpy.asarray(x, float), self.step
        return numpy.array([(function(x + h * axis) - function(x - h * axis)) / (2 * h) for axis in numpy.eye(3)])

    def strain_of_images(self, dipole):
        """The rate of strain at the origin from equal force dipoles at all of its images: u_i = S_jk d_k G_ij."""
        h = self.step
        gradients = [[(self.gradient(h * e, True)[k] - self.gradient(-h * e, True)[k]) / (2 * h) for k in range(3)]
                     for e in numpy.eye(3)]  # fmt: skip
        flow = numpy.einsum("lkij,jk->li", numpy.array(gradients), dipole)  # [l, i] = d_l u_i
        return 0.5 * (flow + flow.T)


def _lattice_points(edges, radius):
    inverse = numpy.linalg.inv(edges)
    reach = [math.ceil(radius * float(numpy.linalg.norm(inverse[:, a]))) for a in range(3)]
    numbers = numpy.array(numpy.meshgrid(*[numpy.arange(-n, n + 1) for n in reach], indexing="ij")).reshape(3, -1).T
    points = numbers @ edges
    return points[numpy.linalg.norm(points, axis=1) <= radius]


def self_test():
    """Raises AssertionError unless Hasimoto's constant, the share of the counter-force, independence of how the sum is
    split, the near field and Zuzovsky, Adler and Brenner's (1983) strain in a cubic array come out."""
    cube = PeriodicStokeslet(1.0)
    at_origin = cube.of_images(numpy.zeros(3))
    assert numpy.abs(at_origin + 4 / 3 * HASIMOTO * numpy.eye(3)).max() < 2e-6, at_origin
    assert numpy.abs(cube.laplacian(numpy.zeros(3), True) - 16 * math.pi / 3 * numpy.eye(3)).max() < 1e-3
    x = numpy.array([0.31, 0.12, -0.2])
    other = PeriodicStokeslet(1.0, 2.5)
    assert numpy.abs(cube.velocity(x) - other.velocity(x)).max() < 1e-9
    free = (numpy.eye(3) + numpy.outer(x, x) / (x @ x)) / numpy.linalg.norm(x)
    assert numpy.abs(cube.velocity(x) - free - cube.of_images(x)).max() < 1e-9
    small = 0.01 * x
    assert numpy.abs(cube.of_images(small) - other.of_images(small)).max() < 1e-9
    sheared = PeriodicStokeslet([[1, 0, 0], [0, 1, 0], [1, 0, 1]])  # a whole edge further along: the same lattice
    assert numpy.abs(sheared.velocity(x) - cube.velocity(x)).max() < 1e-9
    # Whatever the lattice, over all directions of a dipole its images strain it as an even cloud of them would.
    for lattice in (cube, PeriodicStokeslet([[-0.5, 0.5, 0.5], [0.5, -0.5, 0.5], [0.5, 0.5, -0.5]])):
        along = lattice.strain_of_images(numpy.diag([1.0, -1.0, 0.0]))[0, 0]
        across = lattice.strain_of_images(numpy.array([[0, 0, 1.0], [0, 0, 0], [1.0, 0, 0]]))[0, 2]
        cloud = 8 * math.pi / 5 / lattice.volume
        assert abs((2 * along + 3 * across) / 5 / cloud - 1) < 1e-4, (along, across, cloud)
