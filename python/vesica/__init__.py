"""Vesicles in viscous flow: state a case, run it step by step or into a directory, and look at what it left.

Lattice units everywhere unless something says SI: lengths in cells, times in steps, masses such that the fluid's density
is what the case says. Fields are numpy arrays of shape (nz, ny, nx), vectors (nz, ny, nx, 3) with components x, y, z; cell
i spans [i, i + 1), so that its centre is i + 0.5.

    case = vesica.Case("cases/discocyte.toml")
    case["fluid.kinematic_viscosity"] = 0.2
    for sample in vesica.Simulation(case).run(steps=1000, every=100):
        print(sample.vesicles[0].reduced_volume)
    run = vesica.Run("out/discocyte")
    run.metrics, run.plot("profile"), run.render()
"""

from typing import TYPE_CHECKING

from vesica.errors import InputError, RunError, Unavailable
from vesica.scales import Scales
from vesica.surface import Surface

if TYPE_CHECKING:
    from vesica.case import Case, Plan
    from vesica.directory import Fields, Run
    from vesica.launch import resume, run
    from vesica.simulation import Sample, Simulation, Steps, VesicleSample

# What needs the compiled part, or pandas, is imported when it is asked for: pictures of a run need neither.
_WHERE = {
    "Case": "case", "Plan": "case", "Fields": "directory", "Run": "directory", "resume": "launch", "run": "launch",
    "Sample": "simulation", "Simulation": "simulation", "Steps": "simulation", "VesicleSample": "simulation",
}
__all__ = ["InputError", "RunError", "Scales", "Surface", "Unavailable", "__version__", *sorted(_WHERE)]


def __getattr__(name: str) -> object:
    from importlib import import_module

    if name == "__version__":
        return import_module("vesica.compiled").part.version
    if name not in _WHERE:
        raise AttributeError(f"module 'vesica' has no attribute {name!r}")
    found = getattr(import_module(f"vesica.{_WHERE[name]}"), name)
    globals()[name] = found
    return found


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
