"""The page of a run that goes on: it grows by itself, and stays where its reader is."""

import subprocess
import tempfile
import unittest
from pathlib import Path

from browser import Browser, colourful
from page_checks import PROGRAM, SMALL


class Live(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="vesica-live-")
        self.addCleanup(scratch.cleanup)
        self.directory = Path(scratch.name)
        (self.directory / "small.toml").write_text(SMALL)
        self.run_ = subprocess.Popen([PROGRAM, "run", "small.toml", "-o", "run", "--watch", "0", "--threads", "1", "--steps", "1000000"],
                                     cwd=self.directory, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(self.end)
        self.address = self.run_.stdout.readline().split("watch it at ")[1].strip()

    def end(self):
        self.run_.kill()
        self.run_.communicate()

    def test_it_grows_with_the_run(self):
        with Browser() as page:
            page.open(self.address)
            page.wait("return window.vesica?.stage.shown != null && window.vesica.metrics.steps.length > 1")
            self.assertGreater(colourful(page.canvas()), 0.03)
            first = page.shown_step()
            samples = page.run("return window.vesica.metrics.steps.length")
            page.wait(f"return window.vesica.stage.shown?.step > {first} && window.vesica.metrics.steps.length > {samples}")
            # A reader who looks at an earlier time is left there.
            page.run("const s = document.getElementById('frame'); s.value = 1; s.dispatchEvent(new Event('input'))")
            page.settle()
            held, frames = page.shown_step(), page.run("return window.vesica.manifest.frames.length")
            page.wait(f"return window.vesica.manifest.frames.length > {frames}")
            self.assertEqual(page.shown_step(), held)
            # So too when the list of frames is thinned under the reader: the step stays, its index does not.
            page.run("const s = document.getElementById('frame'); s.value = 2; s.dispatchEvent(new Event('input'))")
            page.settle()
            held = page.shown_step()
            page.run("""
                const { grow, manifest } = window.vesica;
                grow({ ...manifest, frames: manifest.frames.filter((frame, index) => index % 2 === 0) });""")
            page.settle()
            self.assertEqual(page.run("return [window.vesica.store.get('frame'), window.vesica.store.get('step')]"), [1, held])
            self.assertEqual(page.shown_step(), held)
            self.assertIn("running", page.run("return document.getElementById('badges').textContent"))
            self.assertEqual(page.complaints(), [])


if __name__ == "__main__":
    unittest.main()
