"""`vesica report`: a page of what a run left, whatever that is, and words where there is nothing to show."""

import json
import os
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
PROGRAM = Path(os.environ.get("VESICA_PROGRAM", SOURCE / "build/release/bin/vesica"))
PAGE = PROGRAM.parent.parent / "share/vesica/report.html"

CASE = """title = "small"
[units]
cell = "0.2 um"
time_step = "1 us"
[lattice]
size = [32, 32, 32]
[fluid]
kinematic_viscosity = 0.1666667
density = "1000 kg/m^3"
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
"""


def manifest_of(page):
    """What the page knows, without its surfaces."""
    found = re.search(r'<script type="application/json" id="vesica-manifest">(.*?)</script>', page.read_text(), re.DOTALL)
    return json.loads(found[1])


class Program(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="vesica-report-")
        self.addCleanup(scratch.cleanup)
        self.directory = Path(scratch.name)

    def vesica(self, *arguments, program=PROGRAM):
        done = subprocess.run([program, *map(str, arguments)], cwd=self.directory, capture_output=True, text=True,
                              timeout=300, check=False)
        return done.returncode, done.stdout, done.stderr

    def refused(self, *arguments, saying, status=2):
        returned, _, errors = self.vesica(*arguments)
        self.assertEqual(returned, status, errors)
        self.assertIn(saying, errors)


@unittest.skipUnless(PAGE.is_file(), "this build has no page of the report")
class Report(Program):
    def run_case(self, *options):
        (self.directory / "small.toml").write_text(CASE)
        status, _, errors = self.vesica("run", "small.toml", "-o", "run", "--threads", "1", *options)
        self.assertEqual(status, 0, errors)

    def test_a_run_has_a_page_with_everything_in_it(self):
        self.run_case()
        status, out, errors = self.vesica("report", "run")
        self.assertEqual((status, errors), (0, ""))
        self.assertRegex(out, r"^run/report\.html: 3 of 3 frames, \d+ triangles, \d\.\d MB")
        page = self.directory / "run/report.html"
        manifest = manifest_of(page)
        self.assertEqual((manifest["title"], manifest["state"], manifest["live"]), ("small", "finished", False))
        self.assertEqual([frame["step"] for frame in manifest["frames"]], [0, 20, 40])
        self.assertAlmostEqual(manifest["frames"][2]["time"], 40e-6)
        self.assertEqual(manifest["box"], {"size": [32, 32, 32], "ends": ["periodic"] * 3})
        self.assertAlmostEqual(manifest["scales"]["cell_m"], 2e-7)
        self.assertEqual(manifest["metrics"]["rows"], 5)
        self.assertEqual(manifest["case"], CASE)
        self.assertEqual(manifest["summary"], json.loads((self.directory / "run/summary.json").read_text()))
        self.assertIn("reduced volume", manifest["plan"])
        self.assertNotIn(str(self.directory), page.read_text())
        # Nothing is fetched from anywhere.
        self.assertEqual(re.findall(r'(?:src|href)="(?!#|data:)[^"]*"', page.read_text()), [])

        # A second page replaces the first; the options reach it.
        status, out, _ = self.vesica("report", "run", "-o", "other.html", "--frames", "1", "--triangles", "500")
        self.assertEqual(status, 0)
        manifest = manifest_of(self.directory / "other.html")
        self.assertEqual([frame["step"] for frame in manifest["frames"]], [40])
        self.assertLessEqual(manifest["frames"][0]["triangles"], 500)

        # Without its summary and with a torn table it is a run that was interrupted, and still has a page.
        (self.directory / "run/summary.json").unlink()
        table = self.directory / "run/metrics.csv"
        table.write_bytes(table.read_bytes()[:-30])
        self.assertEqual(self.vesica("report", "run")[0], 0)
        manifest = manifest_of(page)
        self.assertEqual((manifest["state"], manifest["summary"], manifest["metrics"]["rows"]), ("interrupted", None, 4))

        self.refused("report", "run", "-o", "", saying="-o is empty; expected a file")
        self.refused("report", "run", "-o", "none/report.html", saying="none/", status=1)
        self.refused("report", "run", "--max-size", "0.2", saying="--max-size")
        self.refused("report", "run", "--max-size", "many", saying="--max-size is many; expected megabytes")
        self.refused("report", "run", "--frames", "0", saying="--frames is 0; expected a whole number from 1")
        self.refused("report", "run", "--triangles", "7", saying="--triangles is 7; expected a whole number from 100")

    def test_what_is_no_run_is_refused(self):
        self.refused("report", saying="directory is required")
        self.refused("report", "none", saying="none: is not a directory")
        self.refused("report", ".", saying="holds no run; expected case.toml")
        self.assertEqual(list(self.directory.iterdir()), [])


class WithoutThePage(Program):
    def test_a_program_without_its_page_says_what_to_install(self):
        (self.directory / "bin").mkdir()
        program = shutil.copy(PROGRAM, self.directory / "bin/vesica")
        status, _, errors = self.vesica("report", ".", program=program)
        self.assertEqual(status, 1)
        self.assertIn("share/vesica/report.html: the report's page is missing", errors)
        self.assertIn("install nodejs and npm", errors)


if __name__ == "__main__":
    unittest.main()
