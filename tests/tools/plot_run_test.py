"""tools/plot-run draws what a run's directory holds, and its numbers are right."""

import contextlib
import io
import json
import math
import re
import sys
import tempfile
import unittest
from pathlib import Path

import numpy

sys.path.insert(0, str(Path(__file__).resolve().parent))

from script import load  # noqa: E402
from synthetic_run import RESOLVED, revolve, sample, write_run  # noqa: E402

PLOT_RUN = load("plot-run")

from vesica.plotting.helfrich import HelfrichShapes  # noqa: E402

VOLUME = 4.0 / 3.0 * math.pi * 15.0**3
PICTURES = ("profile.png", "energy.png", "surface.png", "area.png", "inertia.png", "conservation.png")
SHAPES = HelfrichShapes()


def discocyte(v=0.667, displaced=0.0):
    """The exact oblate's surface, every point moved outwards by `displaced` cells."""
    curve = SHAPES.profile("oblate", v).of_volume(VOLUME)
    points, triangles, curvature = revolve(curve)
    normals = numpy.zeros_like(points)
    corners = points[triangles]
    faces = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    for k in range(3):
        numpy.add.at(normals, triangles[:, k], faces)
    normals /= numpy.linalg.norm(normals, axis=1, keepdims=True)
    return points + displaced * normals, triangles, curvature


def rows(v=0.667, energy_factor=1.0):
    energy = energy_factor * float(SHAPES.energy("oblate", v))
    return [sample(step, v, VOLUME, energy, mass_drift=1e-13) for step in (0, 200, 400, 600)]


class PlotRun(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="vesica-plots-")
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name) / "run"

    def plot(self, *arguments):
        """(status, standard output, standard error)."""
        out, err = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            status = PLOT_RUN.main([str(self.folder), *map(str, arguments)])
        return status, out.getvalue(), err.getvalue()

    def assert_drawn(self, path):
        from matplotlib import image

        pixels = image.imread(path)[..., :3]
        self.assertGreater(min(pixels.shape[:2]), 300, path)
        self.assertGreater(pixels.std(), 0.02, f"{path} is blank")

    def test_every_picture_is_drawn_and_named(self):
        write_run(self.folder, *discocyte(), rows=rows())
        status, out, err = self.plot()
        self.assertEqual((status, err), (0, ""), err)
        for name in PICTURES:
            self.assertIn(str(self.folder / "pictures" / name), out)
            self.assert_drawn(self.folder / "pictures" / name)

    def test_the_distance_from_the_exact_shape_and_the_excess_energy_are_those_put_in(self):
        write_run(self.folder, *discocyte(displaced=0.25), rows=rows(energy_factor=1.02))
        _, out, _ = self.plot("--only", "profile", "energy")
        rms, largest = (float(x) for x in re.search(r"distance ([\d.]+) cells.*largest ([\d.]+) cells", out).groups())
        self.assertAlmostEqual(rms, 0.25, delta=0.01)
        self.assertAlmostEqual(largest, 0.25, delta=0.02)
        self.assertIn("oblate", out)
        self.assertRegex(out, r"the last sample is \+2\.00 % from the oblate")

    def test_a_part_that_is_missing_is_not_overlooked(self):
        points, triangles, curvature = discocyte()
        flat = points.copy()
        axis = numpy.array((0.3, -0.5, 0.81)) / numpy.linalg.norm((0.3, -0.5, 0.81))
        middle = points.mean(axis=0)
        height = (points - middle) @ axis
        flat -= numpy.outer(numpy.where(height > 1.0, height - 1.0, 0.0), axis)  # one face pressed flat
        write_run(self.folder, flat, triangles, curvature, rows=rows())
        _, out, _ = self.plot("--only", "profile")
        self.assertGreater(float(re.search(r"largest ([\d.]+) cells", out).group(1)), 1.5)

    def test_a_run_in_real_units_is_compared_in_cells(self):
        cell = 1.8e-7
        points, triangles, curvature = discocyte(displaced=0.1)
        write_run(self.folder, points * cell, triangles, curvature / cell, rows=rows(), step=600)
        series = self.folder / "surfaces" / "surfaces.pvd"
        series.write_text(series.read_text().replace('timestep="600"', 'timestep="0.0109"'))
        (self.folder / "summary.json").write_text(
            json.dumps({"scales": {"cell_m": cell, "step_s": 1.8e-5, "density_kg_per_m3": 1e3}}))
        status, out, _ = self.plot("--only", "profile")
        self.assertEqual(status, 0)
        self.assertAlmostEqual(float(re.search(r"distance ([\d.]+) cells", out).group(1)), 0.1, delta=0.01)

    def test_the_sample_of_the_surface_is_the_one_compared(self):
        # The vesicle goes on shrinking after the last surface: its own volume must serve.
        samples = rows()[:3] + [sample(600, 0.60, 0.9 * VOLUME, 1.9)]
        write_run(self.folder, *discocyte(), rows=samples, step=400)
        _, out, _ = self.plot("--only", "profile")
        self.assertLess(float(re.search(r"distance ([\d.]+) cells", out).group(1)), 0.02)

    def test_a_shape_without_theory_is_drawn_alone(self):
        write_run(self.folder, *discocyte(), rows=[sample(400, 0.2, VOLUME, 4.0)])
        status, out, _ = self.plot("--only", "profile")
        self.assertEqual(status, 0)
        self.assertIn("no exact shape is known at v = 0.2000", out)
        self.assert_drawn(self.folder / "pictures" / "profile.png")

    def test_spontaneous_curvature_is_remarked(self):
        resolved = RESOLVED.replace("spontaneous_curvature = 0.0", "spontaneous_curvature = 0.05")
        write_run(self.folder, *discocyte(), rows=rows(), resolved=resolved)
        status, out, _ = self.plot("--only", "profile", "energy")
        self.assertEqual(status, 0)
        self.assertNotIn("from the oblate", out)

    def test_without_surfaces_the_other_pictures_are_drawn(self):
        write_run(self.folder, rows=rows())
        status, out, err = self.plot("--only", "profile", "energy")
        self.assertEqual(status, 0)
        self.assertIn("profile.png is left out", err)
        self.assertIn("surfaces = { every = N }", err)
        self.assertIn("energy.png", out)

    def test_what_is_no_run_is_refused_with_status_two(self):
        for prepare, saying in (
            (lambda: None, "is no directory"),
            (lambda: self.folder.mkdir(), "metrics.csv: not found"),
            (lambda: (self.folder / "metrics.csv").write_text("a,b\n1,2\n"), "lacks the column step"),
            (lambda: write_run(self.folder, rows=[]), "holds no sample"),
            (lambda: (self.folder / "metrics.csv").write_text(",".join(rows()[0]) + "\n1,x\n"), "metrics.csv:"),
        ):
            prepare()
            status, _, err = self.plot()
            self.assertEqual(status, 2, err)
            self.assertIn(saying, err)

    def test_an_unknown_vesicle_is_refused(self):
        write_run(self.folder, rows=rows())
        status, _, err = self.plot("--vesicle", "3")
        self.assertEqual(status, 2)
        self.assertIn("has no vesicle 3", err)

    def test_a_damaged_surface_fails_with_status_one_and_spares_the_rest(self):
        write_run(self.folder, *discocyte(), rows=rows())
        surface = next((self.folder / "surfaces").glob("*.vtp"))
        surface.write_bytes(surface.read_bytes()[:500])
        status, out, err = self.plot("--only", "surface", "energy")
        self.assertEqual(status, 1)
        self.assertIn("surface.png failed", err)
        self.assertIn("energy.png", out)


if __name__ == "__main__":
    unittest.main()
