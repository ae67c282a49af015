"""The page of `vesica report` in headless Chromium: no errors, a picture that follows the slider, plots of the data.

Run by `tools/check-deep browser`, which makes the runs. VESICA_PROGRAM names the program.
"""

import os
import subprocess
import tempfile
import unittest
from pathlib import Path

import numpy
import pandas
from browser import Browser, colourful
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

SOURCE = Path(__file__).resolve().parents[2]
PROGRAM = os.environ.get("VESICA_PROGRAM", str(SOURCE / "build/ci/bin/vesica"))

SMALL = """title = "two <b>small</b> vesicles"
[lattice]
size = [48, 32, 32]
[fluid]
kinematic_viscosity = 0.1666667
[vesicle_type.rbc]
[vesicle_type.rbc.bending]
modulus = 0.25
[[vesicle]]
type = "rbc"
shape = "spheroid"
aspect = 1.6
centre = [13, 16, 16]
radius = 8
[[vesicle]]
type = "rbc"
shape = "sphere"
centre = [35, 16, 16]
radius = 8
[boundary.z]
lower = { type = "wall", velocity = [-0.01, 0, 0] }
upper = { type = "wall", velocity = [0.01, 0, 0] }
[run]
steps = 120
[output]
metrics = { every = 10 }
surfaces = { every = 20 }
"""


def vesica(*arguments):
    subprocess.run([PROGRAM, *map(str, arguments)], check=True, capture_output=True, text=True, timeout=300)


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory(prefix="vesica-page-")
        cls.addClassCleanup(scratch.cleanup)
        cls.directory = Path(scratch.name)
        (cls.directory / "small.toml").write_text(SMALL)
        cls.run_directory = cls.directory / "run"
        vesica("run", cls.directory / "small.toml", "-o", cls.run_directory, "--threads", "2")
        vesica("report", cls.run_directory)
        cls.address = (cls.run_directory / "report.html").as_uri()
        cls.metrics = pandas.read_csv(cls.run_directory / "metrics.csv", float_precision="round_trip")
        cls.browser = Browser()
        cls.addClassCleanup(cls.browser.__exit__)
        cls.browser.open(cls.address)

    def setUp(self):
        """The page as it is when it is opened, without the time to open it."""
        self.browser.run("""
            const { store, stage } = window.vesica;
            store.set('playing', false);
            store.set('frame', 6);
            store.set('colour', 'mean_curvature');
            for (const chip of document.querySelectorAll('#vesicles [aria-pressed=false]')) chip.click();
            document.getElementById('columns-usual').click();
            stage.view.look('fit');
            window.scrollTo(0, 0);""")
        self.browser.settle()

    def tearDown(self):
        self.assertEqual(self.browser.complaints(), [])

    def slide_to(self, index):
        self.browser.run("const s = document.getElementById('frame'); s.value = arguments[0]; s.dispatchEvent(new Event('input'))", index)
        self.browser.settle()

    def test_the_picture_is_not_blank(self):
        self.assertGreater(colourful(self.browser.canvas()), 0.03)

    def test_the_slider_changes_the_picture_and_the_same_frame_is_the_same_picture(self):
        self.slide_to(0)
        self.assertEqual(self.browser.shown_step(), 0)
        first = self.browser.canvas()
        self.slide_to(6)
        self.assertEqual(self.browser.shown_step(), 120)
        last = self.browser.canvas()
        self.assertGreater(numpy.mean(numpy.abs(first - last).max(axis=2) > 0.02), 0.005)
        self.slide_to(0)
        self.assertLess(numpy.mean(numpy.abs(first - self.browser.canvas()).max(axis=2) > 0.02), 0.0005)

    def test_every_colour_choice_changes_the_picture(self):
        pictures, legends = {}, set()
        for choice in self.browser.run("return [...document.getElementById('colour').options].map((o) => o.value)"):
            self.browser.run("const c = document.getElementById('colour'); c.value = arguments[0]; c.dispatchEvent(new Event('change'))", choice)
            self.browser.settle()
            pictures[choice] = self.browser.canvas()
            legends.add(self.browser.run("return document.getElementById('legend').textContent"))
        self.assertEqual(len(legends), 7)  # a vesicle's colour has none
        self.assertEqual(list(pictures), ["mean_curvature", "gaussian_curvature", "speed", "total_force", "bending_force",
                                          "tension_force", "area_force", "vesicle"])
        for one in ("gaussian_curvature", "speed", "total_force", "vesicle"):
            difference = numpy.abs(pictures[one] - pictures["mean_curvature"]).max(axis=2)
            self.assertGreater(numpy.mean(difference > 0.03), 0.001, one)

    def test_plots_show_the_data_of_the_table(self):
        self.browser.run("document.getElementById('columns-all').click()")
        for name in self.browser.run("return [...document.querySelectorAll('.card')].map((c) => c.dataset.column)"):
            self.browser.run("document.querySelector(`.card[data-column=${arguments[0]}]`).scrollIntoView()", name)
            self.browser.wait(f"return window.vesica.plots.cards.get('{name}').plot !== null")
            steps, *lines = self.browser.run("return [...window.vesica.plots.cards.get(arguments[0]).plot.data].map((d) => [...d])", name)
            for vesicle, line in enumerate(lines):
                rows = self.metrics[self.metrics.vesicle == vesicle]
                self.assertEqual(steps, list(rows.step))
                numpy.testing.assert_array_equal(numpy.array(line, dtype=float), rows[name].to_numpy(dtype=float), name)
        shown = {card.get_attribute("data-column") for card in self.browser.driver.find_elements(By.CSS_SELECTOR, ".card")}
        named = {name for name in self.metrics.columns if self.metrics[name].notna().any()} - {"step", "time", "vesicle"}
        self.assertEqual(shown, named)

    def test_a_line_is_drawn_where_the_data_say(self):
        """The pixels of a plot, not only what it was given."""
        found = self.browser.run("""
            const card = window.vesica.plots.cards.get('bending_energy');
            card.element.scrollIntoView();
            window.vesica.plots.build(card);
            const { plot } = card, { width, height } = plot.ctx.canvas, hits = [];
            const all = plot.ctx.getImageData(0, 0, width, height).data;
            plot.data[0].forEach((x, i) => {
              const at = [plot.valToPos(x, 'x', true), plot.valToPos(plot.data[1][i], 'y', true)].map(Math.round);
              let red = false;
              for (let row = at[1] - 2; row <= at[1] + 2; ++row)
                for (let k = 4 * (row * width + at[0] - 2), n = 0; n < 5; ++n, k += 4) red ||= all[k + 3] > 100 && all[k] > all[k + 2] + 60;
              hits.push(red);
            });
            return hits;""")
        self.assertEqual(len(found), 13)
        self.assertTrue(all(found), found)

    def test_a_click_on_a_plot_moves_the_time(self):
        self.slide_to(0)
        self.browser.run("window.vesica.plots.cards.get('bending_energy').element.scrollIntoView({ block: 'center' })")
        self.browser.wait("return document.querySelector('.card[data-column=bending_energy] .u-over') !== null")
        over = self.browser.driver.find_element(By.CSS_SELECTOR, ".card[data-column=bending_energy] .u-over")
        over.click()  # its middle
        self.browser.settle()
        self.assertEqual(self.browser.shown_step(), 60)
        left = self.browser.run("return new DOMMatrix(getComputedStyle(document.querySelector('.card[data-column=bending_energy] .frame-line')).transform).e")
        self.assertAlmostEqual(left / over.size["width"], 0.5, delta=0.03)

    def test_the_keyboard_plays_and_moves(self):
        body = self.browser.driver.find_element(By.TAG_NAME, "body")
        body.send_keys(Keys.HOME)
        self.browser.settle()
        self.assertEqual(self.browser.shown_step(), 0)
        body.send_keys(Keys.ARROW_RIGHT)
        self.browser.settle()
        self.assertEqual(self.browser.shown_step(), 20)
        body.send_keys(" ")
        self.browser.wait("return window.vesica.store.get('step') >= 80")
        self.assertEqual(self.browser.run("return document.getElementById('play').getAttribute('aria-label')"), "Pause")
        body.send_keys(" ")
        self.assertFalse(self.browser.run("return window.vesica.store.get('playing')"))
        before = self.browser.canvas()
        body.send_keys(Keys.SHIFT + Keys.ARROW_RIGHT)
        self.browser.settle()
        self.assertGreater(numpy.mean(numpy.abs(before - self.browser.canvas()) > 0.02), 0.002)

    def test_everything_that_can_be_used_has_a_name_and_can_be_reached(self):
        nameless = self.browser.run("""
            return [...document.querySelectorAll('button, select, input, [tabindex], summary')].filter((e) => !(
              e.textContent.trim() || e.getAttribute('aria-label') || e.closest('label') || e.getAttribute('aria-labelledby'))).map((e) => e.outerHTML)""")
        self.assertEqual(nameless, [])
        self.assertEqual(self.browser.run("return [...document.querySelectorAll('[tabindex]')].filter((e) => e.tabIndex > 0).length"), 0)

    def test_a_vesicle_can_be_hidden_from_the_view_and_the_plots(self):
        both = colourful(self.browser.canvas())
        self.browser.run("document.querySelector('#vesicles button[aria-label=\"Vesicle 1\"]').click()")
        self.browser.settle()
        self.assertLess(colourful(self.browser.canvas()), 0.75 * both)
        self.assertEqual(self.browser.run("return window.vesica.plots.dataFor('area').length"), 2)

    def test_the_tables_say_what_the_files_say(self):
        text = self.browser.run("return document.body.textContent")
        for part in ("two <b>small</b> vesicles", "gauss bonnet", "MLUPS", "reduced volume", "confinement", "kinematic_viscosity = 0.1666667"):
            self.assertIn(part, text)
        self.assertEqual(self.browser.run("return document.querySelectorAll('h1 b').length"), 0)

    def test_it_asks_nobody_for_anything(self):
        self.assertEqual(self.browser.run("return performance.getEntriesByType('resource').filter((r) => !r.name.startsWith('data:')).map((r) => r.name)"), [])


    # Other screens and other runs.

    def test_on_a_phone_nothing_is_wider_than_the_screen(self):
        with Browser(390, 844, mobile=True) as phone:
            phone.open(self.address)
            phone.settle()
            self.assertLessEqual(phone.run("return document.documentElement.scrollWidth"), 390)
            self.assertGreater(colourful(phone.canvas()), 0.02)
            small = phone.run("""return [...document.querySelectorAll('.timeline button, .timeline input')].filter((e) => e.offsetParent)
                .filter((e) => e.getBoundingClientRect().height < 28).map((e) => e.outerHTML)""")
            self.assertEqual(small, [])
            self.assertEqual(phone.complaints(), [])

    def test_dark_follows_the_system_and_the_button(self):
        with Browser(dark=True, reduced_motion=True) as night:
            night.open(self.address)
            night.settle()
            luminance = "const c = getComputedStyle(document.body).backgroundColor.match(/[0-9.]+/g); return (Number(c[0]) + Number(c[1]) + Number(c[2])) / 3"
            self.assertLess(night.run(luminance), 40)
            self.assertGreater(colourful(night.canvas()), 0.03)
            night.run("document.getElementById('theme').click()")
            self.assertGreater(night.run(luminance), 215)
            self.assertFalse(night.run("return window.vesica.stage.view.controls.enableDamping"))
            self.assertEqual(night.complaints(), [])

    def test_a_run_without_surfaces_has_a_page_that_says_so(self):
        vesica("run", self.directory / "small.toml", "-o", self.directory / "bare", "--set", "output.surfaces.every=0", "--steps", "20")
        vesica("report", self.directory / "bare")
        with Browser() as browser:
            browser.open((self.directory / "bare/report.html").as_uri())
            self.assertIn("left no surfaces", browser.run("return document.getElementById('view-message').textContent"))
            browser.wait("return document.querySelectorAll('.card canvas').length > 3")
            self.assertEqual(browser.complaints(), [])


if __name__ == "__main__":
    unittest.main()
