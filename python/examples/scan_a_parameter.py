"""How far shear deforms a drop, for a few capillary numbers: D = 35/32 Ca when it is steady and Ca is small (Taylor)."""

import pandas

import vesica

RADIUS, VISCOSITY, TENSION = 7.0, 0.5, 0.1
STEPS = 120  # a first look; twenty capillary times (viscosity RADIUS/TENSION) for the steady deformation
drop = vesica.Case.from_text(f"""
lattice.size = [32, 24, 32]
fluid.kinematic_viscosity = {VISCOSITY}
flow.shear = {{ rate = 1e-3, velocity = "x", gradient = "z" }}
run.steps = 1000
[vesicle_type.drop]
area.constraint = "none"
bending.modulus = 0.0
tension.sigma = {TENSION}
[[vesicle]]
type = "drop"
shape = "sphere"
centre = [16, 12, 16]
radius = {RADIUS}
""")
rows = []
for capillary in (0.02, 0.05, 0.1):
    rate = capillary * TENSION / (VISCOSITY * RADIUS)
    simulation = vesica.Simulation(drop.changed({"flow.shear.rate": rate}))
    simulation.advance(STEPS)
    vesicle = simulation.sample().vesicles[0]
    rows.append({"Ca": capillary, "D": vesicle.taylor_deformation, "inclination": vesicle.inclination})
print(pandas.DataFrame(rows).to_string(index=False))
