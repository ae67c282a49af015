"""Follow points with the flow and draw the lines they leave: what the fluid does around a vesicle in shear."""

import numpy
from matplotlib.figure import Figure

import vesica

case = vesica.Case("cases/shear.toml", {"lattice.size": [40, 24, 32], "vesicle[0].centre": [20, 12, 16],
                                        "vesicle[0].radius": 7, "flow.shear.rate": 2e-3})
simulation = vesica.Simulation(case)
points = numpy.array([[x, 12.0, z] for x in (6.0, 20.0, 34.0) for z in numpy.linspace(3.0, 29.0, 9)])
lines, dt = [points], 5
while simulation.step < 100:
    halfway = points + 0.5 * dt * simulation.velocity_at(points)  # midpoint rule
    points = points + dt * simulation.velocity_at(halfway)
    simulation.advance(dt)
    lines.append(points)
lines = numpy.array(lines)  # (times, points, 3)

figure = Figure(figsize=(7, 5))
axes = figure.subplots()
axes.contour(simulation.phase()[:, 12, :], levels=[0.0], extent=(0.5, 39.5, 0.5, 31.5), colors="#D55E00")
axes.plot(lines[:, :, 0], lines[:, :, 2], color="#0072B2")
axes.set(aspect="equal", xlabel="x (cells)", ylabel="z (cells)")
figure.savefig("out/streaklines.png", dpi=160)
print(f"the fastest point has moved {numpy.linalg.norm(lines[-1] - lines[0], axis=1).max():.2f} cells")
