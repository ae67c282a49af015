#!/usr/bin/python3
"""Vesicles move across a flow: to the middle of a channel, and away from a wall."""

import math
import sys
from pathlib import Path

import numpy
from scipy.integrate import solve_ivp
from scipy.optimize import least_squares

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))

from validation.in_flow import drift_of_end, greatest_rate, middle_of, steps_of_strain
from validation.item import Item
from validation.simulations import Simulation

HERE = Path(__file__).parent
RADIUS, NU = 10.0, 0.5
CHANNEL = (60, 40, 50)
OFFSET = 9.0
CHANNEL_STRAIN = 40.0  # at the wall
LIFT_BOX = (80, 64, 96)
LIFT_STRAIN = 20.0
SETTLED = 3.0  # strain after which the shape has found its own


def channel():
    wall_rate = greatest_rate(RADIUS, NU)
    return Simulation("channel", HERE / "channel.toml", {
        "lattice.size": list(CHANNEL), "vesicle[0].centre": [*middle_of(CHANNEL)[:2], CHANNEL[2] / 2 - OFFSET],
        "vesicle[0].radius": RADIUS, "flow.poiseuille.mean_velocity": float(f"{wall_rate * CHANNEL[2] / 6:.3g}"),
        "run.steps": steps_of_strain(CHANNEL_STRAIN, wall_rate),
    })  # fmt: skip


def lift(box=LIFT_BOX, radius=RADIUS, height=1.6, strain=LIFT_STRAIN):
    rate = greatest_rate(radius, NU)
    return Simulation("wall", HERE / "wall.toml", {
        "lattice.size": list(box), "vesicle[0].centre": [*middle_of(box)[:2], height * radius],
        "vesicle[0].radius": radius, "flow.shear.rate": rate, "run.steps": steps_of_strain(strain, rate, 250),
    })  # fmt: skip


def lift_law(strain, heights, gap):
    """(exponent n, factor U, r.m.s. in R) of dh/dstrain = U [h^-n - (gap - h)^-n], lengths in R0: either wall pushes."""

    def trajectory(start, factor, exponent):
        def speed(_, h):
            return factor * (h**-exponent - (gap - h) ** -exponent)

        return solve_ivp(speed, (strain[0], strain[-1]), [start], t_eval=strain, rtol=1e-8, atol=1e-10).y[0]

    def fit(free):
        def misses(x):
            return trajectory(x[0], x[1], x[2] if free else 2.0) - heights

        guess = [heights[0], 0.1, 2.0] if free else [heights[0], 0.1]
        return least_squares(misses, guess, bounds=([0.5, 0.0, 0.0][: len(guess)], [5.0, 10.0, 8.0][: len(guess)]))

    free, square = fit(True), fit(False)
    return (float(free.x[2]), float(free.x[1]), math.sqrt(2 * free.cost / len(heights)),
            float(square.x[1]), math.sqrt(2 * square.cost / len(heights)))  # fmt: skip


def judge_lift(item, run):
    rate = greatest_rate(RADIUS, NU)
    if run.failure is not None:
        return
    strain, heights = run.metrics["step"] * rate, run.metrics["z"] / RADIUS
    settled = strain >= SETTLED
    exponent, factor, rms, square_factor, square_rms = lift_law(strain[settled], heights[settled], LIFT_BOX[2] / RADIUS)
    conditions = f"h from {heights[settled][0]:.2f} to {heights[-1]:.2f} R0"
    item.results.absolute("exponent n of the lift U ~ h^-n", conditions, exponent, 2.0, 0.5)
    item.results.at_least("rise of the height between samples, cells", conditions,
                          float(numpy.diff(heights[settled]).min()) * RADIUS, 0.0)  # fmt: skip
    item.results.report("U h^n/(rate R0^(n+1)) with that exponent", conditions, factor)
    item.results.report("U h^2/(rate R0^3), the exponent being 2", conditions, square_factor)
    item.results.report("r.m.s. distance of the heights from the law, R0: exponent free", conditions, rms)
    item.results.report("r.m.s. distance of the heights from the law, R0: exponent 2", conditions, square_rms)
    rows = []
    for place in numpy.linspace(SETTLED, strain[-1] - 1.0, 8):
        window = (strain >= place) & (strain <= place + 1.0)
        slope = float(numpy.polyfit(strain[window], heights[window], 1)[0])
        height = float(heights[window].mean())
        rows.append((height, float(run.metrics["gap"][window].mean()) / RADIUS, slope, slope * height**2,
                     float(run.metrics["inclination"][window].mean())))  # fmt: skip
    item.results.table("Lift from a wall: speed against distance", (
        "h/R0", "gap/R0", "U/(rate R0)", "U h^2/(rate R0^3)", "inclination"), rows)  # fmt: skip


def judge_channel(item, run):
    if run.failure is not None:
        return
    steps, offset = run.metrics["step"], CHANNEL[2] / 2 - run.metrics["z"]
    wall_rate = greatest_rate(RADIUS, NU)
    strain = steps * wall_rate
    settled = strain >= SETTLED
    conditions = f"equal viscosities, from {OFFSET / RADIUS:g} R0 off the middle, walls {CHANNEL[2] / RADIUS:g} R0 apart"
    item.results.at_most("distance from the middle at the end over that at the start", conditions,
                         float(offset[-1] / offset[settled][0]), 0.5)  # fmt: skip
    item.results.at_most("overshoot beyond the middle, R0", conditions, float(max(0.0, -offset.min())) / RADIUS, 0.02)
    speed = drift_of_end(run, "z", steps_of_strain(2.0, wall_rate)) / (2.0 * RADIUS)
    item.results.report("speed towards the middle at the end over (rate at the wall) R0", conditions, speed)
    rows = [(float(strain[k]), float(offset[k]) / RADIUS, float(run.metrics["inclination"][k]))
            for k in numpy.linspace(0, len(steps) - 1, 9).astype(int)]  # fmt: skip
    item.results.table("Off the middle of a channel", ("strain at the wall", "distance/R0", "inclination"), rows)


def main():
    item = Item(__file__, "Migration")
    if item.quick:
        run = item.run([lift((40, 24, 40), 8.5, 1.8, 0.8)])["wall"]
        item.results.at_least("a vesicle beside a wall rises, cells", "strain 0.8", run.last("z") - run.at(0, "z"), 0.0)
        item.finish()
    finished = item.run([lift(), channel()])
    judge_lift(item, finished["wall"])
    judge_channel(item, finished["channel"])
    item.finish()


if __name__ == "__main__":
    main()
