"""What a resumed run writes beside metrics and surfaces."""

import hashlib

import h5py

from tests.cli.program_test import SMALL, Program

AVERAGES = 'fields = { every = 20, names = ["velocity", "phase"], average = true, stride = 2 }\n'


def digest(array):
    """Arrays that differ should not be printed."""
    return hashlib.sha256(array[...].tobytes()).hexdigest()


class Averages(Program):
    def setUp(self):
        super().setUp()
        self.case.write_text(SMALL.replace('shape = "sphere"', 'shape = "spheroid"\naspect = 0.8') + AVERAGES)

    def fields(self, directory):
        arrays = {}
        for path in sorted((self.directory / directory / "fields").glob("step_*.h5")):
            with h5py.File(path) as file:
                file.visititems(lambda name, item, step=path.name: arrays.__setitem__((step, name), digest(item))
                                if isinstance(item, h5py.Dataset) else None)
        self.assertTrue(any("velocity" in name for _, name in arrays), arrays.keys())
        return arrays

    def test_an_average_goes_on_where_the_checkpoint_found_it(self):
        for precision in ("double", "single"):
            whole, parts = f"whole-{precision}", f"parts-{precision}"
            chosen = ["--set", f'numerics.precision="{precision}"']
            self.assertEqual(self.vesica("run", self.case, "-o", whole, *chosen)[0], 0)
            self.assertEqual(self.vesica("run", self.case, "-o", parts, "--steps", 7, *chosen)[0], 0)
            for steps in (29, 31, 40):
                status, _, errors = self.vesica("resume", parts, "--steps", steps)
                self.assertEqual(status, 0, errors)
            self.assertEqual(self.fields(parts), self.fields(whole))

    def test_a_checkpoint_holds_the_average_under_way(self):
        self.assertEqual(self.vesica("run", self.case, "-o", "target", "--steps", 7)[0], 0)
        checkpoint = self.directory / "target/checkpoints/step_000000007.h5"
        with h5py.File(checkpoint) as file:
            self.assertEqual(file["notes/average_samples"][...].tolist(), [7.0])
            self.assertEqual(file["sums/velocity"].shape, (3 * 16**3,))  # every second cell is sampled
