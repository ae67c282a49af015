"""Cases that start from an earlier run's state."""

import shutil

from tests.cli.program_test import SMALL, Program

INITIAL = '[initial]\ncheckpoint = "{checkpoint}"\n'


class Initial(Program):
    def setUp(self):
        super().setUp()
        self.case.write_text(SMALL.replace('shape = "sphere"', 'shape = "spheroid"\naspect = 0.8'))
        self.assertEqual(self.vesica("run", self.case, "-o", "rest", "--threads", 1)[0], 0)

    def continued(self, checkpoint="rest", more=""):
        """A case like the first, from what the first has reached."""
        path = self.directory / "continued.toml"
        path.write_text(self.case.read_text() + INITIAL.format(checkpoint=checkpoint) + more)
        return path

    def rows(self, directory):
        """Rows of metrics.csv without what counts from the run's own beginning: step and time."""
        lines = (self.directory / directory / "metrics.csv").read_text().splitlines()
        names = lines[0].split(",")
        return [dict(zip(names[2:], line.split(",")[2:], strict=True)) for line in lines[1:]]

    def test_a_run_goes_on_from_another_ones_state_bit_for_bit(self):
        status, _, errors = self.vesica("run", self.continued(more="step = 20\n"), "-o", "second", "--steps", 20)
        self.assertEqual(status, 0, errors)
        first, second = self.rows("rest"), self.rows("second")
        self.assertEqual(len(second), 3)
        for before, after in zip(first[2:], second, strict=True):
            for name in ("area", "volume", "bending_energy", "x", "inertia_1", "tension", "max_speed", "gap"):
                self.assertEqual(before[name], after[name], name)
        self.assertIn("starts from step 20 of", (self.directory / "second/log.txt").read_text())

    def test_the_newest_state_a_single_file_and_other_parameters_serve(self):
        single = "rest/checkpoints/step_000000040.h5"
        for name, checkpoint in (("newest", "rest"), ("single", single)):
            status, _, errors = self.vesica("run", self.continued(checkpoint), "-o", name, "--steps", 10, "--set",
                                            "vesicle_type.rbc.bending.modulus=0.5", "--set",
                                            "fluid.kinematic_viscosity=0.1")
            self.assertEqual(status, 0, errors)
        self.assertEqual(self.rows("newest"), self.rows("single"))
        self.assertEqual(self.rows("newest")[0]["volume"], self.rows("rest")[-1]["volume"])
        self.assertEqual(self.vesica("run", self.continued(), "-o", "same", "--steps", 10)[0], 0)
        self.assertEqual(self.rows("same")[0]["area"], self.rows("newest")[0]["area"])
        self.assertNotEqual(self.rows("same")[1]["area"], self.rows("newest")[1]["area"])

    def test_it_resumes_without_what_it_started_from(self):
        case = self.continued()
        self.assertEqual(self.vesica("run", case, "-o", "whole")[0], 0)
        self.assertEqual(self.vesica("run", case, "-o", "halves", "--steps", 20)[0], 0)
        shutil.rmtree(self.directory / "rest")
        status, _, errors = self.vesica("resume", "halves", "--steps", 40)
        self.assertEqual(status, 0, errors)
        self.assertEqual(self.rows("halves"), self.rows("whole"))

    def test_check_says_where_it_starts(self):
        status, out, errors = self.vesica("check", self.continued())
        self.assertEqual(status, 0, errors)
        self.assertRegex(out, r"starts from step 40 of .*/rest/checkpoints/step_000000040\.h5")

    def test_what_cannot_serve_is_refused_at_its_place(self):
        case = self.continued("nowhere")
        line = 1 + case.read_text().splitlines().index('checkpoint = "nowhere"')
        for command in ("run", "check"):
            self.refused(command, case, saying=[f"continued.toml:{line}:", 'initial.checkpoint is "nowhere"',
                                                "no such file or directory"])
        (self.directory / "empty").mkdir()
        self.refused("run", self.continued("empty"), saying=[f"continued.toml:{line}:", "left a checkpoint"])
        self.refused("run", self.continued(more="step = 30\n"), saying=["initial.step is 30", "step_000000030.h5"])
        self.refused("run", self.continued("rest/checkpoints/step_000000040.h5", "step = 40\n"),
                     saying=["initial.step is 40", "expected none"])
        for change, name in (("lattice.size=[32, 32, 40]", "lattice.size"), ("fluid.density=2", "fluid.density"),
                             ('numerics.precision="single"', "numerics.precision")):
            self.refused("run", self.continued(), "--set", change, saying=[f"{name} in ", "try the same in both"])
        for checkpoint in (self.directory / "rest/checkpoints").iterdir():
            checkpoint.write_bytes(checkpoint.read_bytes()[:-1])
        self.refused("run", self.continued(), saying=["initial.checkpoint", "intact"])
        self.assertFalse((self.directory / "out").exists())
