"""A run's directory in Python: tables, surfaces, fields and pictures of what the program has left."""

import os
import re
import sys
import unittest
from pathlib import Path
from unittest import mock

sys.path.insert(0, str(Path(__file__).resolve().parent))

import h5py  # noqa: E402
import numpy  # noqa: E402
import vesica  # noqa: E402
from small_runs import PROGRAM, RELAXING, SHEARED, Scratch  # noqa: E402


class Directories(Scratch):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.relaxing = vesica.Run(cls.run_program(RELAXING, "relaxing"))
        cls.sheared = vesica.Run(cls.run_program(SHEARED, "sheared"))

    def test_metrics_are_a_table_by_step_and_vesicle(self):
        metrics = self.relaxing.metrics
        self.assertEqual(list(metrics.index), [0, 6, 12, 18, 24])
        self.assertEqual(list(metrics.columns), list(vesica.VesicleSample._fields))
        self.assertGreater(metrics.loc[24].area, 0.0)
        several = self.sheared.metrics
        self.assertEqual(several.index.nlevels, 2)
        self.assertEqual(several.loc[(12, 1)].vesicle, 1)
        self.assertEqual((self.relaxing.vesicles, self.sheared.vesicles), ([0], [0, 1]))

    def test_the_case_and_the_summary_are_those_of_the_run(self):
        self.assertEqual(self.relaxing.case["vesicle[0].radius"], 7)
        self.assertEqual(self.relaxing.summary["last_step"], 24)
        self.assertIsNone(self.relaxing.scales)
        self.assertAlmostEqual(self.sheared.scales.cell / 0.5e-6, 1.0)
        self.assertEqual(self.sheared.case.scales, self.sheared.scales)

    def test_si_and_lattice_units_are_told_apart(self):
        in_si = self.sheared.scales.in_si(self.sheared.metrics)
        self.assertAlmostEqual(in_si.loc[(12, 0)].time / 12e-6, 1.0)
        self.assertAlmostEqual(in_si.loc[(12, 0)].area / self.sheared.metrics.loc[(12, 0)].area / 0.25e-12, 1.0)
        self.assertAlmostEqual(in_si.loc[(12, 0)].tension / self.sheared.metrics.loc[(12, 0)].tension
                               / (1000.0 * 0.5e-6**3 / 1e-6**2), 1.0)  # kg/s^2
        self.assertEqual(in_si.loc[(12, 0)].reduced_volume, self.sheared.metrics.loc[(12, 0)].reduced_volume)
        surface = self.sheared.surface(vesicle=0)
        self.assertAlmostEqual(surface.area(), self.sheared.metrics.loc[(12, 0)].area, delta=0.1 * surface.area())
        self.assertAlmostEqual(float(numpy.median(surface.H)), 1 / 6, delta=0.05)
        live = vesica.Simulation(vesica.Case.from_text(SHEARED))
        live.advance(12)
        fields = self.sheared.fields()
        self.assertEqual((list(fields), fields.step), (["pressure", "velocity"], 12))
        self.assertEqual(fields["velocity"].shape, (8, 12, 16, 3))
        chosen = live.velocity()[4:20:2, 0:24:2, 8:40:2]
        numpy.testing.assert_allclose(fields["velocity"], chosen, rtol=1e-5, atol=1e-9)
        for found, expected in zip((fields.x, fields.y, fields.z), (numpy.arange(8, 40, 2), numpy.arange(0, 24, 2),
                                                                    numpy.arange(4, 20, 2))):
            numpy.testing.assert_allclose(found, expected + 0.5)  # the cells' centres
        numpy.testing.assert_allclose(live.surface(1).points, self.sheared.surface(vesicle=1).points, atol=1e-5)

    def test_forces_of_the_membrane_are_in_lattice_units_and_add_up(self):
        live = vesica.Simulation(vesica.Case.from_text(SHEARED))
        live.advance(12)
        stored, computed = self.sheared.surface(vesicle=1).fields, live.surface(1).fields
        total = stored["bending_force"] + stored["tension_force"] + stored["area_force"]
        most = numpy.abs(computed["total_force"]).max()
        self.assertGreater(most, 0.0)
        numpy.testing.assert_allclose(stored["total_force"], total, atol=1e-5 * most)
        for name in ("bending_force", "tension_force", "area_force", "total_force"):
            numpy.testing.assert_allclose(stored[name], computed[name], atol=1e-5 * most, err_msg=name)

    def test_fields_are_those_of_the_file_with_the_centres_of_the_cells(self):
        fields = self.relaxing.fields(12)
        with h5py.File(self.relaxing.path / "fields.h5") as stored:
            numpy.testing.assert_array_equal(fields["phase"], stored["step_000000012/phase"][...])
        numpy.testing.assert_array_equal(fields.z, numpy.arange(28) + 0.5)
        self.assertEqual(self.relaxing.field_steps, [0, 12, 24])
        with self.assertRaisesRegex(KeyError, "pressure is not among the fields of step 12"):
            fields["pressure"]
        with self.assertRaisesRegex(vesica.InputError, "step is 13; expected one of the 3 steps with a field.*; try 12"):
            self.relaxing.fields(13)

    def test_surfaces_are_one_vesicles_or_all_of_them(self):
        self.assertEqual(self.sheared.steps, [0, 12])
        whole, first = self.sheared.surface(), self.sheared.surface(vesicle=0)
        self.assertEqual(sorted(numpy.unique(whole.fields["vesicle"])), [0, 1])
        self.assertEqual((whole.fields["vesicle"] == 0).sum(), len(first.points))
        self.assertLess(first.points[:, 0].max(), whole.points[:, 0].max())
        with self.assertRaisesRegex(vesica.Unavailable, "vesicle 2 is not in it"):
            self.sheared.surface(vesicle=2)

    def test_every_picture_is_drawn_without_a_session_of_pyplot(self):
        for run, quantities in ((self.relaxing, ("energy", "area", "inertia", "conservation", "profile", "gap")),
                                (self.sheared, ("angle", ["vx", "wall_stress"]))):
            for quantity in quantities:
                self.assert_drawn(run.plot(quantity), quantity)
        self.assert_drawn(self.relaxing.plot("profile", step=0), "profile at 0")
        self.assertNotIn("matplotlib.pyplot", [name for name in sys.modules if name == "matplotlib.pyplot"])
        for quantity, saying in (("vorticity", "quantity is 'vorticity'; expected one of profile, energy"), ([], "is empty")):
            with self.assertRaisesRegex(vesica.InputError, saying):
                self.relaxing.plot(quantity)
        with self.assertRaisesRegex(vesica.Unavailable, "every inclination in metrics.csv is nan"):
            self.relaxing.plot("angle")
        with self.assertRaisesRegex(vesica.InputError, "has no vesicle 7; it has 0"):
            self.relaxing.plot("energy", vesicle=7)

    def assert_drawn(self, figure, name):
        path = self.folder / "picture.png"
        figure.savefig(path)
        from matplotlib import image

        pixels = image.imread(path)[..., :3]
        self.assertGreater(min(pixels.shape[:2]), 300, name)
        self.assertGreater(pixels.std(), 0.02, f"{name} is blank")

    def test_a_surface_is_rendered_without_a_display(self):
        with mock.patch.dict(os.environ):
            os.environ.pop("DISPLAY", None)
            pixels = self.sheared.render(colour_by="vesicle", annotated=False)
        self.assertEqual((pixels.dtype, pixels.shape[2]), (numpy.uint8, 3))
        colours = pixels.reshape(-1, 3).astype(int)
        blue = (colours[:, 2] > colours[:, 0] + 60).mean()
        orange = (colours[:, 0] > colours[:, 2] + 60).mean()
        self.assertGreater(min(blue, orange), 0.05)  # both are seen
        with self.assertRaisesRegex(vesica.Unavailable, "carries no colour; what it carries: .*mean_curvature"):
            self.relaxing.render(colour_by="colour")

    def test_what_is_no_run_is_refused(self):
        with self.assertRaisesRegex(vesica.InputError, "is no directory"):
            vesica.Run(self.folder / "none")
        with self.assertRaisesRegex(vesica.InputError, "expected the directory of a run"):
            vesica.Run(self.folder)

    def test_the_report_is_the_programs(self):
        with mock.patch.dict(os.environ, VESICA_PROGRAM=PROGRAM):
            status, said, errors = self.program("report", "relaxing")
            if status == 0:
                page = self.folder / "relaxing/report.html"
                made = re.compile(rb'"made":"[^"]*"')  # the time, in seconds
                first, times = made.subn(b"", page.read_bytes())
                self.assertEqual(times, 1)
                page.unlink()
                self.assertIn("report.html", self.relaxing.report())
                self.assertEqual(made.sub(b"", page.read_bytes()), first)
            else:
                with self.assertRaises(vesica.RunError) as refused:
                    self.relaxing.report()
                self.assertIn(errors.strip(), str(refused.exception))


if __name__ == "__main__":
    unittest.main()
