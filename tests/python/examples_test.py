"""Every example runs, is short, and says what it is for."""

import contextlib
import io
import os
import runpy
import sys
import tempfile
import unittest
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
EXAMPLES = sorted((SOURCE / "python/examples").glob("*.py"))


class Examples(unittest.TestCase):
    def test_there_are_twelve_of_at_most_forty_lines_and_the_page_lists_them(self):
        self.assertGreaterEqual(len(EXAMPLES), 12)
        page = (SOURCE / "docs/python.md").read_text(encoding="utf-8")
        for example in EXAMPLES:
            lines = example.read_text(encoding="utf-8").splitlines()
            self.assertLessEqual(len(lines), 40, example.name)
            self.assertTrue(lines[0].startswith('"""'), example.name)
            self.assertIn(f"{example.name}]", page)

    def test_each_of_them_runs(self):
        here = os.getcwd()
        with tempfile.TemporaryDirectory(prefix="vesica-examples-") as folder:
            os.symlink(SOURCE / "cases", Path(folder) / "cases")
            (Path(folder) / "out").mkdir()
            os.chdir(folder)
            try:
                for example in EXAMPLES:
                    with self.subTest(example.name):
                        said = io.StringIO()
                        with contextlib.redirect_stdout(said), contextlib.redirect_stderr(io.StringIO()):
                            runpy.run_path(str(example), run_name="__main__")
                        if example.name != "render_a_surface.py":
                            self.assertTrue(said.getvalue().strip(), f"{example.name} says nothing")
                        self.assertNotRegex(said.getvalue(), r"\bnan\b.*steps")
                made = {path.name for path in (Path(folder) / "out").glob("*.png")}
                self.assertLessEqual({"profile.png", "energy.png", "curvature.png", "bending.png", "angle.png", "streaklines.png"},
                                     made)
            finally:
                os.chdir(here)


if __name__ == "__main__":
    sys.exit(unittest.main())
