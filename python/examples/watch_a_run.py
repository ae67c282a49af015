"""Watch the reduced volume fall while a sphere is deflated, with a bar; Ctrl-C stops and keeps what there is."""

from tqdm import tqdm

import vesica

case = vesica.Case("cases/discocyte.toml", {"lattice.size": [32, 32, 32], "vesicle[0].centre": [16, 16, 16],
                                            "vesicle[0].radius": 8, "vesicle_type.rbc.area.ramp": 100})
simulation = vesica.Simulation(case)
samples = []
try:
    for sample in tqdm(simulation.run(steps=80, every=10)):
        samples.append(sample)
except KeyboardInterrupt:
    print(f"stopped at step {simulation.step}; simulation.run() would go on")
for sample in samples:
    vesicle = sample.vesicles[0]
    print(f"step {sample.step:4d}: v = {vesicle.reduced_volume:.4f}, energy = {vesicle.bending_energy:.3f} x 8 pi kappa")
