"""The model of many ranks: its tables are those of the page, and it holds what must hold of any such model."""

import subprocess
import sys
import unittest
from importlib.machinery import SourceFileLoader
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
SCRIPT = SOURCE / "benchmarks/scaling-model"
model = SourceFileLoader("scaling_model", str(SCRIPT)).load_module()


class ScalingModel(unittest.TestCase):
    def test_the_page_has_its_tables(self):
        page = (SOURCE / "docs/scaling.md").read_text()
        for row in subprocess.run([sys.executable, SCRIPT, "--markdown"], capture_output=True, text=True, check=True).stdout.splitlines():
            self.assertIn(row, page)

    def test_one_rank_waits_for_nobody_and_more_ranks_never_gain_more_than_their_number(self):
        for network in model.NETWORKS.values():
            self.assertEqual(model.step_seconds(64**3, 0.1, 1, network)[1:], (0.0, 0.0))
            for _, ranks, _, efficiency, travel, wait, _ in model.strong(network):
                self.assertLess(efficiency, 1.0, ranks)
                self.assertGreater(efficiency, 0.0)
                self.assertAlmostEqual(efficiency + travel + wait, 1.0, places=6)

    def test_a_block_sends_what_is_counted(self):
        """A cube of ten cells cut off on all sides: the 2,880 numbers of the halo's own test."""
        work, travel, _ = model.step_seconds(1000 * 10**6, 0.0, 10**6, (0.0, 1e9))
        self.assertGreater(work, 0.0)
        bytes_per_second = 1 / (model.CORES ** (-1 / 3) * model.CORES / 1e9
                                + (1 - model.CORES ** (-1 / 3)) * 2 * model.CORES / model.NODE_BANDWIDTH)
        self.assertAlmostEqual(travel * bytes_per_second, 8 * (6 * (100 + 4 * 90) + 120), places=3)


if __name__ == "__main__":
    unittest.main()
