"""What becomes of a run when processes die, disks fill up, directories vanish and files rot."""

import hashlib
import json
import os
import random
import re
import shutil
import signal
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

import h5py

from tests.cli.program_test import PROGRAM, SMALL, Program

STEPS = 600
# A deforming vesicle that leans over the box's faces: resuming it must find bands, colours and controllers again.
CASE = (
    SMALL.replace("size = [32, 32, 32]", "size = [24, 24, 24]")
    .replace('shape = "sphere"', 'shape = "spheroid"\naspect = 0.8')
    .replace("centre = [16, 16, 16]\nradius = 8", "centre = [3, 12, 21]\nradius = 6")
    .replace("steps = 40", f"steps = {STEPS}")
    .replace("surfaces = { every = 20 }", f"surfaces = {{ every = {STEPS} }}")
    .replace("checkpoint = { every = 20 }", "checkpoint = { every = 10, keep = 2 }")
)


def state_of(directory):
    """Digests of all arrays of the last checkpoint; the text of the case may differ in its comments."""
    with h5py.File(directory / f"checkpoints/step_{STEPS:09}.h5") as checkpoint:
        arrays = {}
        checkpoint.visititems(lambda name, item: arrays.__setitem__(name, item)
                              if isinstance(item, h5py.Dataset) and name != "case" else None)
        assert {"band", "controllers", "minority", "populations", "notes/colour_mass"} <= set(arrays)
        return {name: (array.dtype.str, array.shape, hashlib.sha256(array[...].tobytes()).hexdigest()) for name, array in arrays.items()}


class Faults(Program):
    def setUp(self):
        super().setUp()
        self.case.write_text(CASE)
        self.target = self.directory / "target"

    def start(self, *arguments):
        return subprocess.Popen([PROGRAM, *map(str, arguments), "--threads", "1"], cwd=self.directory,
                                stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)

    def wait_for(self, condition, running=None):
        """Until it holds, or the process has ended by itself."""
        deadline = time.monotonic() + 60
        while not condition() and (running is None or running.poll() is None):
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.001)

    def checkpoints(self, target=None):
        return sorted((target or self.target).glob("checkpoints/step_*.h5"))

    def assert_as_if_undisturbed(self, target=None):
        """The same numbers, surface and last state as a run that nobody disturbed."""
        target = target or self.target
        whole = self.directory / "whole"
        if not whole.exists():
            self.assertEqual(self.vesica("run", self.case, "-o", whole, "--threads", 2)[0], 0)
        self.assertEqual((target / "metrics.csv").read_text(), (whole / "metrics.csv").read_text())
        surface = f"surfaces/surface_{STEPS:09}.vtp"
        self.assertTrue((target / surface).read_bytes() == (whole / surface).read_bytes())
        self.assertEqual(state_of(target), state_of(whole))
        self.assertEqual(json.loads((target / "summary.json").read_text())["end"], "finished")


class Killed(Faults):
    def test_twenty_kills_at_random_moments_leave_no_trace(self):
        moments = random.Random(20)
        running = self.start("run", self.case, "-o", self.target)
        kills = 0
        while kills < 20:
            self.wait_for(self.checkpoints, running)
            time.sleep(moments.uniform(0.0, 0.06))
            if running.poll() is not None:  # done before the last kill: once more from the beginning
                self.assertEqual(running.returncode, 0, running.communicate()[1])
                running.stderr.close()
                self.assert_as_if_undisturbed()
                shutil.rmtree(self.target)
                running = self.start("run", self.case, "-o", self.target)
                continue
            running.kill()
            running.communicate()
            kills += 1
            running = self.start("resume", self.target)
        _, errors = running.communicate(timeout=120)
        self.assertEqual(running.returncode, 0, errors)
        self.assert_as_if_undisturbed()

    def test_a_signal_while_a_checkpoint_is_written_lets_it_be_whole(self):
        running = self.start("run", self.case, "-o", self.target)
        self.wait_for(lambda: self.checkpoints() and len(list((self.target / "checkpoints").iterdir()))
                      > len(self.checkpoints()), running)  # a file of another name is being written
        running.send_signal(signal.SIGTERM)
        _, errors = running.communicate(timeout=60)
        self.assertEqual(running.returncode, 3, errors)
        stopped = int(re.search(r"after step (\d+)", errors)[1])
        self.assertEqual(self.checkpoints()[-1].name, f"step_{stopped:09}.h5")
        self.assertEqual(len(list((self.target / "checkpoints").iterdir())), len(self.checkpoints()))
        self.assertEqual(json.loads((self.target / "summary.json").read_text())["last_step"], stopped)
        rows = [int(row.split(",")[0]) for row in (self.target / "metrics.csv").read_text().splitlines()[1:]]
        self.assertEqual(rows, list(range(0, stopped + 1, 10)))
        self.assertEqual(self.vesica("resume", self.target)[0], 0)
        self.assert_as_if_undisturbed()

    def test_a_second_interrupt_ends_it_at_once(self):
        running = self.start("run", self.case, "-o", self.target, "--set", "lattice.size=[96, 96, 96]", "--set",
                             "vesicle[0].radius=30")
        self.wait_for((self.target / "case.toml").is_file, running)  # the initial state is being built
        for _ in range(2):
            running.send_signal(signal.SIGINT)
            time.sleep(0.1)
        _, errors = running.communicate(timeout=10)
        self.assertEqual(running.returncode, -signal.SIGINT, errors)


class Rotten(Faults):
    def test_no_cut_and_no_flipped_bit_is_accepted_and_none_crashes_the_program(self):
        status, _, errors = self.vesica("run", self.case, "-o", self.target, "--steps", 10, "--set",
                                        "lattice.size=[16, 16, 16]", "--set", "vesicle[0].centre=[8, 8, 8]", "--set",
                                        "vesicle[0].radius=5")
        self.assertEqual(status, 0, errors)
        good = self.checkpoints()[-1]
        content = good.read_bytes()
        self.assertIn("checkpoint, intact", self.vesica("info", good)[1])
        bad = self.directory / "bad.h5"

        def check_refused(changed, what):
            bad.write_bytes(changed)
            status, out, errors = self.vesica("info", bad)
            self.assertIn(status, (1, 2), what)  # a crash has another
            self.assertRegex(out + errors, r"bad\.h5: (checkpoint, NOT INTACT|is not an HDF5 file)", what)

        for cut in range(0, len(content), 4096):
            check_refused(content[:cut], f"cut at {cut}")
        flips = random.Random(200)
        for _ in range(200):
            bit = flips.randrange(8 * len(content))
            changed = bytearray(content)
            changed[bit // 8] ^= 1 << bit % 8
            check_refused(changed, f"bit {bit}")

    def test_the_next_older_one_serves_and_the_damaged_one_is_named(self):
        self.assertEqual(self.vesica("run", self.case, "-o", self.target, "--steps", 50)[0], 0)
        older, newer = self.checkpoints()
        newer.write_bytes(newer.read_bytes()[:-1])
        self.assertEqual(self.vesica("resume", self.target, "--steps", STEPS)[0], 0)
        self.assertIn(newer.name, (self.target / "log.txt").read_text())
        self.assert_as_if_undisturbed()
        for damaged in self.checkpoints():
            damaged.write_bytes(b"nothing")
        self.refused("resume", self.target, "--steps", 2 * STEPS, status=1, saying=[older.parent.name, "intact"])

    def test_a_second_run_into_the_directory_is_refused(self):
        running = self.start("run", self.case, "-o", self.target, "--steps", 1000000)
        self.wait_for(self.checkpoints, running)
        for command in (["run", self.case, "-o", self.target, "--overwrite"], ["resume", self.target]):
            self.refused(*command, status=1, saying=str(self.target))
        running.send_signal(signal.SIGTERM)
        _, errors = running.communicate(timeout=60)
        self.assertEqual(running.returncode, 3, errors)

    def test_a_vanished_directory_ends_the_run_with_a_word(self):
        running = self.start("run", self.case, "-o", self.target, "--steps", 1000000)
        self.wait_for(self.checkpoints, running)
        os.rename(self.target, self.directory / "elsewhere")
        _, errors = running.communicate(timeout=60)
        self.assertEqual(running.returncode, 1, errors)
        self.assertIn("target", errors)
        self.assertNotIn("terminate called", errors)


@unittest.skipUnless(hasattr(os, "geteuid") and os.geteuid() == 0, "only root may mount a small disk")
class Disk(Faults):
    def setUp(self):
        super().setUp()
        disk = tempfile.TemporaryDirectory(prefix="vesica-disk-")
        self.addCleanup(disk.cleanup)
        self.disk = Path(disk.name)
        if not self.mount("size=8m"):
            self.skipTest("no small disk can be mounted here")
        self.addCleanup(subprocess.run, ["umount", "-l", self.disk], check=False)
        self.target = self.disk / "target"

    def mount(self, options):
        return subprocess.run(["mount", "-t", "tmpfs", "-o", options, "vesica-test", self.disk],
                              stderr=subprocess.DEVNULL, check=False).returncode == 0

    def test_a_full_disk_costs_neither_the_last_checkpoint_nor_the_run(self):
        running = self.start("run", self.case, "-o", self.target)
        self.wait_for(self.checkpoints, running)
        room = shutil.disk_usage(self.disk).free
        (self.disk / "others").write_bytes(bytes(room))
        _, errors = running.communicate(timeout=60)
        self.assertEqual(running.returncode, 1, errors)
        self.assertRegex(errors, "(?i)space")
        self.assertTrue(self.checkpoints())
        self.assertEqual(len(list((self.target / "checkpoints").iterdir())), len(self.checkpoints()))
        (self.disk / "others").unlink()
        status, _, errors = self.vesica("resume", self.target)
        self.assertEqual(status, 0, errors)
        self.assert_as_if_undisturbed()

    def test_a_disk_that_becomes_read_only_ends_the_run_with_a_word(self):
        running = self.start("run", self.case, "-o", self.target, "--steps", 1000000)
        self.wait_for(self.checkpoints, running)
        # A file open for writing, the log for one, keeps a file system writable; a second mount of it is not asked.
        subprocess.run(["mount", "--bind", self.disk, self.disk], check=True)
        self.addCleanup(subprocess.run, ["umount", "-l", self.disk], check=False)
        # It refuses while the run happens to write a file there.
        self.wait_for(lambda: subprocess.run(["mount", "-o", "remount,bind,ro", self.disk], check=False,
                                             stderr=subprocess.DEVNULL).returncode == 0, running)
        _, errors = running.communicate(timeout=60)
        self.assertEqual(running.returncode, 1, errors)
        self.assertIn("Read-only", errors)


if __name__ == "__main__":
    unittest.main()
