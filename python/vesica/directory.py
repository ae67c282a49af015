"""What a run left behind."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy
import pandas

from vesica.errors import InputError, RunError, Unavailable
from vesica.plotting.run_directory import RunDirectory
from vesica.plotting.surface import read_surface
from vesica.program import find_program
from vesica.scales import DIMENSIONS, Scales
from vesica.surface import Surface

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from vesica.case import Case


class Run:
    """The directory of a run, finished or still going on. Everything is read when asked for, lattice units.

        run = vesica.Run("out/discocyte")
        run.metrics["reduced_volume"].plot()

    With [units] its files are in SI; what they give here is in lattice units all the same."""

    def __init__(self, directory: str | os.PathLike[str]) -> None:
        """InputError if the directory is not that of a run."""
        self._directory = RunDirectory(directory)
        self.path: Path = self._directory.path

    @cached_property
    def metrics(self) -> pandas.DataFrame:
        """metrics.csv, a row per sample and vesicle, all columns; index: the step with one vesicle, (step, vesicle) with
        several. Lattice units, angles in degrees. ``scales.in_si(metrics)`` converts it."""
        table = pandas.read_csv(self.path / "metrics.csv", float_precision="round_trip")
        index = ["step", "vesicle"] if table["vesicle"].nunique() > 1 else ["step"]
        return table.astype({"step": int, "vesicle": int}).set_index(index, drop=False).rename_axis(
            [f"at_{name}" for name in index])

    @property
    def summary(self) -> dict[str, Any]:
        """summary.json: how the run ended, verdicts, timings, versions, scales. Unavailable before its end."""
        if not self._directory.summary:
            raise Unavailable(f"{self.path / 'summary.json'}: not found; expected that of a run that has ended")
        return self._directory.summary

    @cached_property
    def case(self) -> Case:
        """The case with every default filled in, as it was run."""
        from vesica.case import Case

        return Case(self.path / "resolved.toml")

    @property
    def scales(self) -> Scales | None:
        """What lattice units are worth in SI; None for a case without [units]."""
        return self.case.scales

    @property
    def vesicles(self) -> list[int]:
        """The vesicles' indices."""
        return self._directory.vesicles()

    @property
    def steps(self) -> list[int]:
        """Steps that have a surface."""
        return sorted(self._directory.surfaces())

    @property
    def field_steps(self) -> list[int]:
        """Steps that have fields."""
        return sorted(self._directory.fields())

    def surface(self, step: int | None = None, vesicle: int | None = None) -> Surface:
        """The surface at a step (by default the last) in cells, its fields in lattice units. One vesicle's, or all of them
        together, told apart by fields["vesicle"]."""
        path = _at(self._directory.surfaces(), step, "surface", self.path)
        surface = read_surface(path, vesicle, every=vesicle is None)
        return _in_lattice_units(surface, self.scales)

    def fields(self, step: int | None = None) -> Fields:
        """The fields at a step (by default the last), by name, lattice units."""
        return Fields(_at(self._directory.fields(), step, "field", self.path), self.scales)

    def plot(self, quantity: str | Sequence[str] = "energy", vesicle: int = 0, step: int | None = None) -> Figure:
        """A picture as a matplotlib figure; ``savefig(path)`` writes it.

        quantity: "energy" (against Helfrich's shapes), "profile" (at ``step``, against the exact shape), "area",
        "inertia", "angle", "conservation", or one or several columns of the metrics.
        Unavailable if this run has nothing to show; InputError for an unknown quantity or vesicle."""
        from vesica.plotting import pictures

        return pictures.plot(self._directory, quantity, vesicle, step)

    def render(self, step: int | None = None, colour_by: str | None = "mean_curvature", vesicle: int | None = None,
               annotated: bool = True) -> Figure | numpy.ndarray:
        """The surface at a step (by default the last), drawn by VTK without a display.

        colour_by: a field of the surface ("mean_curvature", "gaussian_curvature", "bending_force", "tension_force",
        "area_force", "total_force", "velocity" by its size), "vesicle", or None for one colour. vesicle: one alone, or all.
        annotated: a matplotlib figure with scale and colour bar; otherwise the picture alone, (height, width, 3) uint8."""
        from vesica.plotting import pictures

        surface = self.surface(step, vesicle)
        step = max(self.steps) if step is None else step
        return pictures.render(surface, f"{self._directory.title}: step {step}", colour_by, annotated)

    def report(self) -> str:
        """``vesica report``: makes one HTML file of this run; returns what the program says. RunError if it cannot."""
        program = find_program()
        done = subprocess.run([program, "report", str(self.path)], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise RunError(f"{program} report {self.path}: {done.stderr.strip() or done.stdout.strip()}")
        return done.stdout.strip()

    def __repr__(self) -> str:
        return f"<vesica.Run {self.path}>"


class Fields(Mapping[str, numpy.ndarray]):
    """Fields of one step by name: (nz, ny, nx), vectors (nz, ny, nx, 3), float32 as they are stored; near the membrane
    only ones are 0 elsewhere. ``x``, ``y``, ``z`` are the centres of the cells in cells, ``step`` the step. With a region or a
    stride in the case there are only those cells."""

    def __init__(self, path: Path, scales: Scales | None = None) -> None:
        import h5py

        self._path, self._scales, self._read = path, scales, {}
        with h5py.File(path) as file:
            self.step = int(file.attrs["step"])
            self._names = [name for name, entry in file.items() if isinstance(entry, h5py.Dataset)]
            shape = file[self._names[0]].shape[:3] if self._names else (0, 0, 0)
            cell = scales.cell if scales else 1.0
            origin = numpy.asarray(file.attrs["origin"], dtype=float)
            spacing = float(numpy.ravel(file.attrs["spacing"])[0])
        self.z, self.y, self.x = (
            (origin[axis] + spacing * (numpy.arange(count) + 0.5)) / cell for axis, count in zip((2, 1, 0), shape))

    def __getitem__(self, name: str) -> numpy.ndarray:
        import h5py

        if name not in self._names:
            raise KeyError(f"{name} is not among the fields of step {self.step}: {', '.join(self._names)}")
        if name not in self._read:
            with h5py.File(self._path) as file:
                values = file[name][...]
            if self._scales:
                values = (values / self._scales.unit(name)).astype(values.dtype)
            self._read[name] = values
        return self._read[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._names)

    def __len__(self) -> int:
        return len(self._names)


def _at(files: Mapping[int, Path], step: int | None, kind: str, run: Path) -> Path:
    if not files:
        raise Unavailable(f"{run}: holds no {kind}; ask for some with [output] {kind}s = {{ every = N }}")
    if step is None:
        return files[max(files)]
    if step not in files:
        nearest = min(files, key=lambda found: abs(found - step))
        raise InputError(f"step is {step}; expected one of the {len(files)} steps with a {kind}, "
                         f"{min(files)} to {max(files)}; try {nearest}")
    return files[step]


def _in_lattice_units(surface: Surface, scales: Scales | None) -> Surface:
    if scales is None:
        return surface
    fields = {name: values / scales.unit(name) if name in DIMENSIONS else values
              for name, values in surface.fields.items()}
    return Surface(surface.points / scales.cell, surface.triangles, fields)
