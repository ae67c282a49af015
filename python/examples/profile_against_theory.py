"""Let the exact discocyte rest on the lattice, and compare its profile and energy with Helfrich's."""

import vesica

case = vesica.Case.from_text("""
title = "A discocyte at rest"
lattice.size = [40, 40, 28]
fluid.kinematic_viscosity = 0.5
run.steps = 40
output = { metrics = { every = 10 }, surfaces = { every = 40 } }
[vesicle_type.rbc]
bending.modulus = 0.1
[[vesicle]]
type = "rbc"
shape = "discocyte"
reduced_volume = 0.7
centre = [20, 20, 14]
radius = 10
""")
run = vesica.run(case, "out/profile_against_theory", overwrite=True)
run.plot("profile").savefig("out/profile.png")
run.plot("energy").savefig("out/energy.png")
print(run.metrics[["reduced_volume", "bending_energy"]])
