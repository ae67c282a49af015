"""The examples of docs/output.md do what the page says."""

import os
import re
import subprocess
import sys
import unittest
from pathlib import Path

from tests.cli.program_test import PROGRAM, Program

ROOT = Path(__file__).resolve().parents[2]


class OutputPage(Program):
    def test_its_examples_work(self):
        (self.directory / "cases").symlink_to(ROOT / "cases")
        environment = {**os.environ, "PATH": f"{Path(PROGRAM).resolve().parent}:{os.environ['PATH']}"}
        blocks = re.findall(r"```(sh|python)\n(.*?)```", (ROOT / "docs/output.md").read_text(), re.DOTALL)
        self.assertEqual([kind for kind, _ in blocks], ["sh", "python", "python", "python"])
        said = []
        for kind, text in blocks:
            command = ["bash", "-ec", text] if kind == "sh" else [sys.executable, "-c", text]
            done = subprocess.run(command, cwd=self.directory, env=environment, capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, text + done.stderr)
            self.assertNotIn("ERR", done.stderr)
            said.append(done.stdout)
        self.assertIn("step_000000010 ", said[1])
        self.assertIn("(40, 56, 56, 3) m/s", said[1])
        self.assertRegex(said[2], r"\(-1\.0, (1\.0|0\.99\d+)\)")
        self.assertGreater(int(said[3].split()[0]), 1000)


if __name__ == "__main__":
    unittest.main()
