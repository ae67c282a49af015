"""A hundred frames of twenty thousand triangles: under 20 MB, and used within a second."""

import os
import subprocess
import tempfile
import unittest
from pathlib import Path

from browser import Browser
from synthetic_series import write_series

SOURCE = Path(__file__).resolve().parents[2]
PROGRAM = os.environ.get("VESICA_PROGRAM", str(SOURCE / "build/ci/bin/vesica"))
FRAMES = 100
# What this program and page cost, not how busy their machine is or how slowly it draws in software: the least of several
# tries counts, and the time a browser takes to find its graphics is left out.
TRIES = 4


class Speed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory(prefix="vesica-speed-")
        cls.addClassCleanup(scratch.cleanup)
        cls.directory = Path(scratch.name) / "run"
        cls.triangles = write_series(cls.directory, FRAMES)
        cls.page = cls.directory / "report.html"

    def report(self, *options):
        done = subprocess.run([PROGRAM, "report", self.directory, *options], check=True, capture_output=True, text=True, timeout=300)
        return done.stdout

    def test_it_is_small_and_soon_there(self):
        self.assertGreater(self.triangles, 20_000)
        said = self.report("--triangles", "21000")
        self.assertIn(f"{FRAMES} of {FRAMES} frames", said)
        size = self.page.stat().st_size
        self.assertLess(size, 20e6)
        parsed, ready, decoded, painted = [], [], [], []
        with Browser() as browser:
            for _ in range(TRIES):
                browser.open(self.page.as_uri())
                browser.settle()
                marks = browser.run("return Object.fromEntries(performance.getEntriesByType('mark').map((m) => [m.name, m.startTime]))")
                parsed.append(marks["vesica-start"])
                ready.append(marks["vesica-tables"])
                decode, paint, triangles = browser.driver.execute_async_script("""
                    const done = arguments[0], stage = window.vesica.stage, steps = [0, 1000, 5000, 9000];
                    (async () => {
                      const begin = performance.now();
                      let frame, triangles = 0;
                      for (const step of steps) {
                        frame = await stage.frames.load(step);
                        triangles = Math.max(triangles, ...frame.surfaces.map((s) => s.triangles.length / 3));
                      }
                      const middle = performance.now();
                      const places = frame.surfaces[0].placesBetween(0, 0, 1);
                      done([(middle - begin) / steps.length, performance.now() - middle + 0 * places.length, triangles]);
                    })();""")
                decoded.append(decode)
                painted.append(paint)
            self.assertEqual(browser.complaints(), [])
        print(f"\n{size / 1e6:.1f} MB, {triangles:.0f} triangles a frame: read after {min(parsed):.0f} ms, plots and tables "
              f"after {min(ready):.0f} ms, a frame decoded in {min(decoded):.1f} ms, coloured in {min(painted):.2f} ms")
        self.assertLess(min(ready) + min(decoded) + min(painted), 1000)
        self.assertLess(min(decoded), 40)


if __name__ == "__main__":
    unittest.main()
