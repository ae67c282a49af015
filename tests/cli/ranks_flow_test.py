"""Flows and tracers on several ranks: the same files whatever the flow, and what cannot be is said."""

import unittest

from tests.cli.ranks_test import CASE, STEPS, Ranks


class Flows(Ranks):
    def test_every_file_is_the_same_on_any_ranks_and_after_a_pause(self):
        tracers = "[output.profiles]\nevery = 20\nacross = \"y\"\n[tracers]\nevery = 10\nrelease = 20\nmembrane = 5\n[[tracers.seeds]]\nfrom = [2, 3, 1]\nto = [20, 30, 39]\ncount = 4\n"
        flows = {
            "sliding": '[flow.shear]\nrate = 2e-3\nvelocity = "x"\ngradient = "z"\nwith = "lees-edwards"\n',  # through the vesicle
            "channel": '[boundary.y]\nlower = { type = "wall" }\nupper = { type = "wall", velocity = [0, 0, 0.02], ramp = 30 }\n'
                       "[flow.body_force]\nforce = [1e-5, 0, 0]\n",
        }  # fmt: skip
        second = '[[vesicle]]\ntype = "rbc"\nshape = "sphere"\ncentre = [14, 29, 14]\nradius = 6\n'
        for name, flow in flows.items():
            self.case.write_text(CASE + second + tracers + flow)
            self.run_on(0, name)
            expected = self.outputs(name)
            for table in ("tracers.csv", "profiles.csv", "suspension.csv", "pairs.csv"):
                self.assertIn(table, expected)
            rows = (self.directory / name / "tracers.csv").read_text().splitlines()
            self.assertEqual([rows[-1].split(",")[k] for k in (0, 2, 4)], [str(STEPS), "25", str(STEPS)])  # 4 releases of 4, 2 x 5
            for counts in ((2, 4), (3, 8)):
                with self.subTest(flow=name, ranks=counts):
                    target = "-".join([name, *map(str, counts)])
                    self.run_on(counts[0], target, "--steps", 27)
                    self.resume_on(counts[1], target, "--steps", STEPS)
                    self.assertEqual(self.outputs(target), expected)

    def test_a_sheared_state_cannot_be_taken_apart(self):
        flow = '[flow.shear]\nrate = 2e-3\nvelocity = "x"\ngradient = "z"\nwith = "lees-edwards"\n'
        self.case.write_text(CASE + flow)
        self.run_on(0, "sheared", "--steps", 20)
        self.case.write_text(CASE + flow + '[initial]\ncheckpoint = "sheared"\n')
        status, _, errors = self.vesica_on(0, "run", self.case, "-o", "again")
        self.assertEqual(status, 2, errors)
        self.assertIn("the images above the box have moved on by 1.6 cells", errors)
        status, _, errors = self.vesica_on(2, "run", self.case, "-o", "again", "--blocks", "2,1,1")
        self.assertEqual(status, 2, errors)
        self.assertIn("expected one block along x, along which flow.shear with lees-edwards moves", errors)


if __name__ == "__main__":
    unittest.main()
