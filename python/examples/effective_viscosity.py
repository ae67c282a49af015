"""The viscosity of a dilute suspension in shear, beside Einstein's 1 + 5/2 phi for spheres."""

import numpy

import vesica

RADIUS, SIZE = 6, (32, 24, 32)
case = vesica.Case.from_text(f"""
lattice.size = {list(SIZE)}
fluid.kinematic_viscosity = 0.5
flow.shear = {{ rate = 2e-3, velocity = "x", gradient = "z", with = "lees-edwards" }}
run.steps = 1000
output.metrics = {{ every = 10 }}
[vesicle_type.cell]
viscosity_ratio = 5.0
bending.modulus = 0.1
[[vesicle]]
type = "cell"
shape = "sphere"
centre = [16, 12, 16]
radius = {RADIUS}
""")
simulation = vesica.Simulation(case)
# A first look; a strain of 5 and several vesicles for a value to publish.
viscosity = [sample.vesicles[0].effective_viscosity for sample in simulation.run(steps=100)]
share = 4 / 3 * numpy.pi * RADIUS**3 / numpy.prod(SIZE)
print(f"volume share {share:.3f}: relative viscosity {viscosity[-1]:.4f}, Einstein's {1 + 2.5 * share:.4f}")
