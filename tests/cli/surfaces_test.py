"""The surfaces of a run, read by VTK: closed, outward, of the area that the metrics say, wherever a vesicle lies."""

import csv
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

from tests.cli.program_test import SMALL, Program

HEAD, VESICLE, TAIL = SMALL[: SMALL.index("[[vesicle]]")], SMALL[SMALL.index("[[vesicle]]"): SMALL.index("[run]")], SMALL[SMALL.index("[run]"):]
TENSE = HEAD.replace("[vesicle_type.rbc.bending]", "tension.sigma = 1e-3\n[vesicle_type.rbc.bending]")


def vesicle(centre, radius, shape='"sphere"'):
    return VESICLE.replace("[16, 16, 16]", str(centre)).replace("radius = 8", f"radius = {radius}").replace('"sphere"', shape)


class Surface:
    """One vesicle of a file."""

    def __init__(self, data, index):
        cells = vtk_to_numpy(data.GetCellData().GetArray("vesicle")) == index
        triangles = vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)[cells]
        used, self.triangles = np.unique(triangles, return_inverse=True)
        self.triangles = self.triangles.reshape(-1, 3)
        self.points = vtk_to_numpy(data.GetPoints().GetData())[used].astype(float)
        values = data.GetPointData()
        self.values = {values.GetArrayName(k): vtk_to_numpy(values.GetArray(k))[used].astype(float)
                       for k in range(values.GetNumberOfArrays())}
        a, b, c = (self.points[self.triangles[:, k]] for k in range(3))
        self.facets = 0.5 * np.cross(b - a, c - a)
        self.area = np.linalg.norm(self.facets, axis=1).sum()
        self.volume = np.einsum("ij,ij", a - self.points[0], self.facets) / 3

    def edges(self):
        return np.concatenate([self.triangles[:, pair] for pair in ([0, 1], [1, 2], [2, 0])])


class Surfaces(Program):
    def surfaces(self, case, vesicles, *arguments):
        self.case.write_text(case)
        status, _, errors = self.vesica("run", self.case, "-o", "target", "--threads", 1, *arguments)
        self.assertEqual(status, 0, errors)
        with open(self.directory / "target/metrics.csv", encoding="utf-8") as table:
            last = [row for row in csv.DictReader(table)][-vesicles:]
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(sorted((self.directory / "target/surfaces").glob("*.vtp"))[-1]))
        reader.Update()
        self.assertEqual(reader.GetOutput().GetPointData().GetNormals().GetName(), "normal")
        return [(Surface(reader.GetOutput(), int(float(row["vesicle"]))), row) for row in last]

    def check_law(self, surface, metrics):
        edges = surface.edges()
        sides = {(a, b) for a, b in edges}
        self.assertEqual(len(sides), len(edges))  # no side twice, and each has its other side: watertight
        self.assertEqual(sides, {(b, a) for a, b in sides})
        self.assertEqual(len(surface.points) - len(edges) // 2 + len(surface.triangles), 2)  # Euler
        self.assertAlmostEqual(surface.area / float(metrics["area"]), 1, delta=0.01)
        self.assertAlmostEqual(surface.volume / float(metrics["volume"]), 1, delta=0.015)
        centre = np.array([float(metrics[axis]) for axis in "xyz"])
        self.assertLess(np.abs(surface.points.mean(axis=0) - centre).max(), 0.2)  # in one piece where the metrics have it
        corners = surface.values["normal"][surface.triangles].mean(axis=1)
        large = np.linalg.norm(surface.facets, axis=1) > 0.02
        cosines = np.einsum("ij,ij->i", corners, surface.facets)[large] / np.linalg.norm(surface.facets, axis=1)[large]
        self.assertGreater(cosines.min(), 0.8)  # outwards
        np.testing.assert_allclose(np.linalg.norm(surface.values["normal"], axis=1), 1, atol=1e-6)
        parts = sum(surface.values[f"{name}_force"] for name in ("bending", "tension", "area"))
        np.testing.assert_allclose(surface.values["total_force"], parts, atol=1e-9)

    def test_of_several_vesicles_across_all_faces(self):
        case = TENSE + vesicle([1.3, 30.2, 43.9], 8) + vesicle([20, 20, 20], 10, '"spheroid"\naspect = 0.8') + TAIL
        found = self.surfaces(case, 2, "--set", "lattice.size=[40, 42, 44]", "--steps", 20)
        self.assertEqual(len(found), 2)
        for surface, metrics in found:
            self.check_law(surface, metrics)
            np.testing.assert_allclose(surface.values["tension_force"] / surface.values["mean_curvature"], -2e-3, rtol=0.02)
            held = float(metrics["tension"]) - 1e-3
            np.testing.assert_allclose(surface.values["area_force"] / surface.values["mean_curvature"], -2 * held, rtol=0.02)
        sphere = found[0][0].values
        self.assertAlmostEqual(sphere["mean_curvature"].mean(), 1 / 8, delta=0.003)
        self.assertAlmostEqual(sphere["gaussian_curvature"].mean(), 1 / 64, delta=0.001)

    def test_across_faces_that_slide(self):
        flow = '[flow.shear]\nrate = 1e-3\nvelocity = "x"\ngradient = "z"\nwith = "lees-edwards"\n'
        case = HEAD + vesicle([16, 16, 1], 8) + flow + TAIL
        found = self.surfaces(case, 1, "--set", "lattice.size=[36, 32, 36]", "--steps", 40)
        for surface, metrics in found:
            self.check_law(surface, metrics)


if __name__ == "__main__":
    unittest.main()
