"""The rest shapes with spontaneous curvature are minimisers, and their meshes are what the simulator reads."""

import csv
import sys
import tempfile
import unittest
from collections import Counter
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "validation" / "spontaneous_curvature"))

import check_minimiser as check  # noqa: E402
from axisymmetric_minimiser import NoShape, follow  # noqa: E402
from meridian_functionals import MeridianFunctionals  # noqa: E402
from reference import ENTRIES, reference_shape, row, tabulated_shape  # noqa: E402
from revolved_mesh import revolve, write_ply  # noqa: E402


def read_back(path: Path) -> tuple[np.ndarray, np.ndarray]:
    header, body = path.read_bytes().split(b"end_header\n", 1)
    counts = [int(line.split()[2]) for line in header.splitlines() if line.startswith(b"element")]
    vertices = np.frombuffer(body, "<f8", 3 * counts[0]).reshape(-1, 3)
    faces = np.frombuffer(body, [("count", "u1"), ("corners", "<i4", 3)], counts[1], 24 * counts[0])
    return vertices, faces["corners"]


class Minimiser(unittest.TestCase):
    def hold(self, findings):
        count = 0
        for what, error, tolerance in findings:
            count += 1
            with self.subTest(what):
                self.assertLessEqual(error, tolerance)
        self.assertGreater(count, 0)

    def test_the_derivatives_are_those_of_the_functionals(self):
        functionals = MeridianFunctionals(np.arange(1, 9))
        rng = np.random.default_rng(5)
        orders, multipliers, h = functionals.orders, np.array([0.3, -0.7, 0.2]), 1e-5
        x, direction = (np.append(rng.normal(size=8) * 0.3 / orders**2, 0.1 * rng.normal()) for _ in range(2))
        at, before, after = (
            functionals.evaluate((x + k * h * direction)[:8], 3.0 + x[8] + k * h * direction[8], 1.7, multipliers)
            for k in (0, -1, 1)
        )
        slope = (after.values - before.values) / (2 * h)
        np.testing.assert_allclose(at.gradients @ direction, slope, rtol=1e-6, atol=1e-7)
        weights = np.append(1.0, -multipliers)
        bend = weights @ (after.gradients - before.gradients) / (2 * h)
        np.testing.assert_allclose(at.hessian @ direction, bend, rtol=1e-5, atol=1e-5)

    def test_without_spontaneous_curvature_the_table_is_met(self):
        self.hold(check.against_table([("oblate", (0.95, 0.65)), ("prolate", (0.8,)), ("stomatocyte", (0.6,))]))

    def test_the_multipliers_are_the_slopes_of_the_energy(self):
        self.hold(check.multipliers([(-2.0, "oblate", 0.667), (2.0, "prolate", 0.8)]))

    def test_the_shape_equation_holds_pointwise(self):
        self.hold(check.balanced_forces([(-2.0, "oblate", 0.667), (2.0, "prolate", 0.8)]))

    def test_the_energy_converges_with_the_modes(self):
        self.hold(check.convergence([((2.0, "oblate", 0.667), (8, 12, 16, 20))]))

    def test_an_oblate_loses_its_mirror_plane_at_negative_spontaneous_curvature(self):
        self.assertEqual(reference_shape(0.0, "oblate", 0.667).unstable_directions, 0)
        self.assertEqual(reference_shape(-2.0, "oblate", 0.667).unstable_directions, 1)

    def test_shifts_and_turns_cost_nothing_and_the_oblate_turns_elliptic_where_published(self):
        self.hold(check.off_axis())

    def test_the_committed_table_is_what_the_minimiser_finds(self):
        with (Path(check.__file__).parent / "reference.csv").open() as file:
            table = list(csv.DictReader(file))
        self.assertEqual(len(table), len(ENTRIES))
        for line in (table[1], table[-2]):
            key = float(line["c0_times_R_A"]), line["branch"], float(line["v"])
            for column, value in row(reference_shape(*key), line["branch"]).items():
                with self.subTest(column):
                    try:
                        self.assertAlmostEqual(float(value), float(line[column]), delta=2e-6)
                    except ValueError:
                        self.assertEqual(value, line[column])

    def test_poles_that_have_passed_each_other_are_no_body(self):
        crossed = tabulated_shape("oblate", 0.5)
        self.assertFalse(crossed.is_embedded)
        self.assertLess(crossed.axis_thickness, 0)
        with self.assertRaises(ValueError):
            write_ply(crossed, "never-written.ply", 10.0)

    def test_a_branch_that_ends_is_reported(self):
        with self.assertRaises(NoShape):
            follow(tabulated_shape("stomatocyte", 0.65, 48), 0.75, 0.0)

    def test_the_mesh_is_closed_outward_symmetric_and_of_the_right_size(self):
        shape = tabulated_shape("oblate", 0.65)
        with tempfile.TemporaryDirectory() as folder:
            write_ply(shape, Path(folder) / "shape.ply", 10.0, 61)
            vertices, triangles = read_back(Path(folder) / "shape.ply")
        edges = Counter(edge for t in triangles.tolist() for edge in zip(t, t[1:] + t[:1]))
        self.assertEqual(set(edges.values()), {1})
        self.assertTrue(all((b, a) in edges for a, b in edges))
        self.assertEqual(len(vertices) - len(edges) // 2 + len(triangles), 2)
        corners = vertices[triangles]
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        volume = np.einsum("ij,ij->", corners[:, 0], normals) / 6
        self.assertAlmostEqual(volume / (4 / 3 * np.pi * 1000), 1, places=9)
        area = np.linalg.norm(normals, axis=1).sum() / 2
        self.assertAlmostEqual(volume / (4 / 3 * np.pi) / (area / (4 * np.pi)) ** 1.5, 0.65, delta=0.002)
        lengths = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2)
        self.assertLess(lengths.max() / lengths.min(), 2.5)

        def centroids(x):
            points = np.round(x[triangles].mean(axis=1), 6) + 0.0
            return set(map(tuple, points))

        for image in (vertices * (-1, 1, 1), vertices * (1, 1, -1), vertices[:, [1, 0, 2]]):
            self.assertEqual(centroids(image), centroids(vertices))

    def test_a_shape_without_mirror_plane_gives_a_closed_mesh(self):
        vertices, triangles = revolve(tabulated_shape("stomatocyte", 0.52, 48), 201)
        self.assertEqual(len(triangles), 2 * len(vertices) - 4)


if __name__ == "__main__":
    unittest.main()
