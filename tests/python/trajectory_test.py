"""A simulation in Python is the program's own: the same rows, fields and checkpoints, bit for bit."""

import csv
import math
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

import h5py  # before vesica: both bring an HDF5 of their own  # noqa: E402
import numpy  # noqa: E402
import vesica  # noqa: E402
from small_runs import RELAXING, SHEARED, Scratch  # noqa: E402


def rows_of(run):
    with open(run / "metrics.csv", newline="", encoding="utf-8") as file:
        return {(int(row["step"]), int(row["vesicle"])): row for row in csv.DictReader(file)}


class Trajectory(Scratch):
    def assert_same_rows(self, samples, rows):
        """Every vesicle of every sample that the table has, to the last bit."""
        compared = 0
        for sample in samples:
            for vesicle in sample.vesicles:
                row = rows.get((sample.step, int(vesicle.vesicle)))
                if row is None:
                    continue
                for name, value in vesicle._asdict().items():
                    expected = float(row[name])
                    self.assertTrue(value == expected or math.isnan(value) and math.isnan(expected),
                                    f"step {sample.step}: {name} is {value!r}, not {expected!r}")
                compared += 1
        self.assertEqual(compared, len(rows))

    def test_rows_and_checkpoints_are_the_programs(self):
        run = self.run_program(RELAXING, "relaxing", "--threads", "2")
        case = vesica.Case.from_text(RELAXING, name=str(self.folder / "relaxing.toml"))
        simulation = vesica.Simulation(case, threads=1)
        samples = [simulation.sample()]
        for sample in simulation.run(every=3):  # between the case's own samples too
            samples.append(sample)
            if sample.step in (12, 24):
                simulation.save(self.folder / f"{sample.step}.h5")
        self.assertEqual([sample.step for sample in samples], list(range(0, 25, 3)))
        self.assert_same_rows(samples, rows_of(run))
        for step in (12, 24):
            self.assertEqual((self.folder / f"{step}.h5").read_bytes(),
                             (run / "checkpoints" / f"step_{step:09d}.h5").read_bytes())
        unwatched = vesica.Simulation(case, threads=2)
        unwatched.advance(12)  # it has measured all the same, as the checkpoint remembers
        unwatched.save(self.folder / "unwatched.h5")
        self.assertEqual((self.folder / "unwatched.h5").read_bytes(), (self.folder / "12.h5").read_bytes())
        with h5py.File(run / "fields.h5") as stored:
            for name in ("phase", "velocity", "mean_curvature"):
                field = simulation.field(name)
                self.assertEqual(field.shape[:3], (28, 24, 24))
                numpy.testing.assert_array_equal(field.astype(numpy.float32), stored[f"step_000000024/{name}"][...])

        resumed = vesica.Simulation.resume(run / "checkpoints" / "step_000000012.h5")
        self.assertEqual(resumed.step, 12)
        self.assertEqual(repr(list(resumed.run())[-1]), repr(samples[-1]))  # nan too
        numpy.testing.assert_array_equal(resumed.velocity(), simulation.velocity())
        self.assertEqual(vesica.Simulation.resume(run).step, 24)  # the newest

    def test_several_vesicles_in_shear_give_the_programs_rows(self):
        rows = rows_of(self.run_program(SHEARED, "sheared"))
        case = vesica.Case.from_text(SHEARED)
        simulation = vesica.Simulation(case)
        self.assert_same_rows([simulation.sample(), *simulation.run()], rows)

    def test_run_leaves_what_the_program_leaves(self):
        by_program = self.run_program(RELAXING, "program", "--set", "fluid.kinematic_viscosity=0.3", "--steps", "12")
        case = vesica.Case(self.folder / "program.toml")
        case["fluid.kinematic_viscosity"] = 0.3
        run = vesica.run(case, self.folder / "python", steps=12)
        for name in ("case.toml", "metrics.csv", "checkpoints/step_000000012.h5"):
            self.assertEqual((run.path / name).read_bytes(), (by_program / name).read_bytes(), name)
        vesica.resume(run.path, steps=24)
        self.program("resume", "program", "--steps", "24")
        self.assertEqual((run.path / "metrics.csv").read_bytes(), (by_program / "metrics.csv").read_bytes())
        with self.assertRaisesRegex(vesica.RunError, "overwrite"):
            vesica.run(case, run.path)


if __name__ == "__main__":
    unittest.main()
