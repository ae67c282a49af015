"""The quick subsets of the validations meet their targets."""

import os
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BUILD = os.environ.get("VESICA_BUILD_DIR", str(ROOT / "build" / "release"))
ITEMS = ("numerics", "drops", "rest_shapes", "spontaneous_curvature", "channel_flow", "dilute_emulsion")  # the others' take longer


class QuickSubset(unittest.TestCase):
    def test_every_target_of_the_quick_subsets_is_met(self):
        for item in ITEMS:
            with self.subTest(item), tempfile.TemporaryDirectory(prefix="vesica-validation-") as scratch:
                script = ROOT / "validation" / item / "validate.py"
                done = subprocess.run(["/usr/bin/python3", str(script), "--quick", "--build", BUILD, "--output", scratch, "--processes", "1"],
                                      capture_output=True, text=True, check=False, timeout=600)  # fmt: skip
                self.assertEqual(done.returncode, 0, done.stdout[-3000:] + done.stderr[-3000:])
                self.assertRegex(done.stdout, r"\n%s: ([1-9]\d*) of \1 targets met\n" % item)

    def test_a_missed_target_is_an_exit_status_of_one(self):
        # A law that no fluid obeys, judged by the real machinery.
        with tempfile.TemporaryDirectory(prefix="vesica-validation-") as scratch:
            script = Path(scratch) / "impossible" / "validate.py"
            script.parent.mkdir()
            script.write_text(
                "import sys\n"
                f"sys.path.insert(0, {str(ROOT / 'tools')!r})\n"
                "from validation.item import Item\n"
                "item = Item(__file__, 'Impossible')\n"
                "item.results.relative('two', 'is', 2.0, 1.0, 0.01)\n"
                "item.results.relative('nothing', 'is', float('nan'), 1.0, 0.01)\n"
                "item.results.relative('one', 'is', 1.0, 1.0, 0.01)\n"
                "item.finish()\n"
            )
            done = subprocess.run(["/usr/bin/python3", str(script), "--build", BUILD, "--output", scratch],
                                  capture_output=True, text=True, check=False)  # fmt: skip
            self.assertEqual(done.returncode, 1, done.stderr)
            self.assertIn("impossible: 1 of 3 targets met", done.stdout)
            self.assertIn('"verdict": "missed"', (script.parent / "results.json").read_text())


if __name__ == "__main__":
    unittest.main()
