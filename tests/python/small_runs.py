"""Cases that take a second, and the program to compare with."""

import os
import subprocess
import tempfile
import unittest
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
PROGRAM = os.environ.get("VESICA_PROGRAM", str(SOURCE / "build/release/bin/vesica"))

RELAXING = """title = "a prolate that relaxes"
lattice.size = [24, 24, 28]
fluid.kinematic_viscosity = 0.1666667
run.steps = 24
[vesicle_type.rbc]
bending.modulus = 0.25
[[vesicle]]
type = "rbc"
shape = "prolate"
reduced_volume = 0.9
centre = [12, 12, 14]
radius = 7
[output]
metrics = { every = 6 }
surfaces = { every = 12 }
fields = { every = 12, names = ["phase", "velocity", "mean_curvature"] }
checkpoint = { every = 12 }
"""

# Two in shear, in real units: inclination, gaps, walls' stress and unwrapped centres are all there.
SHEARED = """title = "two that are sheared"
lattice.size = [48, 24, 24]
run.steps = 12
flow.shear = { rate = 2e-3, velocity = "x", gradient = "z" }
[units]
cell = "0.5 um"
time_step = "1 us"
[fluid]
kinematic_viscosity = 0.5
density = "1000 kg/m^3"
[vesicle_type.rbc]
bending.modulus = 0.1
[[vesicle]]
type = "rbc"
shape = "sphere"
centre = [12, 12, 11]
radius = 6
[[vesicle]]
type = "rbc"
shape = "sphere"
centre = [36, 12, 13]
radius = 6
[output]
metrics = { every = 4 }
surfaces = { every = 12 }
fields = { every = 12, names = ["velocity", "pressure"], region = [[8, 0, 4], [40, 24, 20]], stride = 2 }
"""


class Scratch(unittest.TestCase):
    """A folder of its own."""

    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory(prefix="vesica-python-")
        cls.addClassCleanup(scratch.cleanup)
        cls.folder = Path(scratch.name)

    @classmethod
    def program(cls, *arguments):
        """(status, standard output, standard error)"""
        done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=300, check=False,
                              cwd=cls.folder)
        return done.returncode, done.stdout, done.stderr

    @classmethod
    def run_program(cls, text, name, *arguments):
        """The directory of a run that the program has done."""
        (cls.folder / f"{name}.toml").write_text(text, encoding="utf-8")
        status, _, errors = cls.program("run", f"{name}.toml", "-o", name, *arguments)
        assert status == 0, errors
        return cls.folder / name
