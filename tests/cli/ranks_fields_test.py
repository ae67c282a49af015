"""Fields on several ranks: each writes its part, and nobody can tell."""

import json
import os
import re
import subprocess
import unittest

import h5py

from tests.cli import ranks
from tests.cli.program_test import PROGRAM
from tests.cli.ranks_test import STEPS, Ranks

# A region that some ranks have nothing of, every third cell, none of it compressed.
SAMPLED = ["--set", "output.fields.compression=0", "--set", "output.fields.region=[[1, 0, 3], [24, 17, 40]]",
           "--set", "output.fields.stride=3", "--set", 'output.fields.names=["velocity", "mean_curvature", "phase"]']


class SameFields(Ranks):
    def test_sampled_and_uncompressed_and_resumed_in_the_middle_of_an_average(self):
        self.run_on(0, "whole", *SAMPLED)
        expected = self.outputs("whole")
        # Of the average that was under way the checkpoint has the samples alone.
        with h5py.File(self.directory / f"whole/checkpoints/step_{STEPS - 10:09}.h5") as checkpoint:
            self.assertEqual({name: array.shape for name, array in checkpoint["sums"].items()},
                             {"velocity": (8 * 6 * 13 * 3,), "mean_curvature": (8 * 6 * 13,), "phase": (8 * 6 * 13,)})
        for counts in ((3, 1), (1, 4)):
            with self.subTest(ranks=counts):
                target = "-".join(map(str, counts))
                self.run_on(counts[0], target, "--steps", 40, *SAMPLED)
                self.resume_on(counts[1], target, "--steps", STEPS)
                self.assertEqual(self.outputs(target), expected)

    def test_compressed_chunks_are_shared_out(self):
        case = ["--set", "lattice.size=[64, 80, 30]", "--set", "vesicle[0].centre=[40, 12, 15]", "--steps", 2, "--set",
                "output.fields.every=2", "--set", "output.fields.average=false"]
        self.run_on(0, "alone", *case)
        with h5py.File(self.directory / "alone/fields/step_000000002.h5") as fields:
            self.assertGreater(fields["velocity"].id.get_num_chunks(), 4)
        for count, blocks in ((2, "2,1,1"), (3, "1,3,1")):
            self.run_on(count, f"on{count}", "--blocks", blocks, *case)
            self.assertEqual(self.outputs(f"on{count}", whole=True), self.outputs("alone", whole=True))

    def test_what_output_took_is_told(self):
        out = self.run_on(2, "told", "--steps", 30)
        line = next(line for line in out.splitlines() if line.startswith("output: "))
        self.assertRegex(line, r"^output: \d+ files, [\d.]+ [kM]B, [\d.]+ s = [\d.]+ % of the run \(checkpoints: .*fields: .*")
        output = self.summary("told")["output"]
        files = {"checkpoints": 3, "fields": 2, "metrics": 1, "surfaces": 2}
        self.assertEqual({kind: cost["files"] for kind, cost in output["kinds"].items()}, files)
        self.assertEqual(output["files"], sum(files.values()))
        self.assertEqual(int(re.search(r"(\d+) files", line).group(1)), output["files"])
        root = self.directory / "told"
        for kind, pattern in (("fields", "fields/*.h5"), ("surfaces", "surfaces/*.vtp"), ("metrics", "metrics.csv")):
            self.assertEqual(output["kinds"][kind]["bytes"], sum(path.stat().st_size for path in root.glob(pattern)), kind)
        self.assertAlmostEqual(output["seconds"], sum(cost["seconds"] for cost in output["kinds"].values()), places=6)
        self.assertGreater(output["share"], 0)
        self.assertLess(output["share"], 1)
        self.assertEqual(json.dumps(output["kinds"]).count("seconds"), 4)

    @unittest.skipUnless(os.geteuid() == 0, "only root may hide a directory from a process")
    def test_a_rank_that_cannot_write_its_part_leaves_no_half_file(self):
        (self.directory / "hidden").mkdir()
        blind = f'mount -t tmpfs none {self.directory}/hidden && exec "$0" "$@"'
        if subprocess.run(["unshare", "-m", "sh", "-c", blind, "true"], check=False, stderr=subprocess.DEVNULL).returncode:
            self.skipTest("no private mounts here")
        run = [PROGRAM, "run", str(self.case), "-o", "hidden/target", "--threads", "1", *SAMPLED]
        done = subprocess.run(["mpirun", "-n", "1", *run, ":", "-n", "1", "unshare", "-m", "sh", "-c", blind, *run], check=False,
                              cwd=self.directory, capture_output=True, text=True, timeout=60, env=ranks.environment())
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertRegex(done.stderr, r"fields/step_000000000\.h5: cannot write: No such file or directory \(rank 1\)")
        self.assertEqual(list((self.directory / "hidden/target/fields").iterdir()), [])


if __name__ == "__main__":
    unittest.main()
