"""What a simulation in memory gives: arrays, surfaces, samples on demand; and how it is interrupted."""

import io
import os
import signal
import sys
import threading
import time
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

import numpy  # noqa: E402
import vesica  # noqa: E402
from small_runs import RELAXING, Scratch  # noqa: E402
from tqdm import tqdm  # noqa: E402


class Simulations(Scratch):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.case = vesica.Case.from_text(RELAXING)
        cls.simulation = vesica.Simulation(cls.case, threads=1)

    def test_fields_have_the_shape_of_the_box_and_belong_together(self):
        simulation = self.simulation
        self.assertEqual(simulation.shape, (28, 24, 24))
        for field, width in ((simulation.phase(), ()), (simulation.density(), ()), (simulation.pressure(), ()),
                             (simulation.velocity(), (3,)), (simulation.force(), (3,)), (simulation.mean_curvature(), ()),
                             (simulation.gaussian_curvature(), ())):
            self.assertEqual((field.shape, field.dtype), ((28, 24, 24, *width), numpy.float64))
            self.assertTrue(field.flags.c_contiguous and field.flags.writeable)
        volume = 0.5 * (1.0 + simulation.phase()).sum()
        self.assertAlmostEqual(volume, 4 / 3 * numpy.pi * 7**3, delta=0.15 * volume)  # a curved layer leans outwards
        numpy.testing.assert_allclose(simulation.pressure(), (simulation.density() - 1.0) / 3.0, atol=1e-15)
        z = numpy.arange(28) + 0.5  # the prolate stands along z
        spread = (simulation.phase().clip(0, 1).sum(axis=(1, 2)) * (z - 14.0) ** 2).sum()
        x = numpy.arange(24) + 0.5
        self.assertGreater(spread, 1.5 * (simulation.phase().clip(0, 1).sum(axis=(0, 1)) * (x - 12.0) ** 2).sum())
        with self.assertRaisesRegex(vesica.InputError, "field is 'vorticity'; expected one of .*velocity"):
            simulation.field("vorticity")

    def test_what_becomes_of_its_case_afterwards_changes_nothing(self):
        case = self.case.changed({})
        simulation = vesica.Simulation(case, threads=1)
        shape, words = simulation.shape, repr(simulation)
        larger = {"lattice.size": [40, 40, 40], "vesicle[0].centre": [20, 20, 20]}
        case.update(larger)
        simulation.case.update(larger)
        self.assertEqual((simulation.shape, repr(simulation)), (shape, words))
        self.assertEqual(simulation.case["lattice.size"], [24, 24, 28])
        self.assertEqual(simulation.phase().shape, shape)

    def test_arrays_outlive_the_simulation_and_are_not_copied(self):
        simulation = vesica.Simulation(self.case, threads=1)
        phase = simulation.phase()
        self.assertIsNotNone(phase.base)  # the vector it was computed into
        before = phase.copy()
        simulation.advance(2)
        del simulation
        numpy.testing.assert_array_equal(phase, before)

    def test_velocities_between_cells_are_between_those_of_the_cells(self):
        self.simulation.advance(1)
        velocity = self.simulation.velocity()
        cells = numpy.array([[5, 6, 7], [23, 0, 27], [12, 12, 14]])
        found = self.simulation.velocity_at(cells + 0.5)
        numpy.testing.assert_allclose(found, [velocity[z, y, x] for x, y, z in cells], atol=1e-15)
        images = self.simulation.velocity_at(cells + 0.5 + [24, -48, 28])
        numpy.testing.assert_allclose(images, found, atol=1e-15)
        middle = self.simulation.velocity_at(numpy.array([[6.0, 6.5, 7.5]]))
        numpy.testing.assert_allclose(middle[0], 0.5 * (velocity[7, 6, 5] + velocity[7, 6, 6]), atol=1e-15)
        for wrong in (numpy.zeros(3), numpy.zeros((2, 2)), [[numpy.nan, 0.0, 0.0]]):
            with self.assertRaises(vesica.InputError):
                self.simulation.velocity_at(wrong)

    def test_the_surface_is_closed_and_its_curvatures_are_those_of_a_prolate(self):
        surface = self.simulation.surface()
        self.assertEqual((surface.points.shape[1], surface.triangles.shape[1]), (3, 3))
        self.assertEqual(surface.H.shape, (len(surface.points),))
        self.assertEqual(surface.fields["velocity"].shape, (len(surface.points), 3))
        self.assertAlmostEqual(surface.volume(), self.simulation.sample().vesicles[0].volume, delta=0.05 * surface.volume())
        numpy.testing.assert_allclose(surface.centre(), [12, 12, 14], atol=0.01)
        total = (surface.K * surface.point_areas()).sum()
        self.assertAlmostEqual(total / (4 * numpy.pi), 1.0, delta=0.05)  # Gauss and Bonnet
        with self.assertRaisesRegex(vesica.InputError, "vesicle is 1; expected a whole number from 0 to 0"):
            self.simulation.surface(1)

    def test_samples_have_a_length_and_come_when_they_were_asked_for(self):
        simulation = vesica.Simulation(self.case, threads=1)
        steps = simulation.run(steps=5, every=2)
        self.assertEqual((len(steps), simulation.step), (3, 0))  # nothing happens before
        bar = tqdm(steps, file=io.StringIO())
        self.assertEqual([sample.step for sample in bar], [2, 4, 5])
        self.assertEqual((bar.total, len(steps)), (3, 3))
        self.assertEqual([sample.step for sample in simulation.run(steps=1, every=100)], [6])
        off_beat = simulation.run(steps=3, every=4)  # counted from step 0, as the program's are
        self.assertEqual((len(off_beat), [sample.step for sample in off_beat]), (2, [8, 9]))
        self.assertEqual(len(simulation.run(steps=0)), 0)
        self.assertEqual([sample.step for sample in simulation.run()], [12, 18, 24])  # as the case says
        self.assertEqual(list(simulation.run()), [])
        for wrong in (-1, 1.5, "10", True):
            with self.assertRaisesRegex(vesica.InputError, "steps is .*; expected a whole number of at least 0"):
                simulation.run(steps=wrong)

    def test_a_steady_state_ends_a_run_that_may_end(self):
        case = self.case.changed({"run.stop_when_steady": {"quantity": "volume", "relative_change": 1.0, "over": 6}})
        simulation = vesica.Simulation(case, threads=1)
        self.assertEqual([sample.step for sample in simulation.run()], [6])
        self.assertTrue(simulation.is_steady)
        self.assertEqual([sample.step for sample in simulation.run(steps=3)], [9])

    def test_ctrl_c_is_heeded_between_steps_and_the_simulation_goes_on(self):
        unbroken = vesica.Simulation(self.case, threads=1)
        simulation = vesica.Simulation(self.case, threads=1)
        steps = simulation.run(steps=100_000, every=100_000)
        threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT)).start()
        begin = time.monotonic()
        with self.assertRaises(KeyboardInterrupt):
            next(steps)
        self.assertLess(time.monotonic() - begin, 30)
        done = simulation.step
        self.assertTrue(0 < done < 100_000)
        simulation.advance(2)
        unbroken.advance(done + 2)
        numpy.testing.assert_array_equal(simulation.velocity(), unbroken.velocity())

    def test_other_threads_run_python_meanwhile_and_may_not_disturb(self):
        simulation = vesica.Simulation(self.case, threads=1)
        stepping = threading.Thread(target=simulation.advance, args=(150,))
        stepping.start()
        counted, refused = 0, 0
        while stepping.is_alive():
            counted += 1
            time.sleep(0.001)
            try:
                simulation.sample()
            except vesica.RunError as busy:
                self.assertIn("at work in another thread", str(busy))
                refused += 1
        stepping.join()
        self.assertGreater(counted, 10)
        self.assertGreater(refused, 0)
        self.assertGreaterEqual(simulation.step, 150)

    def test_an_unstable_run_fails_with_the_programs_words(self):
        case = self.case.changed({"fluid.kinematic_viscosity": 0.002, "vesicle_type.rbc.bending.modulus": 20.0})
        with self.assertRaisesRegex(vesica.RunError, r"step \d+"):
            vesica.Simulation(case, threads=1, accept_soft_membranes=True).advance(400)

    def test_a_checkpoint_that_is_damaged_or_missing_is_refused(self):
        path = self.folder / "state.h5"
        self.simulation.save(path)
        content = bytearray(path.read_bytes())
        content[len(content) // 2] ^= 1
        path.write_bytes(content)
        with self.assertRaisesRegex(vesica.RunError, "state.h5"):
            vesica.Simulation.resume(path)
        with self.assertRaisesRegex(vesica.InputError, "there is no such file or directory"):
            vesica.Simulation.resume(self.folder / "none.h5")
        with self.assertRaises(vesica.RunError):
            self.simulation.save(self.folder / "no" / "such" / "folder.h5")


if __name__ == "__main__":
    unittest.main()
