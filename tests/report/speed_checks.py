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
# What counts is what the page does, not how busy its machine is or how slowly that draws in software: processor time of the
# page's own thread, which also parses the file; the least of several tries.
TRIES = 2


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

    def work(self, browser):
        """Seconds the page's thread has worked."""
        metrics = browser.driver.execute_cdp_cmd("Performance.getMetrics", {})["metrics"]
        return next(metric["value"] for metric in metrics if metric["name"] == "TaskDuration")

    def test_it_is_small_and_soon_there(self):
        self.assertGreater(self.triangles, 20_000)
        said = self.report("--triangles", "21000")
        self.assertIn(f"{FRAMES} of {FRAMES} frames", said)
        size = self.page.stat().st_size
        self.assertLess(size, 20e6)
        worked, ready, decoded, painted = [], [], [], []
        with Browser() as browser:
            browser.driver.execute_cdp_cmd("Performance.enable", {"timeDomain": "threadTicks"})
            for _ in range(TRIES):
                browser.driver.get("about:blank")
                before = self.work(browser)
                browser.open(self.page.as_uri())
                browser.settle()
                worked.append(self.work(browser) - before)
                marks = browser.run("return Object.fromEntries(performance.getEntriesByType('mark').map((m) => [m.name, m.startTime]))")
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
        print(f"\n{size / 1e6:.1f} MB, {triangles:.0f} triangles a frame: first frame after {1e3 * min(worked):.0f} ms of work; "
              f"plots and tables there after {min(ready):.0f} ms; a frame decoded in {min(decoded):.1f} ms, coloured in "
              f"{min(painted):.2f} ms")
        self.assertLess(min(worked), 1.0)
        self.assertLess(min(decoded), 100)


if __name__ == "__main__":
    unittest.main()
