"""Keep a state, go on from it twice: the same bits; then from the same state under another law."""

import numpy

import vesica

case = vesica.Case("cases/relaxation.toml", {"lattice.size": [32, 32, 32], "vesicle[0].centre": [16, 16, 16],
                                             "vesicle[0].radius": 8})
simulation = vesica.Simulation(case)
simulation.advance(20)
simulation.save("out/rest.h5")
simulation.advance(20)

again = vesica.Simulation.resume("out/rest.h5")
again.advance(20)
print("the same bits:", numpy.array_equal(simulation.velocity(), again.velocity()), "at step", again.step)

tension = "vesicle_type.drop.tension.sigma"
slacker = case.changed({tension: 0.5 * case[tension], "initial.checkpoint": "out/rest.h5"})  # its steps count from 0
other = vesica.Simulation(slacker)
other.advance(20)
for name, run in (("as it was", again), ("half the tension", other)):
    print(f"{name}: deformation {run.sample().vesicles[0].deformation_index:.5f}")
