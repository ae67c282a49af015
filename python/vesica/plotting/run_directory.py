"""What a finished run left behind: metrics, parameters, surfaces."""

import csv
import json
import math
import re
import tomllib
import xml.etree.ElementTree as xml
from functools import cached_property
from pathlib import Path

import numpy

from vesica.errors import InputError, Unavailable

REQUIRED = ("step", "vesicle", "area_ratio", "volume", "reduced_volume", "bending_energy", "mass_drift")


class RunDirectory:
    """Reads the parameters and the summary at once and everything else when asked. InputError where it is no run's."""

    def __init__(self, path):
        self.path = Path(path)
        if not self.path.is_dir():
            raise InputError(f"{self.path}: is no directory; expected the directory of a finished run")
        if not any((self.path / name).is_file() for name in ("metrics.csv", "resolved.toml")):
            raise InputError(f"{self.path / 'metrics.csv'}: not found; expected the directory of a run")
        self.resolved = _read_optional(self.path / "resolved.toml", lambda p: tomllib.loads(p.read_text("utf-8")))
        self.summary = _read_optional(self.path / "summary.json", lambda p: json.loads(p.read_text("utf-8")))

    @property
    def title(self):
        title = self.resolved.get("title")
        return title if isinstance(title, str) and title else self.path.resolve().name

    @cached_property
    def _metrics(self):
        return _read_metrics(self.path / "metrics.csv")

    def vesicles(self):
        """Indices of the vesicles in the metrics, ascending."""
        return sorted({int(v) for v in self._metrics["vesicle"]})

    def metrics(self, vesicle):
        """Column name -> array over the samples of one vesicle, in lattice units, ascending in step."""
        chosen = self._metrics["vesicle"] == vesicle
        if not chosen.any():
            known = ", ".join(str(v) for v in self.vesicles())
            raise InputError(f"{self.path / 'metrics.csv'}: has no vesicle {vesicle}; it has {known}")
        order = numpy.argsort(self._metrics["step"][chosen], kind="stable")
        return {name: values[chosen][order] for name, values in self._metrics.items()}

    def bending_time(self, vesicle, volume):
        """tau_b = eta R0^3/kappa in steps, or None when `resolved.toml` does not give eta and kappa."""
        kind = self._vesicle_type(vesicle)
        viscosity = _lattice_value(self.resolved, "fluid", "kinematic_viscosity")
        density = _lattice_value(self.resolved, "fluid", "density")
        modulus = _lattice_value(kind, "bending", "modulus")
        if viscosity is None or not modulus or not volume > 0.0:
            return None
        return viscosity * (1.0 if density is None else density) * 3.0 * volume / (4.0 * math.pi) / modulus

    def spontaneous_curvature(self, vesicle):
        """C0 of the vesicle's type in 1/cells; 0 when nothing is said."""
        return _lattice_value(self._vesicle_type(vesicle), "bending", "spontaneous_curvature") or 0.0

    def cell_length(self):
        """Of a cell in the unit that surfaces and fields are written in: metres when the case has units, else 1."""
        scales = self.summary.get("scales")
        return float(scales["cell_m"]) if isinstance(scales, dict) else 1.0

    def density(self):
        """Of the fluid, lattice units."""
        return _lattice_value(self.resolved, "fluid", "density") or 1.0

    def shear_rate(self):
        """Of the shear that is driven, 1/steps; None without one."""
        return _lattice_value(self.resolved, "flow", "shear", "rate") or None

    def viscosity_ratio(self, vesicle):
        return _lattice_value(self._vesicle_type(vesicle), "viscosity_ratio") or 1.0

    def surfaces(self):
        """{step: path} of the surfaces. The step stands in the file's name: times in the series are in seconds when the
        case has units."""
        folder = self.path / "surfaces"
        listed = _series(folder / "surfaces.pvd") or sorted(folder.glob("*.vtp"))
        return {_number_in(path): path for path in listed}

    def fields(self):
        """{step: path} of the files of fields."""
        return {_number_in(path): path for path in (self.path / "fields").glob("step_*.h5")}

    def last_surface(self):
        """(path, step) of the newest surface; Unavailable without one."""
        found = self.surfaces()
        if not found:
            raise Unavailable(
                f"{self.path / 'surfaces'}: holds no surface; ask for some with [output] surfaces = {{ every = N }}")
        step = max(found)
        if not found[step].is_file():
            raise OSError(f"{found[step]}: is listed in the series of surfaces but is not there")
        return found[step], step

    def _vesicle_type(self, vesicle):
        vesicles = self.resolved.get("vesicle", [])
        types = self.resolved.get("vesicle_type", {})
        if not isinstance(vesicles, list) or not isinstance(types, dict):
            return {}
        if vesicle < len(vesicles) and isinstance(vesicles[vesicle], dict):
            return types.get(vesicles[vesicle].get("type"), {})
        return next(iter(types.values())) if len(types) == 1 else {}


def _read_metrics(path):
    if not path.is_file():
        raise InputError(f"{path}: not found; expected the directory of a run with [output] metrics = {{ every = N }}")
    with open(path, newline="", encoding="utf-8") as file:
        reader = csv.reader(file)
        header = [name.strip() for name in next(reader, [])]
        missing = [name for name in REQUIRED if name not in header]
        if missing:
            raise InputError(f"{path}:1: lacks the column {missing[0]}; expected a metrics file of vesica")
        rows = []
        for row in reader:
            try:
                values = [float(value) for value in row]
            except ValueError as error:
                raise InputError(f"{path}:{reader.line_num}: {error}; expected numbers or nan") from None
            if len(values) != len(header):
                raise InputError(f"{path}:{reader.line_num}: {len(values)} values; expected {len(header)}")
            rows.append(values)
    if not rows:
        raise InputError(f"{path}: holds no sample; was the run stopped before its first one?")
    return dict(zip(header, numpy.array(rows).T))


def _read_optional(path, read):
    if not path.is_file():
        return {}
    try:
        return read(path)
    except (ValueError, UnicodeDecodeError) as error:  # both decoders' errors are ValueErrors
        raise InputError(f"{path}: {error}") from None


def _lattice_value(table, *keys):
    """The number at the end of the keys, also where it stands as { lattice = ..., si = ... }."""
    for key in keys:
        table = table.get(key) if isinstance(table, dict) else None
    if isinstance(table, dict):
        table = table.get("lattice")
    return float(table) if isinstance(table, (int, float)) and not isinstance(table, bool) else None


def _series(pvd):
    if not pvd.is_file():
        return []
    try:
        return [pvd.parent / entry.get("file", "") for entry in xml.parse(pvd).getroot().iter("DataSet")]
    except xml.ParseError as error:
        raise OSError(f"{pvd}: {error}") from None


def _number_in(path):
    numbers = re.findall(r"\d+", path.stem)
    return int(numbers[-1]) if numbers else -1
