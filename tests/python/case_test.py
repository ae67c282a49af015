"""Cases are read, changed and refused as the program does it, with its own words."""

import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

import numpy  # noqa: E402
import vesica  # noqa: E402
from small_runs import RELAXING, SHEARED, Scratch  # noqa: E402


class Cases(Scratch):
    def setUp(self):
        self.file = self.folder / "case.toml"
        self.file.write_text(RELAXING, encoding="utf-8")
        self.case = vesica.Case(self.file)

    def test_every_message_is_the_programs_own(self):
        for path, value, word in (
            ("fluid.viscosty", 0.2, "0.2"), ("fluid.kinematic_viscosity", -1, "-1"), ("vesicle[0].radius", 30, "30"),
            ("vesicle[3].radius", 3, "3"), ("vesicle[0].shape", "cube", "cube"), ("run.steps", 1.5, "1.5"),
            ("lattice.size", [24, 24], "[24, 24]"), ("vesicle[0].centre", "3.9 um", "3.9 um"), ("a b", 1, "1"),
        ):
            with self.assertRaises(vesica.InputError) as refused:
                self.case[path] = value
            status, _, said = self.program("check", "case.toml", "--set", f"{path}={word}")
            self.assertEqual(status, 2)
            ours = str(refused.exception).replace(f'"{word}"', word).replace(str(self.folder) + "/", "")
            self.assertEqual(ours.strip(), said.strip().replace(f'"{word}"', word))
        self.assertEqual(self.case["vesicle[0].radius"], 7)  # nothing of it stayed

    def test_a_wrong_file_is_told_with_line_and_column(self):
        self.file.write_text(RELAXING.replace("radius = 7", "radius = true"), encoding="utf-8")
        with self.assertRaisesRegex(vesica.InputError, r"case\.toml:\d+:\d+: vesicle\[0\]\.radius is true; expected"):
            vesica.Case(self.file)
        with self.assertRaisesRegex(vesica.InputError, "does not exist"):
            vesica.Case(self.folder / "none.toml")
        with self.assertRaises(ValueError):  # what it is to those who know nothing of vesica
            vesica.Case.from_text("")

    def test_values_of_every_kind_go_in_and_come_out(self):
        self.case["vesicle[0].centre"] = numpy.array([12.0, 12.5, 14.0])
        self.case["fluid.segregation"] = numpy.float32(0.5)
        self.case["numerics.precision"] = "single"
        self.case["run.stop_when_steady"] = {"quantity": "area", "relative_change": 1e-3, "over": 12}
        self.case["title"] = 'a "title" with \\ and ü'
        self.assertEqual(self.case["vesicle[0].centre"], [12, 12.5, 14])
        self.assertEqual(self.case["fluid.segregation"], 0.5)
        self.assertEqual(self.case["run.stop_when_steady.over"], 12)
        self.assertEqual(self.case.title, 'a "title" with \\ and ü')
        self.assertEqual(vesica.Case.from_text(self.case.text).resolved, self.case.resolved)
        with self.assertRaisesRegex(vesica.InputError, "run.steps is None; expected a number"):
            self.case["run.steps"] = None

    def test_a_copy_is_changed_alone_and_values_that_belong_together_are_changed_together(self):
        wider = self.case.changed({"lattice.size": [64, 64, 64], "vesicle[0].radius": 20, "vesicle[0].centre": [32, 32, 32]})
        self.assertEqual((wider["vesicle[0].radius"], self.case["vesicle[0].radius"]), (20, 7))
        self.assertIn("vesicle[0].radius", wider)
        self.assertNotIn("vesicle[1].radius", wider)
        self.assertIsNone(wider.get("units"))
        with self.assertRaisesRegex(KeyError, "fluid.viscosity is not in this case; beside it there are .*kinematic_visc"):
            wider["fluid.viscosity"]

    def test_check_gives_the_plan_or_what_is_refused(self):
        plan = self.case.check()
        _, said, _ = self.program("check", "case.toml")
        self.assertEqual(plan.cells, 24 * 24 * 28)
        self.assertAlmostEqual(plan.relaxation_time, 1.0, places=6)
        self.assertAlmostEqual(plan.vesicles[0]["radius"], 7, delta=0.01)
        told = [" ".join(line.split()) for line in said.splitlines()]  # columns are wider where the cost is told
        for line in str(plan).replace(str(self.folder) + "/", "").splitlines():
            self.assertIn(" ".join(line.split()), told)
        for remark in plan.notes + plan.warnings:
            self.assertIn(remark, str(plan))
        soft = self.case.changed({"vesicle_type.rbc.bending.modulus": 0.01})
        with self.assertRaisesRegex(vesica.InputError, "modulus is 0.01"):
            soft.check()
        with self.assertRaisesRegex(vesica.InputError, "modulus is 0.01"):
            vesica.Simulation(soft)
        self.assertGreater(len(soft.check(accept_soft_membranes=True).vesicles), 0)

    def test_scales_are_the_bridge_to_si(self):
        scales = vesica.Case.from_text(SHEARED).scales
        self.assertEqual((scales.cell, scales.step), (0.5e-6, 1e-6))
        self.assertAlmostEqual(scales.unit("velocity"), 0.5)
        self.assertAlmostEqual(scales.unit("energy") / (1000 * 0.5e-6**5 / 1e-6**2), 1.0)
        self.assertEqual(scales.unit("reduced_volume"), 1.0)
        self.assertIsNone(self.case.scales)


if __name__ == "__main__":
    unittest.main()
