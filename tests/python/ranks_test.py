"""Under mpirun a script shares the box among its ranks, with and without mpi4py, with the same bits as alone."""

import subprocess
import sys
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "cli")]

import vesica  # noqa: E402
from ranks import environment, mpirun  # noqa: E402
from small_runs import RELAXING, Scratch  # noqa: E402

SHARED = """
import sys, vesica
simulation = vesica.Simulation(vesica.Case("case.toml"), threads=1)
last = list(simulation.run(steps=12))[-1]
print(simulation.ranks, "ranks,", repr(last.vesicles[0].bending_energy), simulation.phase().sum())
simulation.save(sys.argv[1])
try:
    vesica.Simulation(vesica.Case("case.toml"))
except vesica.RunError as refused:
    print(refused)
del simulation
run = vesica.run(vesica.Case("case.toml"), sys.argv[1] + "-run", steps=6, threads=1)
print(run.metrics.bending_energy.iloc[0])
"""


class Ranks(Scratch):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        (cls.folder / "case.toml").write_text(RELAXING, encoding="utf-8")
        alone = vesica.Simulation(vesica.Case(cls.folder / "case.toml"), threads=1)
        cls.last = list(alone.run(steps=12))[-1]
        alone.save(cls.folder / "alone.h5")

    def launch(self, code, *arguments):
        return subprocess.run([*mpirun(2), sys.executable, "-c", code, *arguments], capture_output=True, text=True,
                              timeout=300, check=False, cwd=self.folder, env=environment())

    def test_two_ranks_give_the_same_bits_and_one_voice(self):
        done = self.launch(SHARED, "two.h5")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stdout.count("2 ranks, " + repr(self.last.vesicles[0].bending_energy)), 1, done.stdout)
        self.assertEqual((self.folder / "two.h5").read_bytes(), (self.folder / "alone.h5").read_bytes())
        self.assertIn("one simulation at a time", done.stdout)

    def test_beside_mpi4py_the_ranks_may_be_shared_or_each_its_own(self):
        try:
            import mpi4py  # noqa: F401
        except ImportError:
            self.skipTest("no mpi4py")
        code = ("from mpi4py import MPI\nimport vesica\nrank = MPI.COMM_WORLD.rank\n"
                "case = vesica.Case('case.toml', {'fluid.kinematic_viscosity': (0.2, 0.3)[rank]})\n"
                "own = vesica.Simulation(case, threads=1, ranks=1)\nown.advance(3)\n"
                "found = MPI.COMM_WORLD.gather((own.ranks, own.step), root=0)\n"
                "if rank == 0: print('each its own', found)\n" + SHARED)
        done = self.launch(code, "mpi4py.h5")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("each its own [(1, 3), (1, 3)]", done.stdout)
        self.assertEqual((self.folder / "mpi4py.h5").read_bytes(), (self.folder / "alone.h5").read_bytes())

    def test_an_error_of_the_script_ends_all_ranks(self):
        done = self.launch("import vesica\nsimulation = vesica.Simulation(vesica.Case('case.toml'), threads=1)\n"
                           "simulation.advance(1)\nraise SystemExit('enough')")
        self.assertNotEqual(done.returncode, 0)
        self.assertEqual(done.stderr.count("enough"), 1, done.stderr)


if __name__ == "__main__":
    unittest.main()
