#!/usr/bin/python3
"""Speed of two drops that a force drives through a periodic box, one behind or beside the other."""

import math
import sys
from dataclasses import dataclass
from pathlib import Path

import numpy

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))

from validation import periodic_stokeslet
from validation.item import Item
from validation.pair import both, greatest_mass_drift, separation
from validation.periodic_stokeslet import PeriodicStokeslet
from validation.simulations import Simulation

SINGLE = Path(__file__).resolve().parents[1] / "settling_drop" / "drop.toml"
PAIR = Path(__file__).with_name("pair.toml")
VISCOSITY, RATIO = 0.5, 1.0
REYNOLDS = 0.03
DOWN = numpy.array([0.0, 0.0, 1.0])  # where the force points


def single_speed(radius, box):
    """Of a drop alone in a periodic cube, over F/(6 pi eta a): Hadamard and Rybczynski's, the images' share (Hasimoto 1959),
    and that of the drop's size by Faxen's law on either side of the images."""
    fraction = 4 / 3 * math.pi * (radius / box) ** 3
    return (3 + 3 * RATIO) / (2 + 3 * RATIO) - 1.7601 * fraction ** (1 / 3) + 3 * RATIO / (2 + 3 * RATIO) * fraction


def shares_of_other(radius, box, offset):
    """What a second drop at this offset adds to the speed along the force, over F/(6 pi eta a): as point forces; by the size
    of both (Faxen's law of a drop, and the potential dipole of its flow); and by the dipole that the first one's strain
    makes of the second, felt by the first again."""
    flow = PeriodicStokeslet(float(box))
    unit = 6 / 8 * radius  # from a force over 8 pi eta to one over 6 pi eta a
    points = unit * float(DOWN @ flow.velocity(offset) @ DOWN)
    size = unit * RATIO / (2 + 3 * RATIO) * radius**2 * float(DOWN @ flow.laplacian(offset) @ DOWN)
    gradient = numpy.einsum("kij,j->ki", flow.gradient(offset), DOWN)
    strain = 0.5 * (gradient + gradient.T)
    dipole = (20 * math.pi / 3) / (8 * math.pi) * radius**3 * (2 + 5 * RATIO) / (5 + 5 * RATIO) * strain
    back = unit * float(numpy.einsum("jk,kij,i->", dipole, flow.gradient(-offset), DOWN))
    return points, size, back


def points_unbounded(radius, offset):
    """The same of point forces without images: 3a/2d in line, 3a/4d side by side."""
    distance = float(numpy.linalg.norm(offset))
    return 0.75 * radius / distance * (1 + float(offset @ DOWN) ** 2 / distance**2)


@dataclass(frozen=True)
class Body:
    name: str
    direction: str  # "" for a drop alone, "z" in line with the force, "x" side by side
    distance: float  # in radii
    radius: float = 8.0
    box: int = 96

    def force(self):
        """Per volume inside, for a speed of about REYNOLDS nu/R alone."""
        speed = REYNOLDS * VISCOSITY / self.radius
        return float(f"{speed * 4.5 * VISCOSITY / self.radius**2 / single_speed(self.radius, self.box):.3g}")

    def steps(self):
        """Nine times that in which the box's slowest flow decays."""
        return 100 * math.ceil(9 * self.box**2 / (4 * math.pi**2 * VISCOSITY) / 100)

    def conditions(self):
        if not self.direction:
            return f"alone, R = {self.radius:g}, box {self.box}"
        return f"{'in line' if self.direction == 'z' else 'side by side'}, d = {self.distance:g} R"

    def simulation(self):
        middle = self.box / 2
        settings = {"lattice.size": [self.box] * 3, "fluid.kinematic_viscosity": VISCOSITY,
                    "vesicle_type.inside.viscosity_ratio": RATIO, "vesicle_type.inside.buoyancy": [0.0, 0.0, self.force()],
                    "run.steps": self.steps(), "output.checkpoint.every": self.steps() // 3}  # fmt: skip
        if not self.direction:
            settings |= {"vesicle[0].centre": [middle] * 3, "vesicle[0].radius": self.radius}
            return Simulation(self.name, SINGLE, settings)
        for k, side in enumerate((-0.5, 0.5)):
            centre = [middle] * 3
            centre["xyz".index(self.direction)] += side * self.distance * self.radius
            settings |= {f"vesicle[{k}].centre": centre, f"vesicle[{k}].radius": self.radius}
        return Simulation(self.name, PAIR, settings)


CASES = (
    Body("single", "", 0.0),
    Body("line-3", "z", 3.0),
    Body("line-4", "z", 4.0),
    Body("side-3", "x", 3.0),
    Body("side-4", "x", 4.0),
)
QUICK = (Body("single", "", 0.0, 7.0, 48), Body("line-3", "z", 3.0, 7.0, 48))


def late(samples):
    return samples["step"] >= samples["step"][-1] * 2 / 3


def speed(samples, body):
    """Of the centre over the last third, by a straight line, over F/(6 pi eta a), F being the force per volume times the
    volume there is."""
    volume = samples["volume"][late(samples)].mean()
    radius = (3 * volume / (4 * math.pi)) ** (1 / 3)
    slope = numpy.polyfit(samples["step"][late(samples)], samples["z"][late(samples)], 1)[0]
    return float(slope) / (body.force() * volume / (6 * math.pi * VISCOSITY * radius)), radius


def judge_pair(results, run, body, alone, quick):
    """A row of the table."""
    conditions = body.conditions()
    (first, radius), (second, _) = (speed(m, body) for m in both(run))
    found = 0.5 * (first + second)
    offset = numpy.array([separation(run, axis)[late(run.metrics)].mean() for axis in "xyz"])
    shares = shares_of_other(radius, body.box, offset)
    base, gain = single_speed(radius, body.box), sum(shares)
    results.absolute("speed less that of one alone, over F/(6 pi eta a)", conditions, found - alone, gain,
                     0.03 if quick else 0.01)  # fmt: skip
    results.relative("speed over that of one alone", conditions, found / alone, 1 + gain / base, 0.05 if quick else 0.03)
    unbounded = points_unbounded(radius, offset)
    results.report("gain, images taken off, beside two point forces in unbounded fluid", conditions,
                   found - alone - (shares[0] - unbounded), unbounded)  # fmt: skip
    results.report("speed of the first less that of the second, over F/(6 pi eta a)", conditions, first - second)
    distances = numpy.linalg.norm([separation(run, axis) for axis in "xyz"], axis=0)
    results.report("distance at the end over that at the start", conditions, distances[-1] / distances[0])
    results.at_most("mass drift of either, relative", conditions, greatest_mass_drift(run), 1e-10)
    across = max(float(numpy.hypot(m["x"][-1] - m["x"][0], m["y"][-1] - m["y"][0])) for m in both(run))
    if body.direction == "z":
        results.at_most("drift sideways, cells", conditions, across, 0.01)
    return (conditions, numpy.linalg.norm(offset) / radius, found, found / alone, found - alone, *shares, gain, unbounded)


def main():
    periodic_stokeslet.self_test()
    item = Item(__file__, "Two drops settle together")
    bodies = QUICK if item.quick else CASES
    finished = item.run([body.simulation() for body in bodies])
    results, single = item.results, finished["single"]
    if single.failure is None:
        alone, radius = speed(single.metrics, bodies[0])
        results.relative("speed of one alone over F/(6 pi eta a)", bodies[0].conditions(), alone,
                         single_speed(radius, bodies[0].box), 0.05 if item.quick else 0.03)  # fmt: skip
        rows = [judge_pair(results, finished[body.name], body, alone, item.quick)
                for body in bodies[1:] if finished[body.name].failure is None]  # fmt: skip
        results.table("Speed of a pair, and what theory has the other add to it: all over F/(6 pi eta a)", (
            "pair", "d/a", "measured", "over one alone", "gain", "point forces", "their size", "dipoles", "sum",
            "point forces, unbounded"), rows)  # fmt: skip
    item.finish()


if __name__ == "__main__":
    main()
