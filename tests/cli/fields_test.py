"""Fields as the case asks for them: a slice, every n-th cell, means over time, any compression; read by h5py and VTK."""

import unittest

import h5py
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOHDF import vtkHDFReader

from tests.cli.program_test import SMALL, Program

CASE = SMALL.replace("steps = 40", "steps = 6").replace("radius = 8", "radius = 8\nbuoyancy = [1e-5, 0, 0]")
UNITS = CASE.replace("kinematic_viscosity = 0.1666667", 'kinematic_viscosity = "1e-6 m^2/s"\nrelaxation_time = 1.0') \
    + '[units]\ncell = "0.5 um"\ndensity = "1000 kg/m^3"\n'


class Fields(Program):
    def fields(self, target, case=CASE, **output):
        """What a run of these [output.fields] leaves: by step, name and array."""
        self.case.write_text(case)
        keys = {"every": 3, "names": '["phase", "velocity"]', **output}
        changes = [word for key, value in keys.items() for word in ("--set", f"output.fields.{key}={value}")]
        status, _, errors = self.vesica("run", self.case, "-o", target, "--threads", 1, *changes)
        self.assertEqual(status, 0, errors)
        with h5py.File(self.directory / target / "fields.h5") as series:
            return {int(name[5:]): {field: step[field][...] for field in ("phase", "velocity")}
                    for name, step in series.items()}

    def test_a_slice_and_every_nth_cell_are_those_of_the_whole(self):
        whole = self.fields("whole")
        self.assertEqual(list(whole), [0, 3, 6])
        parts = {"slice": ({"region": "[[0, 15, 0], [32, 16, 32]]"}, np.s_[:, 15:16, :]),
                 "stride": ({"stride": 5}, np.s_[::5, ::5, ::5]),
                 "both": ({"stride": 3, "region": "[[2, 0, 9], [31, 32, 10]]", "compression": 0}, np.s_[9:10, ::3, 2:31:3])}
        for name, (keys, where) in parts.items():
            found = self.fields(name, **keys)
            for step, fields in whole.items():
                for field, values in fields.items():
                    np.testing.assert_array_equal(found[step][field], values[where], f"{name} {step} {field}")

    def test_compression_changes_no_value_and_saves_space(self):
        plain = self.fields("plain", compression=0)
        sizes = {0: self.size("plain")}
        for level in (1, 9):
            packed = self.fields(f"level{level}", compression=level)
            for step, fields in plain.items():
                for field, values in fields.items():
                    np.testing.assert_array_equal(packed[step][field], values)
            sizes[level] = self.size(f"level{level}")
        self.assertLess(sizes[1], 0.8 * sizes[0])
        self.assertLessEqual(sizes[9], sizes[1])

    def size(self, target):
        return (self.directory / target / "fields/step_000000006.h5").stat().st_size

    def test_a_time_average_is_the_mean_of_what_was_since_the_last_output(self):
        each = self.fields("each", every=1)
        mean = self.fields("mean", every=3, average="true")
        for field in ("phase", "velocity"):
            np.testing.assert_array_equal(mean[0][field], each[0][field])
            for step in (3, 6):
                expected = np.mean([each[k][field].astype(float) for k in range(step - 2, step + 1)], axis=0)
                np.testing.assert_allclose(mean[step][field], expected, rtol=3e-7, atol=1e-12)
        self.assertGreater(np.abs(mean[6]["velocity"] - each[6]["velocity"]).max(), 1e-9)

    def test_vtk_finds_the_samples_at_the_centres_of_their_cells_in_metres(self):
        self.fields("si", case=UNITS, stride=4, region="[[8, 4, 0], [24, 32, 30]]")
        path = self.directory / "si/fields/step_000000003.h5"
        reader = vtkHDFReader()
        self.assertTrue(reader.CanReadFile(str(path)))
        reader.SetFileName(str(path))
        reader.Update()
        image = reader.GetOutputDataObject(0)
        cell = 0.5e-6
        np.testing.assert_allclose(image.GetSpacing(), [4 * cell] * 3)
        np.testing.assert_allclose(image.GetOrigin(), np.array([8.5, 4.5, 0.5]) * cell)
        self.assertEqual(image.GetDimensions(), (4, 7, 8))
        with h5py.File(path) as stored:
            self.assertAlmostEqual(stored.attrs["time"][0], 3 * (1 / 6) * cell**2 / 1e-6, delta=1e-18)
            self.assertEqual(stored["velocity"].attrs["unit"], b"m/s")
            for name in ("phase", "velocity"):
                values = vtk_to_numpy(image.GetPointData().GetArray(name))
                np.testing.assert_array_equal(values.reshape(stored[name].shape), stored[name][...])


if __name__ == "__main__":
    unittest.main()
