"""What one lattice unit is worth in SI."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import pandas

# Exponents of length, time and mass.
DIMENSIONS: dict[str, tuple[int, int, int]] = {
    "time": (0, 1, 0), "length": (1, 0, 0), "velocity": (1, -1, 0), "rate": (0, -1, 0),
    "kinematic_viscosity": (2, -1, 0), "dynamic_viscosity": (-1, -1, 1), "density": (-3, 0, 1),
    "pressure": (-1, -2, 1), "stress": (-1, -2, 1), "tension": (0, -2, 1), "energy": (2, -2, 1),
    "force": (-2, -2, 1),  # the field: per volume
    "mean_curvature": (-1, 0, 0), "gaussian_curvature": (-2, 0, 0),
    "bending_force": (-1, -2, 1), "tension_force": (-1, -2, 1),  # four per membrane area
    "area_force": (-1, -2, 1), "total_force": (-1, -2, 1),
    # columns of metrics.csv; those that are not here are pure numbers
    "area": (2, 0, 0), "volume": (3, 0, 0), "mean_curvature_integral": (1, 0, 0),
    "inertia_1": (2, 0, 1), "inertia_2": (2, 0, 1), "inertia_3": (2, 0, 1),
    "x": (1, 0, 0), "y": (1, 0, 0), "z": (1, 0, 0), "vx": (1, -1, 0), "vy": (1, -1, 0), "vz": (1, -1, 0),
    "max_speed": (1, -1, 0), "gap": (1, 0, 0), "tank_treading_frequency": (0, -1, 0),
    "particle_stress": (-1, -2, 1), "wall_stress": (-1, -2, 1),
}


@dataclass(frozen=True)
class Scales:
    """The lattice's units in SI: ``cell`` in m, ``step`` in s, ``density`` in kg/m^3 of the lattice's density one."""

    cell: float
    step: float
    density: float

    def unit(self, quantity: str) -> float:
        """SI units per lattice unit of a field, a column of the metrics, or a dimension by name ("velocity", "pressure",
        "energy", ...); 1 for pure numbers."""
        length, time, mass = DIMENSIONS.get(quantity, (0, 0, 0))
        return float(self.cell**length * self.step**time * (self.density * self.cell**3) ** mass)

    def in_si(self, metrics: pandas.DataFrame) -> pandas.DataFrame:
        """A copy of a table of metrics with every column in SI (m, s, kg); angles stay in degrees."""
        return metrics.assign(**{name: metrics[name] * self.unit(name) for name in metrics.columns if name in DIMENSIONS})
