"""A vesicle in shear: its inclination and tank-treading beside Keller's and Skalak's theory."""

import vesica

case = vesica.Case("cases/shear.toml", {"lattice.size": [40, 24, 32], "vesicle[0].centre": [20, 12, 16],
                                        "vesicle[0].radius": 7, "flow.shear.rate": 2e-3, "output.metrics.every": 10})
# A first look; 2000 steps and a box of 6 R0 for the steady angle.
run = vesica.run(case, "out/shear_a_vesicle", steps=120, overwrite=True)
run.plot("angle").savefig("out/angle.png")
last = run.metrics.iloc[-1]
print(f"inclination {last.inclination:.1f} degrees, Taylor deformation {last.taylor_deformation:.3f}")
