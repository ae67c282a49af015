"""What the program says and returns, as a user meets it: exit status, stdout, stderr."""

import json
import os
import re
import signal
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
PROGRAM = os.environ.get("VESICA_PROGRAM", str(SOURCE / "build/release/bin/vesica"))

SMALL = """title = "small"
[lattice]
size = [32, 32, 32]
[fluid]
kinematic_viscosity = 0.1666667
[vesicle_type.rbc]
[vesicle_type.rbc.bending]
modulus = 0.25
[[vesicle]]
type = "rbc"
shape = "sphere"
centre = [16, 16, 16]
radius = 8
[run]
steps = 40
[output]
metrics = { every = 10 }
surfaces = { every = 20 }
checkpoint = { every = 20 }
"""


class Program(unittest.TestCase):
    """Runs the program in a directory of its own."""

    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="vesica-cli-")
        self.addCleanup(scratch.cleanup)
        self.directory = Path(scratch.name)
        self.case = self.directory / "small.toml"
        self.case.write_text(SMALL)

    def vesica(self, *arguments, environment=None):
        """Run with these arguments; return status, stdout, stderr."""
        done = subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.directory, capture_output=True, text=True,
                              timeout=300, check=False, env={**os.environ, **(environment or {})})
        return done.returncode, done.stdout, done.stderr

    def refused(self, *arguments, saying, status=2, environment=None):
        """Expect this status, nothing but words on stderr, and each of `saying` in them."""
        returned, _, errors = self.vesica(*arguments, environment=environment)
        self.assertEqual(returned, status, errors)
        for part in saying if isinstance(saying, (list, tuple)) else [saying]:
            self.assertIn(part, errors)
        self.assertNotIn("terminate called", errors)
        return errors


class CommandLine(Program):
    def test_help_and_version_are_answers_not_errors(self):
        status, out, errors = self.vesica("--help")
        self.assertEqual((status, errors), (0, ""))
        for command in ("run", "check", "resume", "new", "info", "bench", "reproduce", "report"):
            self.assertRegex(out, rf"(?m)^  {command}\b")
        status, out, errors = self.vesica("--version")
        self.assertEqual((status, errors), (0, ""))
        self.assertRegex(out, r"^vesica \d+\.\d+\.\d+")

    def test_every_command_explains_itself(self):
        for command in ("run", "check", "resume", "new", "info", "bench", "reproduce", "report"):
            status, out, _ = self.vesica(command, "--help")
            self.assertEqual(status, 0, command)
            self.assertIn("Usage:", out)

    def test_no_command_is_misuse(self):
        self.refused(saying="Usage:")

    def test_an_unknown_command_names_the_nearest(self):
        self.refused("rum", self.case, saying=["rum is not a command", "try `vesica run`"])

    def test_unknown_options_and_missing_arguments_are_misuse(self):
        self.refused("run", saying=["case is required", "vesica run --help"])
        self.refused("run", self.case, "--fast", saying=["--fast", "vesica run --help"])
        self.refused("--verbose", saying="--verbose")

    def test_numbers_of_options_are_whole_and_in_range(self):
        for steps in ("many", "-3", "0", "1.5", "99999999999999999999", ""):
            self.refused("run", self.case, "--steps", steps,
                         saying=f"--steps is {steps or 'empty'}; expected a whole number from 1 to 1000000000000000; try")
        for threads in ("0", "1000000"):
            self.refused("run", self.case, "--threads", threads,
                         saying=f"--threads is {threads}; expected a whole number from 1 to 4096; try --threads 2")
        self.refused("resume", "out", "--steps", "0", saying="--steps is 0; expected a whole number")
        self.refused("bench", "--seconds", "-1", saying="not in range 0.001")

    def test_an_answer_that_cannot_be_written_is_a_failure(self):
        for arguments in (["--help"], ["check", "--model"], ["new", "-o", "-"], ["info", self.case]):
            with open("/dev/full", "w", encoding="utf-8") as full:
                done = subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.directory, stdout=full,
                                      stderr=subprocess.PIPE, text=True, timeout=60, check=False)
            self.assertEqual(done.returncode, 1, arguments)
            self.assertIn("the standard output cannot be written", done.stderr)


class Input(Program):
    def test_a_missing_case_file(self):
        self.refused("run", "none.toml", saying="none.toml")
        self.refused("check", "none.toml", saying="none.toml")
        self.refused("check", saying="the case file is missing")

    def test_a_mistake_has_its_place(self):
        self.case.write_text(SMALL.replace("radius = 8", 'radius = "eight"'))
        for command in ("run", "check"):
            errors = self.refused(command, self.case, saying="vesicle[0].radius")
            self.assertRegex(errors, r"small\.toml:13:\d+: ")

    def test_an_unknown_key_names_the_nearest(self):
        self.case.write_text(SMALL.replace("kinematic_viscosity", "kinematic_viscosty"))
        self.refused("check", self.case, saying=["kinematic_viscosty", "fluid.kinematic_viscosity"])

    def test_a_wrong_override_is_named(self):
        self.refused("run", self.case, "--set", "fluid.kinematic_viscosity", saying="fluid.kinematic_viscosity")
        self.refused("run", self.case, "--set", "fluid.viscous=3", saying="fluid.viscous")

    def test_what_run_refuses_check_refuses(self):
        soft = ("--set", "vesicle_type.rbc.bending.modulus=0.002")
        for command in ("run", "check"):
            self.refused(command, self.case, *soft, saying=["bending.modulus", "--accept-soft-membranes"])
        self.assertFalse((self.directory / "out/small").exists())
        self.assertEqual(self.vesica("check", self.case, *soft, "--accept-soft-membranes")[0], 0)

    def test_a_directory_that_is_not_empty(self):
        target = self.directory / "target"
        target.mkdir()
        (target / "thesis.tex").write_text("precious")
        self.refused("run", self.case, "-o", target, status=1, saying=["not empty", "--overwrite"])
        self.assertEqual((target / "thesis.tex").read_text(), "precious")

    def test_a_directory_that_is_a_file_or_has_no_name(self):
        self.refused("run", self.case, "-o", self.case, status=1, saying="small.toml: is a file; expected a directory")
        self.refused("run", self.case, "-o", "", saying="-o is empty; expected a directory")
        self.refused("new", "-o", "", saying="-o is empty; expected a new file")

    def test_a_directory_that_cannot_be_written(self):
        target = self.directory / "sealed"
        target.mkdir(mode=0o500)
        # Root writes everywhere unless it gives up the capability to do so.
        humbly = ["setpriv", "--bounding-set=-dac_override"] if os.geteuid() == 0 else []
        for arguments in (["-o", target], ["-o", target / "below"]):
            done = subprocess.run([*humbly, PROGRAM, "run", self.case, *arguments], cwd=self.directory,
                                  capture_output=True, text=True, timeout=60, check=False)
            self.assertEqual(done.returncode, 1, done.stderr)
            self.assertRegex(done.stderr, r"sealed.*: cannot .*: Permission denied")
        self.assertEqual(list(target.iterdir()), [])

    def test_nothing_to_resume(self):
        self.refused("resume", "none", saying="none")
        (self.directory / "empty").mkdir()
        self.refused("resume", "empty", saying="empty")

    def test_info_of_what_is_no_output(self):
        self.refused("info", "none.h5", saying="none.h5")


class Check(Program):
    def test_the_shipped_discocyte_has_no_warning(self):
        status, out, errors = self.vesica("check", SOURCE / "cases/discocyte.toml")
        self.assertEqual((status, errors), (0, ""))
        self.assertIn("accepted, no warnings", out)
        for row in ("relaxation time", "Mach number", "bending time", "reduced volume", "confinement",
                    "viscosity ratio", "memory", "run time"):
            self.assertIn(row, out)

    def test_the_model_says_what_it_lacks(self):
        status, out, _ = self.vesica("check", "--model")
        self.assertEqual(status, 0)
        for missing in ("thermal noise", "area-difference elasticity", "adhesion", "osmosis", "shear elasticity"):
            self.assertIn(missing, out)


class Run(Program):
    def test_a_run_leaves_its_files(self):
        status, out, errors = self.vesica("run", self.case, "-o", "target", "--set", "run.steps=20", "--threads", 1)
        self.assertEqual((status, errors), (0, ""))
        target = self.directory / "target"
        self.assertEqual((target / "case.toml").read_text(), SMALL)
        for name in ("resolved.toml", "metrics.csv", "summary.json", "log.txt", "surfaces/surfaces.pvd",
                     "checkpoints/step_000000020.h5"):
            self.assertTrue((target / name).is_file(), name)
        rows = (target / "metrics.csv").read_text().splitlines()
        self.assertTrue(rows[0].startswith("step,time,vesicle,area,area_ratio,volume,reduced_volume,bending_energy"))
        self.assertEqual([row.split(",")[0] for row in rows[1:]], ["0", "10", "20"])
        self.assertEqual(json.loads((target / "summary.json").read_text())["end"], "finished")
        self.assertLess(len(out.splitlines()), 10)
        self.assertNotIn("\r", out)

    def test_the_default_directory_is_named_after_the_case(self):
        self.assertEqual(self.vesica("run", self.case, "--steps", 5, "--threads", 1)[0], 0)
        self.assertTrue((self.directory / "out/small/summary.json").is_file())
        self.refused("run", self.case, "--steps", 5, status=1, saying="--overwrite")
        self.assertEqual(self.vesica("run", self.case, "--steps", 5, "--overwrite")[0], 0)

    def test_info_tells_of_a_checkpoint(self):
        self.vesica("run", self.case, "-o", "target", "--steps", 20)
        status, out, _ = self.vesica("info", "target/checkpoints/step_000000020.h5")
        self.assertEqual(status, 0)
        self.assertIn("20", out)
        damaged = self.directory / "target/checkpoints/step_000000020.h5"
        damaged.write_bytes(damaged.read_bytes()[:-1])
        status, out, errors = self.vesica("info", damaged)
        self.assertEqual(status, 1)
        self.assertIn("checkpoint, NOT INTACT", out)
        self.assertIn("is not intact", errors)

    def test_two_halves_are_one_whole_bit_for_bit(self):
        self.assertEqual(self.vesica("run", self.case, "-o", "whole", "--threads", 1)[0], 0)
        self.assertEqual(self.vesica("run", self.case, "-o", "halves", "--steps", 15, "--threads", 1)[0], 0)
        status, _, errors = self.vesica("resume", "halves", "--steps", 40, "--threads", 2)
        self.assertEqual(status, 0, errors)
        whole, halves = self.directory / "whole", self.directory / "halves"
        self.assertEqual((whole / "metrics.csv").read_text(), (halves / "metrics.csv").read_text())
        last = "surfaces/surface_000000040.vtp"
        self.assertEqual((whole / last).read_bytes(), (halves / last).read_bytes())

    def test_signals_stop_with_a_checkpoint(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGUSR1):
            target = self.directory / f"stopped-{number}"
            with subprocess.Popen([PROGRAM, "run", self.case, "-o", target, "--steps", "1000000"],
                                  cwd=self.directory, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                  text=True) as running:
                metrics = target / "metrics.csv"
                deadline = time.monotonic() + 60
                while time.monotonic() < deadline and not (metrics.is_file() and metrics.stat().st_size > 600):
                    time.sleep(0.05)
                running.send_signal(number)
                _, errors = running.communicate(timeout=60)
            self.assertEqual(running.returncode, 3, errors)
            self.assertIn(f"vesica resume {target}", errors)
            stopped = int(re.search(r"after step (\d+)", errors)[1])
            self.assertTrue((target / f"checkpoints/step_{stopped:09}.h5").is_file())

    def test_a_signal_while_the_initial_state_is_built_stops_with_a_checkpoint_too(self):
        target = self.directory / "target"
        with subprocess.Popen([PROGRAM, "run", self.case, "-o", target, "--steps", "1000000"], cwd=self.directory,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as running:
            deadline = time.monotonic() + 60
            while time.monotonic() < deadline and not (target / "case.toml").is_file():
                time.sleep(0.001)
            running.send_signal(signal.SIGTERM)
            _, errors = running.communicate(timeout=60)
        self.assertEqual(running.returncode, 3, errors)
        self.assertEqual(len(list((target / "checkpoints").iterdir())), 1)

    def test_the_wall_time_stops_with_a_checkpoint(self):
        status, _, errors = self.vesica("run", self.case, "-o", "target", "--steps", 1000000, "--set",
                                        'run.wall_time="1 s"')
        self.assertEqual(status, 3)
        self.assertIn("wall time", errors)

    def test_a_run_that_breaks_fails_with_its_place_and_keeps_what_it_wrote(self):
        status, _, errors = self.vesica("run", self.case, "-o", "target", "--steps", 5000, "--set",
                                        "vesicle_type.rbc.bending.modulus=12", "--set", "vesicle[0].shape=spheroid",
                                        "--set", "vesicle[0].aspect=0.7")
        self.assertEqual(status, 1, errors)
        self.assertRegex(errors, r"failed at step \d+, cell \(\d+, \d+, \d+\)")
        self.assertIn("likely cause", errors)
        target = self.directory / "target"
        self.assertEqual(json.loads((target / "summary.json").read_text())["end"], "failed")
        self.assertGreater(len((target / "metrics.csv").read_text().splitlines()), 1)


class Profile(Program):
    def test_it_says_where_the_steps_went(self):
        status, out, errors = self.vesica("run", self.case, "-o", "target", "--set", "run.steps=20", "--threads", 1,
                                          "--profile")
        self.assertEqual((status, errors), (0, ""))
        parts = ("fluid", "transport", "locate", "normals", "curvatures", "slopes", "forces")
        shares = [float(re.search(rf"^ +{part} .* (\d+\.\d) %", out, re.MULTILINE).group(1)) for part in parts]
        self.assertAlmostEqual(sum(shares), 100, delta=2)
        profile = json.loads((self.directory / "target" / "summary.json").read_text())["profile"]
        self.assertEqual(profile["steps"], 20)
        self.assertGreater(profile["core_nanoseconds_per_cell"], 0)
        self.assertGreater(profile["core_nanoseconds_more_per_interface_cell"], 0)
        self.assertGreater(profile["interface_cells_per_step"], 100)

    def test_without_it_the_summary_alone_has_the_numbers(self):
        _, out, _ = self.vesica("run", self.case, "-o", "target", "--set", "run.steps=5", "--threads", 1)
        self.assertNotIn("ns a cell", out)
        self.assertIn("profile", json.loads((self.directory / "target" / "summary.json").read_text()))


class Bench(Program):
    def test_the_numbers_are_there_as_json(self):
        status, out, _ = self.vesica("bench", "--json", "--size", 32, "--threads", 1, "--seconds", 0.05)
        self.assertEqual(status, 0)
        report = json.loads(out)
        self.assertEqual({(case["name"], case["precision"]) for case in report["cases"]},
                         {(name, precision) for name in ("fluid", "mrt", "discocyte", "crowd")
                          for precision in ("double", "single")})
        for limit in report["limits"]:
            self.assertGreater(limit["bandwidth_mlups"], 0)
            self.assertGreater(limit["streaming_mlups"], 0)
        for case in report["cases"]:
            self.assertGreater(case["mlups"], 0)
            self.assertGreater(case["bytes_per_cell"], (152 if case["precision"] == "double" else 76))
            self.assertEqual(case["interface_fraction"] > 0, case["name"] in ("discocyte", "crowd"))

    def test_a_box_too_small_to_measure_is_refused(self):
        self.refused("bench", "--size", 8, saying="--size is 8")

    def test_chosen_cases_alone_are_measured_beside_the_limits_they_took_turns_with(self):
        status, out, _ = self.vesica("bench", "--json", "--size", 32, "--threads", 1, "--seconds", 0.05,
                                     "--case", "mrt", "--case", "fluid")
        self.assertEqual(status, 0)
        report = json.loads(out)
        self.assertEqual([(case["name"], case["precision"]) for case in report["cases"]],
                         [(name, precision) for precision in ("double", "single") for name in ("fluid", "mrt")])
        for case in report["cases"]:
            self.assertAlmostEqual(case["over_streaming"], case["mlups"] / case["streaming_mlups"])
            self.assertAlmostEqual(case["over_bandwidth"], case["mlups"] / case["bandwidth_mlups"])
            limit = next(limit for limit in report["limits"] if limit["precision"] == case["precision"])
            self.assertGreaterEqual(limit["streaming_mlups"], case["streaming_mlups"])

    def test_an_unknown_case_is_named_beside_the_known_ones(self):
        self.refused("bench", "--case", "drop", saying=["--case is \"drop\"", "fluid, mrt, discocyte, crowd"])


class New(Program):
    def test_every_template_is_accepted_without_a_warning(self):
        status, out, _ = self.vesica("new", "--list")
        self.assertEqual(status, 0)
        names = [line.split()[0] for line in out.splitlines() if line.strip()]
        self.assertGreater(len(names), 1)
        for name in names:
            target = self.directory / f"{name}.toml"
            self.assertEqual(self.vesica("new", name, "-o", target)[0], 0)
            status, out, errors = self.vesica("check", target)
            self.assertEqual((status, errors), (0, ""), name)
            self.assertIn("accepted, no warnings", out, name)

    def test_an_existing_file_is_not_replaced(self):
        self.refused("new", "-o", self.case, saying="small.toml")
        self.assertEqual(self.case.read_text(), SMALL)

    def test_an_unknown_template_names_the_known_ones(self):
        self.refused("new", "discocite", saying="discocyte")


if __name__ == "__main__":
    unittest.main()
