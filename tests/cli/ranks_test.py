"""One run on several ranks: the same bits, the same files, one voice, and nothing lost when ranks die."""

import hashlib
import itertools
import json
import os
import random
import re
import resource
import shutil
import signal
import subprocess
import time
import unittest
import unittest.mock
from pathlib import Path

import h5py
import numpy as np

from tests.cli import ranks
from tests.cli.program_test import PROGRAM, SMALL, Program

STEPS = 60
# A deforming vesicle over the box's faces; forty cells are what eight ranks can share.
CASE = (
    SMALL.replace("size = [32, 32, 32]", "size = [24, 40, 40]")
    .replace('shape = "sphere"', 'shape = "spheroid"\naspect = 0.8')
    .replace("centre = [16, 16, 16]\nradius = 8", "centre = [3, 12, 38]\nradius = 6")
    .replace("steps = 40", f"steps = {STEPS}")
    .replace("surfaces = { every = 20 }", 'surfaces = { every = 30 }\nfields = { every = 30, names = ["phase", "velocity"], average = true }')
    .replace("checkpoint = { every = 20 }", "checkpoint = { every = 10, keep = 2 }")
)


def digest(path, whole):
    """Of the bytes; of a checkpoint's arrays, for the text of its case tells how many steps were asked for."""
    if whole or path.parent.name != "checkpoints":
        return hashlib.sha256(path.read_bytes()).hexdigest()
    arrays = {}
    with h5py.File(path) as checkpoint:
        checkpoint.visititems(lambda name, item: arrays.__setitem__(name, hashlib.sha256(item[...].tobytes()).hexdigest())
                              if isinstance(item, h5py.Dataset) and name != "case" else None)
    assert {"band", "controllers", "minority", "populations", "notes/colour_mass"} <= set(arrays)
    return arrays


def grown(cells):
    """These cells and those one link of D3Q19 away, periodically."""
    larger = cells.copy()
    for shift in itertools.product((-1, 0, 1), repeat=3):
        if 1 <= sum(map(abs, shift)) <= 2:
            larger |= np.roll(cells, shift, axis=(0, 1, 2))
    return larger


class Ranks(Program):
    def setUp(self):
        super().setUp()
        self.case.write_text(CASE)

    def vesica_on(self, count, *arguments):
        """Status, stdout, stderr of the program on so many ranks; mpirun's own words removed."""
        done = subprocess.run([*ranks.mpirun(count), PROGRAM, *map(str, arguments)], cwd=self.directory, check=False,
                              capture_output=True, text=True, timeout=300, env=ranks.environment())
        errors = re.sub(r"(?ms)^-{60,}$.*?^-{60,}$\n?", "", done.stderr)
        return done.returncode, done.stdout, errors

    def run_on(self, count, target, *arguments):
        status, out, errors = self.vesica_on(count, "run", self.case, "-o", target, "--threads", 1, *arguments)
        self.assertEqual(status, 0, errors)
        return out

    def resume_on(self, count, target, *arguments):
        status, out, errors = self.vesica_on(count, "resume", target, "--threads", 1, *arguments)
        self.assertEqual(status, 0, errors)
        return out

    def outputs(self, target, whole=False):
        """Digests of all files that must not depend on how the run was shared out; of checkpoints `whole` or their arrays."""
        root = self.directory / target
        files = [path for path in sorted(root.rglob("*")) if path.is_file() and not path.name.startswith(".")
                 and path.name not in ("summary.json", "log.txt", "resolved.toml")]  # times, and the steps asked for
        self.assertGreater(len(files), 8)
        return {str(path.relative_to(root)): digest(path, whole) for path in files}

    def summary(self, target):
        return json.loads((self.directory / target / "summary.json").read_text())


class SameBits(Ranks):
    def test_every_file_is_the_same_on_one_rank_and_on_several(self):
        self.run_on(0, "alone")
        expected = self.outputs("alone", whole=True)
        self.run_on(1, "one")
        self.assertEqual(self.outputs("one", whole=True), expected)
        for count, arguments in ((2, ["--blocks", "2,1,1"]), (3, ["--blocks", "1,1,3"]), (4, ["--balance", "cells"]), (8, [])):
            with self.subTest(ranks=count):
                out = self.run_on(count, f"on{count}", *arguments)
                self.assertEqual(self.outputs(f"on{count}", whole=True), expected)
                self.assertIn(f"{count} ranks in", out)
                self.assertEqual(out.count("done: "), 1)  # one voice
                summary, alone = self.summary(f"on{count}"), self.summary("alone")
                self.assertEqual(summary["machine"]["ranks"], count)
                # Of all ranks together: their ghosts come on top.
                self.assertGreater(summary["lattice"]["bytes_allocated"], alone["lattice"]["bytes_allocated"])
                self.assertAlmostEqual(summary["dimensionless"]["interface_fraction"],
                                       alone["dimensionless"]["interface_fraction"], places=12)

    def test_mpirun_counts_rather_than_the_resource_manager_around_it(self):
        with unittest.mock.patch.dict(os.environ, {"SLURM_STEP_NUM_TASKS": "1", "SLURM_PROCID": "0"}):
            self.run_on(2, "on2", "--steps", 2)
        self.assertEqual(self.summary("on2")["machine"]["ranks"], 2)

    def test_single_precision_too(self):
        single = ["--set", 'numerics.precision="single"']
        self.run_on(0, "alone", *single)
        self.run_on(4, "on4", "--blocks", "2,2,1", *single)
        self.assertEqual(self.outputs("on4", whole=True), self.outputs("alone", whole=True))

    def test_a_run_is_resumed_on_other_numbers_of_ranks(self):
        self.run_on(0, "whole")
        expected = self.outputs("whole")
        for counts in ((1, 4, 2), (3, 1, 8)):
            with self.subTest(ranks=counts):
                target = "-".join(map(str, counts))
                self.run_on(counts[0], target, "--steps", 17)
                self.resume_on(counts[1], target, "--steps", 41)
                cut = ["--blocks", "2,2,2"] if counts[2] == 8 else []
                self.resume_on(counts[2], target, "--steps", STEPS, *cut)
                self.assertEqual(self.outputs(target), expected)

    def test_a_case_starts_from_an_earlier_state_on_any_ranks(self):
        self.run_on(2, "rest", "--steps", 20)
        self.case.write_text(CASE + '[initial]\ncheckpoint = "rest"\n')
        self.run_on(1, "one")
        self.run_on(4, "four")
        one, four = self.outputs("one"), self.outputs("four")
        self.assertEqual(four, one)


class Report(Ranks):
    def test_what_travels_is_what_must(self):
        """By hand: of nineteen populations five cross each face; of the interface's quantities fourteen are told in
        every step, in the cells of the band that lie along a face; and nothing else travels."""
        steps, x, y = 4, 24, 40
        for precision, width in (("double", 8), ("single", 4)):
            target = f"on-{precision}"
            self.run_on(2, target, "--steps", steps, "--set", f'numerics.precision="{precision}"', "--blocks", "1,1,2",
                        "--balance", "cells")
            for last in (steps, 3 * steps):  # the second time resumed: what loading takes is no part of the steps
                if last > steps:
                    self.resume_on(2, target, "--steps", last, "--blocks", "1,1,2", "--balance", "cells")
                parallel = self.summary(target)["parallel"]
                # Two ranks, two faces each, both towards the other rank: one message each way a step.
                self.assertEqual(parallel["population_bytes_per_step"], 2 * 2 * 5 * x * y * width)
                self.assertEqual(parallel["population_messages_per_step"], 2)
                with h5py.File(self.directory / target / f"checkpoints/step_{last:09}.h5") as checkpoint:
                    band = (checkpoint["band"][...].reshape(40, y, x) & 1) == 1
                for _ in range(8):
                    band = grown(band)
                # Both sides of both faces; along x and y each plane has ghosts of its own, which stand for its ends.
                cells = sum(int(np.pad(band[plane], 1, mode="wrap").sum()) for plane in (0, 19, 20, 39))
                self.assertEqual(parallel["band_bytes_per_step"], 14 * cells * width)

    def test_how_the_work_was_shared_out_is_told(self):
        self.run_on(4, "balanced")
        parallel = self.summary("balanced")["parallel"]
        self.assertEqual(sum(rank["size"][0] * rank["size"][1] * rank["size"][2] for rank in parallel["ranks"]),
                         24 * 40 * 40)
        self.assertGreater(parallel["imbalance"], 1.0)
        self.assertGreater(parallel["band_bytes_per_step"], 0)
        self.run_on(4, "short", "--steps", 1)
        for target in ("balanced", "short"):  # what building takes is no part of the steps
            parallel = self.summary(target)["parallel"]
            self.assertLess(parallel["waiting_share"], 1.0)
            self.assertGreater(parallel["waiting_share"], 0.0)
            for rank in parallel["ranks"]:
                self.assertGreater(rank["working_seconds"], 0)

    def test_blocks_are_cut_by_the_work_in_them(self):
        sizes = {}
        for balance in ("cells", "interface"):
            self.run_on(3, balance, "--balance", balance, "--blocks", "1,3,1", "--set", "lattice.size=[24, 90, 24]",
                        "--set", "vesicle[0].centre=[12, 45, 12]", "--steps", 2)
            sizes[balance] = [rank["size"][1] for rank in self.summary(balance)["parallel"]["ranks"]]
        self.assertEqual(sizes["cells"], [30, 30, 30])
        self.assertLess(sizes["interface"][1], 25)  # the one in the middle holds the vesicle
        self.assertLess(abs(sizes["interface"][0] - sizes["interface"][2]), 6)
        # On resume they are cut by where the interface is then.
        self.resume_on(2, "cells", "--steps", 4, "--blocks", "1,2,1", "--balance", "interface")
        halves = [rank["size"][1] for rank in self.summary("cells")["parallel"]["ranks"]]
        self.assertLess(abs(halves[0] - 45), 6)
        # And where a case starts from an earlier state, by that state rather than by what the case describes.
        self.case.write_text(CASE.replace("size = [24, 40, 40]", "size = [24, 90, 24]")
                             .replace("centre = [3, 12, 38]", "centre = [12, 68, 12]") + '[initial]\ncheckpoint = "cells"\n')
        self.run_on(3, "moved", "--blocks", "1,3,1", "--steps", 2)
        thirds = [rank["size"][1] for rank in self.summary("moved")["parallel"]["ranks"]]
        self.assertLess(thirds[1], 25)
        self.assertLess(abs(thirds[0] - thirds[2]), 6)


class Refused(Ranks):
    def refused_on(self, count, *arguments, saying):
        status, _, errors = self.vesica_on(count, *arguments)
        self.assertEqual(status, 2, errors)
        for part in saying:
            self.assertIn(part, errors)
        self.assertEqual(errors.count(saying[0]), 1)  # one voice
        self.assertFalse((self.directory / "target").exists())

    def test_blocks_that_do_not_fit(self):
        run = ("run", self.case, "-o", "target")
        self.refused_on(2, *run, "--blocks", "1,1,3", saying=["--blocks is 1,1,3, 3 blocks in all", "mpirun -n 3"])
        self.refused_on(3, *run, "--blocks", "3,1,1", saying=["--blocks is 3,1,1; expected blocks of at least 10"])
        self.refused_on(7, *run, saying=["lattice.size is 24 x 40 x 40; expected a box that 7 ranks can share",
                                         "mpirun -n 6"])
        self.refused_on(2, *run, "--blocks", "two", saying=["--blocks is two; expected three whole numbers"])
        self.refused_on(1, *run, "--blocks", "1,1,2", saying=["--blocks is 1,1,2, 2 blocks in all"])
        self.refused_on(1, *run, "--balance", "work", saying=["--balance is work; expected cells or interface"])

    def test_an_error_in_the_case_is_told_once(self):
        self.case.write_text(CASE.replace("kinematic_viscosity", "viscosity"))
        self.refused_on(3, "run", self.case, "-o", "target", saying=["small.toml:5:1:", "viscosity"])

    def test_ranks_that_do_not_find_each_other_do_not_each_run_the_case(self):
        errors = self.refused("run", self.case, "-o", "target", environment={"SLURM_STEP_NUM_TASKS": "4"} | ranks.NO_LEAKS,
                              saying="one of 4 processes that a launcher has started")
        self.assertIn("srun --mpi=pmix", errors)
        self.assertFalse((self.directory / "target").exists())

    def test_other_commands_speak_with_one_voice(self):
        status, out, errors = self.vesica_on(2, "--version")
        self.assertEqual((status, errors), (0, ""))
        self.assertEqual(len(out.splitlines()), 1)


class Faults(Ranks):
    def start(self, count, *arguments):
        return subprocess.Popen([*ranks.mpirun(count), PROGRAM, *map(str, arguments), "--threads", "1"],
                                cwd=self.directory, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                env=ranks.environment(), start_new_session=True)

    def processes(self, launcher):
        """The ranks mpirun has started, by their numbers."""
        found = []
        for entry in Path("/proc").iterdir():
            if not entry.name.isdigit():
                continue
            try:
                words = (entry / "cmdline").read_bytes().split(b"\0")
                parent = int((entry / "stat").read_text().rsplit(")", 1)[1].split()[1])
            except (OSError, IndexError, ValueError):
                continue
            if words[0] == PROGRAM.encode() and parent == launcher.pid:
                found.append(int(entry.name))
        return sorted(found)

    def wait_for(self, condition, running):
        deadline = time.monotonic() + 60
        while not condition() and running.poll() is None:
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.002)

    def checkpoints(self):
        return sorted((self.directory / "target/checkpoints").glob("step_*.h5"))

    def test_killed_ranks_at_random_moments_leave_no_trace(self):
        """One rank, any of them, or all, ten times each: what is resumed ends as if nothing had been."""
        steps = 400
        self.run_on(0, "whole", "--steps", steps)
        expected = self.outputs("whole")
        moments = random.Random(5)
        kills = 0
        command = ["run", self.case, "-o", "target"]
        while kills < 20:
            running = self.start(2 + kills % 2, *command, "--steps", steps)
            before = self.checkpoints()
            self.wait_for(lambda before=before: self.checkpoints() not in ([], before), running)  # it is at work
            time.sleep(moments.uniform(0.0, 0.3))
            victims = self.processes(running)
            for victim in victims if kills // 2 % 2 else victims and [moments.choice(victims)]:
                try:
                    os.kill(victim, signal.SIGKILL)
                except ProcessLookupError:
                    pass
            _, errors = running.communicate(timeout=60)
            if running.returncode == 0:  # done before the kill: once more from the beginning
                self.assertEqual(self.outputs("target"), expected)
                shutil.rmtree(self.directory / "target")
                command = ["run", self.case, "-o", "target"]
                continue
            kills += 1
            command = ["resume", "target"]
        self.resume_on(2, "target", "--steps", steps)
        self.assertEqual(self.outputs("target"), expected)

    def test_a_rank_that_cannot_write_costs_neither_the_run_nor_its_last_checkpoint(self):
        self.run_on(0, "whole", "--steps", 400)
        running = self.start(2, "run", self.case, "-o", "target", "--steps", 400)
        self.wait_for(self.checkpoints, running)
        size = self.checkpoints()[0].stat().st_size
        follower = self.processes(running)[-1]
        resource.prlimit(follower, resource.RLIMIT_FSIZE, (size // 2, size // 2))
        _, errors = running.communicate(timeout=60)
        self.assertEqual(running.returncode, 1, errors)
        self.assertRegex(errors, r"step_\d+\.h5: cannot write: File too large \(rank 1\)")
        for checkpoint in self.checkpoints():
            self.assertIn("checkpoint, intact", self.vesica("info", checkpoint)[1])
        self.assertEqual(len(list((self.directory / "target/checkpoints").iterdir())), len(self.checkpoints()))
        self.resume_on(2, "target")
        self.assertEqual(self.outputs("target"), self.outputs("whole"))

    @unittest.skipUnless(os.geteuid() == 0, "only root may hide a directory from a process")
    def test_a_rank_that_does_not_see_the_directory_is_named(self):
        (self.directory / "hidden").mkdir()
        blind = f'mount -t tmpfs none {self.directory}/hidden && exec "$0" "$@"'
        if subprocess.run(["unshare", "-m", "sh", "-c", blind, "true"], check=False, stderr=subprocess.DEVNULL).returncode:
            self.skipTest("no private mounts here")
        run = [PROGRAM, "run", str(self.case), "-o", "hidden/target", "--threads", "1"]
        done = subprocess.run(["mpirun", "-n", "1", *run, ":", "-n", "1", "unshare", "-m", "sh", "-c", blind, *run], check=False,
                              cwd=self.directory, capture_output=True, text=True, timeout=60, env=ranks.environment())
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertRegex(done.stderr, r"hidden/target/checkpoints/step_\d+\.h5: cannot write: No such file or directory \(rank 1\)")

    def test_ranks_may_have_been_told_different_numbers_of_threads(self):
        run = [PROGRAM, "run", str(self.case), "-o", "target", "--steps", "2"]
        environment = {name: value for name, value in ranks.environment().items() if name != "OMP_NUM_THREADS"}
        done = subprocess.run(["mpirun", "-n", "1", "env", "OMP_NUM_THREADS=2", *run, ":", "-n", "1", *run], check=False,
                              cwd=self.directory, capture_output=True, text=True, timeout=60, env=environment)
        self.assertEqual(done.returncode, 0, done.stderr)

    @unittest.skipIf(os.environ.get("VESICA_SANITIZE"), "instrumented programs reserve more than any limit leaves")
    def test_too_little_memory_on_one_rank_ends_all(self):
        run = ["run", str(self.case), "-o", "target", "--threads", "1", "--set", "lattice.size=[192, 192, 192]"]
        poor = 'ulimit -v 900000 && exec "$0" "$@"'
        for first, second in (([], ["sh", "-c", poor]), (["sh", "-c", poor], [])):
            done = subprocess.run(["mpirun", "-n", "1", *first, PROGRAM, *run, "--overwrite", ":", "-n", "1", *second, PROGRAM,
                                   *run, "--overwrite"], check=False, cwd=self.directory, capture_output=True, text=True,
                                  timeout=60, env=ranks.environment())
            self.assertEqual(done.returncode, 1, done.stderr)
            self.assertIn("not enough memory", done.stderr)

    def test_a_signal_to_mpirun_stops_the_run_with_a_checkpoint(self):
        self.run_on(0, "whole")
        running = self.start(2, "run", self.case, "-o", "target", "--steps", 100000)
        self.wait_for(self.checkpoints, running)
        running.send_signal(signal.SIGUSR1)
        out, errors = running.communicate(timeout=60)
        self.assertEqual(running.returncode, 3, errors)
        self.assertIn("SIGUSR1 received", out + errors)
        summary = self.summary("target")
        self.assertEqual(summary["end"], "stopped")
        self.assertEqual(self.checkpoints()[-1].name, f"step_{summary['last_step']:09}.h5")
        rows = [int(row.split(",")[0])
                for row in (self.directory / "target/metrics.csv").read_text().splitlines()[1:]]
        self.assertEqual(rows, list(range(0, summary["last_step"] + 1, 10)))

    def test_a_directory_that_vanishes_ends_all_ranks_with_a_word(self):
        running = self.start(2, "run", self.case, "-o", "target", "--steps", 100000)
        self.wait_for(self.checkpoints, running)
        os.rename(self.directory / "target", self.directory / "elsewhere")
        _, errors = running.communicate(timeout=60)
        self.assertEqual(running.returncode, 1, errors)
        self.assertRegex(errors, r"vesica: .*target")

    def test_a_damaged_checkpoint_is_named_and_the_older_one_serves(self):
        self.run_on(0, "whole")
        self.run_on(2, "target", "--steps", 30)
        newest = self.checkpoints()[-1]
        content = bytearray(newest.read_bytes())
        content[len(content) // 2] ^= 4
        newest.write_bytes(content)
        self.resume_on(2, "target", "--steps", STEPS)
        self.assertIn(newest.name, (self.directory / "target/log.txt").read_text())
        self.assertEqual(self.outputs("target"), self.outputs("whole"))
