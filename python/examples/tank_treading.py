"""Tank-treading: how long a point of the membrane takes to go round, from the velocity on the surface."""

import numpy

import vesica

case = vesica.Case("cases/shear.toml", {"lattice.size": [32, 20, 28], "vesicle[0].centre": [16, 10, 14],
                                        "vesicle[0].radius": 6, "flow.shear.rate": 2e-3})
simulation = vesica.Simulation(case)
simulation.advance(200)  # a first look; the flow must come to the vesicle, and the vesicle to its angle

surface = simulation.surface()
offsets = surface.points - surface.centre()
plane = numpy.flatnonzero(numpy.abs(offsets[:, 1]) < 1.5)  # near the shear plane, which is across y
angle = numpy.arctan2(offsets[plane, 2], offsets[plane, 0])
edges = numpy.linspace(-numpy.pi, numpy.pi, 25)
arcs = [plane[(angle >= low) & (angle < high)] for low, high in zip(edges, edges[1:])]
x, z = (numpy.array([offsets[arc, axis].mean() for arc in arcs]) for axis in (0, 2))
u, w = (numpy.array([surface.fields["velocity"][arc, axis].mean() for arc in arcs]) for axis in (0, 2))

dx, dz = (numpy.roll(values, -1) - values for values in (x, z))  # along the closed line of the arcs' middles
length = numpy.hypot(dx, dz)
along = 0.5 * ((u + numpy.roll(u, -1)) * dx + (w + numpy.roll(w, -1)) * dz) / length
turn = abs((length / along).sum())
print(f"once round in {turn:.0f} steps: frequency {2 * numpy.pi / turn:.3e} per step")
print(f"by the metrics {simulation.sample().vesicles[0].tank_treading_frequency:.3e}; the shear's rate is 2e-3")
