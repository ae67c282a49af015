#!/usr/bin/python3
"""Rest shapes with spontaneous curvature: runs from the exact shapes against the minimiser's energies and profiles."""

import csv
import math
import sys
from pathlib import Path

import numpy
from reference import reference_shape
from revolved_mesh import write_ply

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "tools"))

from axisymmetric_minimiser import follow
from validation.item import Item
from validation.shapes_at_rest import bending_time, pressure_jump
from validation.simulations import Simulation
from vesica.plotting.comparison import compare
from vesica.plotting.helfrich import Meridian
from vesica.plotting.surface import fold

RADIUS, KAPPA, NU, MARGIN = 16, 0.6, 0.25, 11
BENDING_TIMES = 2
# Minima and saddles that the lattice's symmetry keeps; left out are shapes that others of revolution undercut.
ENTRIES = [(-2.0, "oblate", 0.8), (1.0, "prolate", 0.8), (1.0, "oblate", 0.667), (2.0, "prolate", 0.8),
           (2.0, "prolate", 0.667)]  # fmt: skip


def planned(item, entries=None, tag="", settings=None):
    """Entry -> (shape, Simulation); `tag` is for the name, `settings` is changed besides."""
    plans = {}
    for c0, branch, v in entries or (ENTRIES[2:3] if item.quick else ENTRIES):
        shape = reference_shape(c0, branch, v)
        length = RADIUS * v ** (-1 / 3)
        name = f"c0{c0:+g}-{branch}-v{v:g}{tag}"
        item.scratch.mkdir(parents=True, exist_ok=True)
        mesh = item.scratch / f"{name}.ply"
        write_ply(shape, mesh, RADIUS)
        across = 8 * math.ceil(2 * (shape.largest_radius * length + MARGIN) / 8)
        along = 4 * math.ceil((shape.total_height * length + 2 * MARGIN) / 4)
        steps = int(round((0.5 if item.quick else BENDING_TIMES) * bending_time(RADIUS, KAPPA, NU), -2))
        plans[c0, branch, v] = shape, Simulation(name, HERE / "vesicle.toml", {
            "lattice.size": [across, across, along], "vesicle[0].file": str(mesh),
            "vesicle[0].centre": [across / 2, across / 2, along / 2], "vesicle[0].radius": RADIUS,
            "vesicle_type.vesicle.bending.modulus": KAPPA, "fluid.kinematic_viscosity": NU,
            "vesicle_type.vesicle.bending.spontaneous_curvature": c0 / length,
            "run.steps": steps, "output.fields.every": steps, "output.surfaces.every": steps,
            "output.checkpoint.every": steps // 2, **(settings or {}),
        })  # fmt: skip
    return plans


def compared(run, shape, c0, branch, v):
    """v and C0 R_A of the run's last sample; energy, tension, pressure, each beside theory's; rms distance, cells."""
    own_v, area, volume = (run.last(name) for name in ("reduced_volume", "area", "volume"))
    length = math.sqrt(area / (4 * math.pi))
    own_c0 = c0 * length / (RADIUS * v ** (-1 / 3))
    exact = follow(shape, own_v, own_c0)
    profile = exact.profile(2001)
    disc = profile.r**2 * numpy.gradient(profile.z, profile.s)
    z = profile.z - numpy.trapz(profile.z * disc, profile.s) / numpy.trapz(disc, profile.s)
    meridian = Meridian(profile.r, z, profile.s).of_volume(volume)
    folded = fold(run.surface())
    found = min((compare(folded, branch, m) for m in (meridian, meridian.upside_down())), key=lambda c: c.rms)
    tension = run.last("tension") * length**2 / KAPPA
    jump = pressure_jump(run) * length**3 / KAPPA
    return (own_v, own_c0, run.last("bending_energy"), exact.energy, found.rms, tension, -2 * exact.area_multiplier, jump,
            6 * exact.volume_multiplier)  # fmt: skip


def check_table(results):
    """The committed table is what the minimiser gives today."""
    with open(HERE / "reference.csv", newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    worst = 0.0
    for row in rows[:4]:
        shape = reference_shape(float(row["c0_times_R_A"]), row["branch"], float(row["v"]))
        worst = max(worst, abs(shape.energy - float(row["energy"])))
    results.at_most("reference.csv against the minimiser", "largest difference of energies", worst, 1e-6)


def main():
    item = Item(__file__, "Rest shapes with spontaneous curvature")
    plans = planned(item)
    check_table(item.results)
    finished = item.run([simulation for _, simulation in plans.values()])
    rows = []
    for (c0, branch, v), (shape, simulation) in plans.items():
        run = finished[simulation.name]
        if run.failure is not None:
            continue
        row = compared(run, shape, c0, branch, v)
        energy, exact_energy, rms = row[2:5]
        name = f"C0 R_A = {c0:g}, {branch}, v = {v:g}"
        # A sphere with C0 = 0 has energy 1: where -C0 int 2H dA nearly cancels the rest, one per cent of that 1.
        item.results.absolute("energy at the run's own v and C0 R_A", name, energy, exact_energy,
                              0.01 * max(1.0, exact_energy) * (2 if item.quick else 1))  # fmt: skip
        item.results.at_most("distance from the exact profile, rms cells", name, rms, 0.15)
        rows.append((name, *row))
    item.results.table(
        f"Exact shapes after {BENDING_TIMES} bending times, R0 = {RADIUS}; theory at the run's own v and C0 R_A",
        ("shape", "v", "C0 R_A", "E", "E exact", "rms, cells", "sigma R_A²/kappa", "exact", "Δp R_A³/kappa", "exact"), rows)  # fmt: skip
    item.finish()


if __name__ == "__main__":
    main()
