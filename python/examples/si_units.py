"""A case in SI units, and its metrics in SI as a table for other programs."""

import vesica

case = vesica.Case("cases/real-units.toml")
scales = case.scales
print(f"a cell is {scales.cell:.3g} m, a step {scales.step:.3g} s")
print(f"kappa is {case['vesicle_type.red-cell.bending.modulus'] * scales.unit('energy'):.3g} J")

small = case.changed({"units.cell": "0.3 um", "lattice.size": [34, 34, 24], "vesicle[0].centre": [17, 17, 12],
                      "output.metrics.every": 5})
run = vesica.run(small, "out/si_units", steps=20, overwrite=True)
table = run.scales.in_si(run.metrics)
table.to_csv("out/metrics_si.csv", index=False)
print(table[["time", "area", "volume", "tension"]])
