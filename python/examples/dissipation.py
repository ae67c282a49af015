"""Compute something from the velocity field: where the power goes that viscosity turns into heat."""

import numpy

import vesica

case = vesica.Case("cases/shear.toml", {"lattice.size": [40, 24, 32], "vesicle[0].centre": [20, 12, 16],
                                        "vesicle[0].radius": 7, "flow.shear.rate": 2e-3})
simulation = vesica.Simulation(case)
simulation.advance(80)

u = simulation.velocity()  # (nz, ny, nx, 3); axes z, y, x and components x, y, z
gradient = numpy.stack([numpy.gradient(u, axis=axis) for axis in (2, 1, 0)], axis=-1)  # [..., i, j] = d u_i/d x_j
strain = 0.5 * (gradient + numpy.swapaxes(gradient, -1, -2))
viscosity = case["fluid.kinematic_viscosity"] * case["fluid.density"]
heat = 2.0 * viscosity * (strain**2).sum(axis=(-1, -2))  # per volume and time
inside = simulation.phase() > 0.0
print(f"divergence, largest: {abs(numpy.trace(gradient, axis1=-2, axis2=-1)).max():.1e}")
print(f"power: {heat.sum():.3e}, inside the vesicle {heat[inside].sum() / heat.sum():.1%} of it")
