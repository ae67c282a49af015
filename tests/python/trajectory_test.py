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

    def test_a_checkpoint_leaves_out_tracers_and_averages_and_nothing_else(self):
        text = RELAXING.replace('"mean_curvature"] }', '"mean_curvature"], average = true }')
        text = text.replace("checkpoint = { every = 12 }", "checkpoint = { every = 6 }")
        text += '[tracers]\nevery = 6\n[[tracers.seeds]]\nfrom = [3, 3, 3]\n'
        run = self.run_program(text, "followed", "--steps", "6")
        theirs, ours = run / "checkpoints/step_000000006.h5", self.folder / "followed.h5"
        simulation = vesica.Simulation(vesica.Case.from_text(text, {"run.steps": 6}))
        simulation.advance(6)
        simulation.save(ours)

        def contents(path):
            found = {}
            with h5py.File(path) as file:
                file.visititems(lambda name, item: found.update({name: item[()]})
                                if isinstance(item, h5py.Dataset) else None)
            return found

        whole, rest = contents(theirs), contents(ours)
        missing = set(whole) - set(rest)
        self.assertEqual(set(rest) - set(whole), set())
        self.assertEqual(missing, {"notes/tracers", "notes/average_samples", "sums/phase", "sums/velocity",
                                   "sums/mean_curvature"})
        for name in rest:
            numpy.testing.assert_array_equal(rest[name], whole[name], name)

        resumed = vesica.Simulation.resume(ours)
        resumed.advance(2)
        simulation.advance(2)
        numpy.testing.assert_array_equal(resumed.velocity(), simulation.velocity())
        theirs.write_bytes(ours.read_bytes())
        status, _, errors = self.program("resume", "followed", "--steps", "12")
        self.assertEqual(status, 1)
        self.assertIn("the checkpoint does not remember its tracers", errors)
        self.run_program(f'initial.checkpoint = "{ours}"\n' + text, "started", "--steps", "6")

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

    def test_counts_that_cannot_be_are_refused_before_anything_is_written(self):
        case, folder = vesica.Case.from_text(RELAXING), self.folder / "refused"
        for wrong in (0, -5, 1.5, "10", True):
            with self.assertRaisesRegex(vesica.InputError, "steps is .*; expected a whole number of at least 1"):
                vesica.run(case, folder, steps=wrong)
            with self.assertRaisesRegex(vesica.InputError, "steps is .*; expected a whole number of at least 1"):
                vesica.resume(folder, steps=wrong)
        for serve in (lambda threads: vesica.run(case, folder, threads=threads), case.check,
                      lambda threads: vesica.resume(folder, threads=threads)):
            for wrong in (0, -3, 1.5):
                with self.assertRaisesRegex(vesica.InputError, "threads is .*; expected a whole number of at least 1"):
                    serve(wrong)
        self.assertFalse(folder.exists())


if __name__ == "__main__":
    unittest.main()
