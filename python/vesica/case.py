"""A case: what is to be simulated."""

from __future__ import annotations

import os
import tomllib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from vesica.arguments import thread_count
from vesica.compiled import part
from vesica.scales import Scales
from vesica.toml_text import look_up, toml_text


class Case:
    """A case file with changes. Keys are those of docs/case-file.md, by paths as ``vesica run --set`` takes them.

        case = vesica.Case("cases/discocyte.toml")
        case["fluid.kinematic_viscosity"] = 0.2
        case["vesicle[0].centre"] = [32, 32, 30]
        case["vesicle_type.rbc.bending.modulus"] = "2e-19 J"     # with [units]

    Every change is checked at once; one that cannot be leaves the case as it was. InputError carries the program's text."""

    def __init__(self, file: str | os.PathLike[str], changes: Mapping[str, Any] | None = None) -> None:
        """Reads a case file (TOML) and applies ``changes``, {path: value}."""
        path = os.fspath(file)
        self._take(lambda overrides: part.Case.from_file(path, overrides), changes)

    @classmethod
    def from_text(cls, text: str, changes: Mapping[str, Any] | None = None, name: str = "case.toml") -> Case:
        """The same from a text. ``name`` stands for the file in messages; files that the case names are looked for
        beside it."""
        case = cls.__new__(cls)
        case._take(lambda overrides: part.Case.from_text(text, name, overrides), changes)
        return case

    def _take(self, read: Any, changes: Mapping[str, Any] | None) -> None:
        self._read = read
        self._overrides: dict[str, str] = {}
        self._found = read([])
        self._resolved: dict[str, Any] | None = None
        self.update(changes or {})

    def __setitem__(self, path: str, value: Any) -> None:
        """Changes one value; text with a unit ("3.9 um") where the case has [units]."""
        self.update({path: value})

    def update(self, changes: Mapping[str, Any]) -> None:
        """Changes several values at once, for those that are only right together."""
        overrides = dict(self._overrides)
        for path, value in changes.items():
            overrides.pop(path, None)
            overrides[path] = f"{path}={toml_text(value, path)}"
        if overrides == self._overrides:
            return
        self._found = self._read(list(overrides.values()))
        self._overrides, self._resolved = overrides, None

    def changed(self, changes: Mapping[str, Any]) -> Case:
        """A copy with these changes; this case stays as it is."""
        copy = Case.__new__(Case)
        copy.__dict__.update(self.__dict__)
        copy.update(changes)
        return copy

    def __getitem__(self, path: str) -> Any:
        """The value at a path in lattice units, defaults included; a table or a list where the path leads to one."""
        return look_up(self.resolved, path)

    def __contains__(self, path: object) -> bool:
        try:
            look_up(self.resolved, str(path))
        except KeyError:
            return False
        return True

    def get(self, path: str, default: Any = None) -> Any:
        """The value at a path, or ``default`` where the case has none."""
        return self[path] if path in self else default

    def __iter__(self) -> Iterator[str]:
        return iter(self.resolved)

    @property
    def resolved(self) -> dict[str, Any]:
        """The whole case as nested dictionaries, in lattice units, with every default filled in."""
        if self._resolved is None:
            self._resolved = tomllib.loads(self._found.resolved)
        return self._resolved

    @property
    def text(self) -> str:
        """The case as TOML in lattice units, every default filled in and SI values as comments."""
        return str(self._found.resolved)

    @property
    def title(self) -> str:
        return str(self._found.title)

    @property
    def steps(self) -> int:
        """The last step of the case."""
        return int(self._found.steps)

    @property
    def scales(self) -> Scales | None:
        """What lattice units are worth in SI; None without [units]."""
        return Scales(*self._found.scales) if self._found.scales else None

    def check(self, threads: int | None = None, cost: bool = False, accept_soft_membranes: bool = False) -> Plan:
        """What ``vesica check`` says: InputError with everything ``run`` would refuse, or the plan. ``cost``: takes a few
        steps to measure how long the run will take."""
        return Plan(**part.check_case(self._found, thread_count(threads), cost, accept_soft_membranes))

    def __repr__(self) -> str:
        changes = "".join(f", {change}" for change in self._overrides.values())
        return f"<vesica.Case {self._found.source_file}{changes}>"


@dataclass(frozen=True)
class Plan:
    """What can be known of a case before its first step, in lattice units. ``vesicles`` has the groups of each: radius R0,
    volume, area, target_area, reduced_volume, target_reduced_volume, resolution (beta times the smallest radius of
    curvature), viscosity_ratio, inner_relaxation_time, confinement, bending_time (steps), bending_speed, capillary_time,
    reynolds, capillary_bending, capillary_tension; None where it does not exist."""

    text: str
    warnings: list[str]
    notes: list[str]
    cells: int
    relaxation_time: float
    interface_width: float
    expected_speed: float
    mach: float
    shear_rate: float | None
    vesicles: list[dict[str, Any]]
    seconds_per_step: float | None
    bytes: float | None

    def __str__(self) -> str:
        return self.text
