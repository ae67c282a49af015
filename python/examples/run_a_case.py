"""Run a case into a directory, as `vesica run` does, and ask what became of it."""

import vesica

case = vesica.Case("cases/relaxation.toml", {"lattice.size": [32, 32, 32], "vesicle[0].centre": [16, 16, 16],
                                             "vesicle[0].radius": 8})
print(case.check())  # the plan: groups, resolution, warnings

# A first look; leave `steps` out to go as far as the case says.
run = vesica.run(case, "out/run_a_case", steps=60, overwrite=True)
print(f"{run.summary['end']} after {run.summary['last_step']} steps, {run.summary['mlups']:.1f} MLUPS")
for verdict in run.summary["verdicts"]:
    print("passed" if verdict["passed"] else "FAILED", verdict["name"], "-", verdict["text"])
