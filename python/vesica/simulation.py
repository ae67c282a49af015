"""A run in memory, at your pace."""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import NamedTuple

import numpy

from vesica.arguments import count, thread_count
from vesica.case import Case
from vesica.compiled import part
from vesica.errors import InputError
from vesica.surface import Surface


class VesicleSample(NamedTuple):
    """A row of metrics.csv: one vesicle at one step, lattice units, angles in degrees; nan for what does not exist."""

    step: float
    time: float
    vesicle: float
    area: float
    area_ratio: float
    volume: float
    reduced_volume: float
    bending_energy: float
    mean_curvature_integral: float
    gaussian_curvature_over_pi: float
    inertia_1: float
    inertia_2: float
    inertia_3: float
    x: float
    y: float
    z: float
    vx: float
    vy: float
    vz: float
    deformation_index: float
    taylor_deformation: float
    inclination: float
    tension: float
    max_speed: float
    mass_drift: float
    gap: float
    tank_treading_frequency: float
    particle_stress: float
    effective_viscosity: float
    wall_stress: float


class Sample(NamedTuple):
    """All vesicles at one step."""

    step: int
    vesicles: tuple[VesicleSample, ...]


class Simulation:
    """A case in memory. Its steps and samples are those of ``vesica run``, bit for bit: it measures on the case's own
    schedule whatever else you ask for.

    threads: of each process; by default OMP_NUM_THREADS or all processors. Results do not depend on it.
    ranks: under mpirun or srun all processes share the box, and from here on the script goes on in the first one alone,
    while the others serve it and end with it. ranks=1: this process alone, each its own simulation.

    Raises InputError if the case cannot serve."""

    def __init__(self, case: Case, threads: int | None = None, *, ranks: int | None = None,
                 accept_soft_membranes: bool = False) -> None:
        self._run = part.Simulation(case._found, thread_count(threads), _alone(ranks), accept_soft_membranes)
        self._case = case.changed({})

    @classmethod
    def resume(cls, path: str | os.PathLike[str], threads: int | None = None, *, ranks: int | None = None) -> Simulation:
        """Goes on from a checkpoint, or from the newest intact one of a run's directory, bit for bit."""
        simulation = cls.__new__(cls)
        simulation._run = part.Simulation.resume(os.fspath(path), thread_count(threads), _alone(ranks))
        simulation._case = Case.from_text(simulation._run.case.resolved, name=simulation._run.case.source_file)
        return simulation

    @property
    def step(self) -> int:
        """Steps done."""
        return int(self._run.step)

    @property
    def case(self) -> Case:
        """A copy of the case it was made of; what becomes of either changes nothing here."""
        return self._case.changed({})

    @property
    def threads(self) -> int:
        return int(self._run.threads)

    @property
    def ranks(self) -> int:
        """Processes that share the box."""
        return int(self._run.ranks)

    @property
    def shape(self) -> tuple[int, int, int]:
        """(nz, ny, nx), the cells of the box and the shape of its fields."""
        x, y, z = self._case["lattice.size"]
        return z, y, x

    def run(self, steps: int | None = None, every: int | None = None) -> Steps:
        """Does so many steps more, and gives a sample at every step that is a multiple of ``every`` and after the last.
        An iterator with a length, for tqdm. Nothing happens but while you iterate.

        steps: by default as far as the case goes, or until its stop_when_steady is met.
        every: by default the interval of the case's metrics, or all the steps.

        Ctrl-C raises KeyboardInterrupt between two steps; the simulation can go on afterwards, with the same iterator or
        another. RunError if the run becomes unstable."""
        last = max(self._run.case.steps, self.step) if steps is None else self.step + count("steps", steps, 0)
        if every is None:
            every = self._run.case.metrics_every or max(1, last - self.step)
        return Steps(self, last, count("every", every, 1), until_steady=steps is None)

    def advance(self, steps: int = 1) -> None:
        """Does so many steps without a sample. Ctrl-C and RunError as for run()."""
        self._run.advance(count("steps", steps, 0))

    def sample(self) -> Sample:
        """The metrics of the present state."""
        return Sample(self.step, tuple(VesicleSample(*row) for row in self._run.sample()))

    @property
    def is_steady(self) -> bool:
        """Whether the case's stop_when_steady is met."""
        return bool(self._run.is_steady)

    def field(self, name: str) -> numpy.ndarray:
        """A field of the whole box, computed now: (nz, ny, nx), vectors (nz, ny, nx, 3), float64. The array is yours; the
        simulation keeps its state in place in tiles of its own and in no such array. Names: density, phase, velocity,
        pressure, force, normal, mean_curvature, gaussian_curvature, bending_force, tension_force, area_force. What
        exists near the membrane only is 0 elsewhere."""
        known = part.field_names()
        if name not in known:
            raise InputError(f"field is {name!r}; expected one of {', '.join(known)}")
        return self._run.field(name)

    def phase(self) -> numpy.ndarray:
        """(nz, ny, nx): phi, 1 inside of vesicles and -1 outside."""
        return self.field("phase")

    def density(self) -> numpy.ndarray:
        """(nz, ny, nx): of the fluid."""
        return self.field("density")

    def velocity(self) -> numpy.ndarray:
        """(nz, ny, nx, 3): of the fluid, cells per step."""
        return self.field("velocity")

    def pressure(self) -> numpy.ndarray:
        """(nz, ny, nx): the difference from that at rest, density cells^2/step^2."""
        return self.field("pressure")

    def force(self) -> numpy.ndarray:
        """(nz, ny, nx, 3): of the membranes on the fluid, per volume."""
        return self.field("force")

    def mean_curvature(self) -> numpy.ndarray:
        """(nz, ny, nx): H of the membrane near it, 1/cells, positive on a sphere."""
        return self.field("mean_curvature")

    def gaussian_curvature(self) -> numpy.ndarray:
        """(nz, ny, nx): K of the membrane near it, 1/cells^2."""
        return self.field("gaussian_curvature")

    def velocity_at(self, points: numpy.ndarray) -> numpy.ndarray:
        """(n, 3): velocities at points (n, 3) in cells, in the box or any of its images; nan where there is no fluid."""
        return self._run.velocities(points)

    def surface(self, vesicle: int = 0) -> Surface:
        """The surface of a vesicle in cells, with curvatures, forces and velocity on its points."""
        return Surface(*self._run.surface(vesicle))

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes a checkpoint, whole or not at all: byte for byte the file that ``vesica run`` would have written at this
        step, but for two things that a simulation in memory does not have and leaves out. These are the sums of an average
        of fields that is under way ([output.fields] average), and the tracers of a case with [tracers].

        ``Simulation.resume`` misses neither. ``vesica resume`` in a directory with such a checkpoint begins the average anew,
        and refuses a case with tracers; that can start from the file by [initial] checkpoint."""
        self._run.save(os.fspath(path))

    def __repr__(self) -> str:
        z, y, x = self.shape
        return f"<vesica.Simulation {x} x {y} x {z} cells, step {self.step}>"


class Steps(Iterator[Sample]):
    """Samples of a simulation that steps while you iterate."""

    def __init__(self, simulation: Simulation, last: int, every: int, until_steady: bool) -> None:
        self._simulation, self._last, self._every, self._until_steady = simulation, last, every, until_steady
        self._length = last // every - simulation.step // every + (1 if last % every and last > simulation.step else 0)
        self._ended = False

    def __len__(self) -> int:
        """Samples from the first to the last; fewer where the case ends in a steady state."""
        return self._length

    def __next__(self) -> Sample:
        step = self._simulation.step
        if self._ended or step >= self._last:
            raise StopIteration
        self._simulation.advance(min((step // self._every + 1) * self._every, self._last) - step)
        self._ended = self._until_steady and self._simulation.is_steady
        return self._simulation.sample()


def _alone(ranks: int | None) -> bool:
    if ranks not in (None, 1):
        raise InputError(f"ranks is {ranks!r}; expected None for all that the launcher has started, or 1; "
                         "try `mpirun -n N python3 ...`")
    return ranks == 1
