"""What Vesica writes for other programs is read by them: surfaces by VTK, fields by h5py along fields.xmf."""

import os
import pathlib
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as xml

import h5py
import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

PROGRAM = os.environ.get("VESICA_TEST_IO") or str(
    pathlib.Path(os.environ.get("VESICA_PROGRAM", "build/release/bin/vesica")).with_name("test_io"))


def numbers(element):
    return [float(word) for word in element.text.split()]


@unittest.skipUnless(os.access(PROGRAM, os.X_OK), f"{PROGRAM} is not built")
class Pictures(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.run_directory = pathlib.Path(cls.scratch.name)
        subprocess.run([PROGRAM, "[.sample]"], check=True, stdout=subprocess.DEVNULL,
                       env=os.environ | {"VESICA_SAMPLE_DIR": cls.scratch.name})

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def test_vtk_reads_the_surface_of_every_vesicle(self):
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(self.run_directory / "surfaces" / "surface_000000100.vtp"))
        reader.Update()
        self.assertEqual(reader.GetErrorCode(), 0)
        surface = reader.GetOutput()
        corner = numpy.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], dtype=float)
        points = numpy.concatenate([corner, corner + [10, 0, 0]])
        numpy.testing.assert_array_equal(vtk_to_numpy(surface.GetPoints().GetData()), points)
        triangles = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        one = numpy.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
        numpy.testing.assert_array_equal(triangles, numpy.concatenate([one, one + 4]))
        data = surface.GetPointData()
        numpy.testing.assert_array_equal(vtk_to_numpy(data.GetArray("mean_curvature")), points @ [1, 2, 3])
        numpy.testing.assert_array_equal(vtk_to_numpy(data.GetArray("velocity")), points)
        numpy.testing.assert_array_equal(vtk_to_numpy(surface.GetCellData().GetArray("vesicle")), [0] * 4 + [1] * 4)
        self.assertEqual(surface.GetFieldData().GetArray("TimeValue").GetTuple1(0), 100.0)

    def test_the_series_of_surfaces_lists_files_that_are_there(self):
        folder = self.run_directory / "surfaces"
        entries = xml.parse(folder / "surfaces.pvd").getroot().findall("./Collection/DataSet")
        self.assertEqual([float(entry.get("timestep")) for entry in entries], [0.0, 100.0])
        for entry in entries:
            self.assertTrue((folder / entry.get("file")).is_file())

    def test_fields_xmf_describes_what_its_hdf5_files_hold(self):
        series = xml.parse(self.run_directory / "fields.xmf").getroot().find("./Domain/Grid")
        self.assertEqual((series.get("GridType"), series.get("CollectionType")), ("Collection", "Temporal"))
        steps = series.findall("Grid")
        self.assertEqual([float(step.find("Time").get("Value")) for step in steps], [0.0, 25.0])
        for step in steps:
            nodes = [int(word) for word in step.find("Topology").get("Dimensions").split()]
            self.assertEqual(nodes, [5, 6, 7])  # one more than the cells; z, y, x
            origin, spacing = (numbers(item) for item in step.findall("./Geometry/DataItem"))
            self.assertEqual((origin, spacing), ([0.0, 0.5, 1.0], [0.5, 0.5, 0.5]))
            for attribute in step.findall("Attribute"):
                self.assertEqual(attribute.get("Center"), "Cell")
                item = attribute.find("DataItem")
                file, path = item.text.split(":")
                with h5py.File(self.run_directory / file) as stored:
                    values = stored[path]
                    self.assertEqual(values.dtype, numpy.float32)
                    self.assertEqual(list(values.shape), [int(word) for word in item.get("Dimensions").split()])

    def test_fields_are_found_by_z_y_x_and_component(self):
        z, y, x = numpy.meshgrid(numpy.arange(0, 4), numpy.arange(1, 6), numpy.arange(2, 8), indexing="ij")
        ramp = x + 10 * y + 100 * z
        with h5py.File(self.run_directory / "fields.h5") as index:  # links to the steps' own files
            numpy.testing.assert_array_equal(index["step_000000100/phase"], ramp)
            for component in range(3):
                numpy.testing.assert_array_equal(index["step_000000100/velocity"][..., component],
                                                 ramp + 1000 * component)


if __name__ == "__main__":
    unittest.main()
