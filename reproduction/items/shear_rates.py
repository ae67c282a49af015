"""Fig 7: deformation index over shear rate for a red cell's numbers, and on to eight times the highest rate."""

import numpy

from item import reason
from runs import REDUCED_VOLUME
from sheared import capillary, equatorial_diameters, mean_of_end, sheared
from shared import HelfrichShapes, read_surface, surface_files

TITLE = "Deformation index over shear rate (Fig 7)"
PAPER = ("DI from 15 to 200 1/s beside an experiment and three codes, with a band from the two diameters at rest; stable beyond eight times the highest "
         "rate. Its curve has no table; neither the experiment's points nor the codes' are at hand, so none are drawn.")  # fmt: skip
KAPPA_SI, ETA_OUT, ETA_IN, R0_SI = 2e-19, 1.2e-3, 6e-3, 2.82e-6  # J, Pa s, Pa s, m
RATES = (15.0, 50.0, 100.0, 200.0, 400.0, 1600.0)  # 1/s; the paper's end at 200
RADIUS, NU, SIZE, RATE, STRAIN = 12.0, 0.5, [68, 44, 60], 1.2e-3, 12.0
ACCURACY = (15.0, 3e-4)  # the same capillary number at a quarter of the Reynolds number


def capillary_of(rate):
    return ETA_OUT * rate * R0_SI**3 / KAPPA_SI


def run_of(rate, lattice_rate, quick):
    radius, size, strain = (9.0, [40, 28, 40], 0.5) if quick else (RADIUS, SIZE, STRAIN)
    kappa = NU * lattice_rate * radius**3 / capillary_of(rate)
    ratio = ETA_IN / ETA_OUT
    name = f"fig7-{rate:g}-{lattice_rate:g}" + ("-quick" if quick else "")
    return sheared(name, radius=radius, kappa=kappa, nu=NU, rate=lattice_rate, steps=int(strain / lattice_rate), size=size, ratio=ratio,
                   start=100, options=("--accept-soft-membranes",),
                   settings={"output.surfaces.every": 100, **({"vesicle[0].reduced_volume": 0.9} if quick else {})})  # fmt: skip


def planned(quick):
    if quick:
        return {(15.0, RATE): run_of(15.0, RATE, True), (100.0, RATE): run_of(100.0, RATE, True)}
    keys = [(rate, RATE) for rate in RATES] + [ACCURACY]
    return {key: run_of(*key, False) for key in keys}


def plan(quick):
    return list(planned(quick).values())


def judge(item, finished):
    item.choose("units", "kappa 2e-19 J, R0 2.82 um, eta 1.2 and 6 mPa s", "a red cell's; the paper fits kappa_B and sigma to the experiment and gives no units. Nothing is fitted here")
    item.choose("lattice rate", f"{RATE:g} at R = {RADIUS:g}: Re = {RATE * RADIUS**2 / NU:.2f}", "a real cell's Re is 1e-3 and no lattice affords it; kappa follows from Ca_kappa. One point at a quarter of that Re is run besides")
    item.choose("soft membranes", "accepted from 200 1/s on", "kappa there comes near .0024, the recolouring's own resistance")
    item.choose("axis", "along the vorticity", "shear 'perpendicular to the axis of symmetry'")
    rows, runs = [], planned(item.quick)
    for (rate, lattice_rate), simulation in runs.items():
        run = finished[simulation.name]
        if run.failure is not None:
            rows.append((rate, capillary_of(rate), "ended early: " + reason(run)))
            continue
        surfaces = surface_files(run)
        least, greatest = equatorial_diameters(read_surface(surfaces[0][1]))
        mean = 0.5 * (least + greatest)
        index = mean_of_end(run, "deformation_index")
        ratio = _root((1 + index) / (1 - index)) * greatest  # D_max
        low, high = (_index(ratio / d) for d in (greatest, least))
        rows.append((rate, capillary_of(rate), lattice_rate, lattice_rate * RADIUS**2 / NU, _index(ratio / mean), low, high,
                     run.last("area_ratio"), run.last("inclination"), run.last("max_speed")))  # fmt: skip
    good = [row for row in rows if len(row) > 3]
    series = [row for row in good if row[2] == RATE]
    paper, theory = item.against("paper"), item.against("theory")
    if len(series) > 1:
        rises = [b[4] - a[4] for a, b in zip(series, series[1:]) if b[0] <= 200]
        paper.at_least("least rise of DI from one rate to the next", "up to 200 1/s", float(min(rises)) if rises else float("nan"), 0.0)
        paper.at_least("highest rate that ran to its end, 1/s", "the paper's highest is 200, 'more than 8 times' it", series[-1][0], 100.0 if item.quick else 1600.0)
    for row in series:
        theory.absolute("A/A_target", f"{row[0]:g} 1/s", row[7], 1.0, 2e-3)
    slow = [row for row in good if row[2] != RATE]
    if slow and series:
        theory.absolute("DI at a quarter of the Reynolds number less DI", f"{slow[0][0]:g} 1/s", slow[0][4] - series[0][4], 0.0, 0.02)
    columns = ("shear rate, 1/s", "Ca_kappa", "rate", "Re", "DI", "DI with the greater D0", "DI with the lesser D0", "A/A_target", "inclination", "greatest speed")
    item.table("Deformation index in steady shear", columns, rows)
    item.csv("deformation.csv", columns, rows)
    limit = _longest()
    item.results.report("DI of the prolate of this v at rest: what its area can be drawn out to", "C0 = 0, exact", limit)
    item.explain("The band of the paper is the unequal diameters of its discocyte at rest; " + _band(good) +
                 f"A fluid membrane that keeps only its area has no shear elasticity. The exact prolate of this area has a DI of {limit:.3f}" + _highest(good))  # fmt: skip
    if len(good) < len(rows):
        item.explain(f"{len(rows) - len(good)} of {len(rows)} runs ended early (table). Why was not tested. "
                     f"The highest rate that ran to its end is {max((row[0] for row in good), default=0):g} 1/s; the paper claims stability beyond eight times 200. These runs have a viscosity ratio of 5 and the shear is put on at once.")  # fmt: skip
    if series:
        item.picture("deformation.png", _figure(series), "DI over shear rate; the paper's range of rates is shaded. The band is between the two diameters at rest.")


def _band(good):
    widths = [row[6] - row[5] for row in good]
    return f"here it is at most {max(widths):.4f} wide. " if widths else "no run here has one. "


def _highest(good):
    return f"; the highest in the table is {max(row[4] for row in good):.3f}." if good else "."


def _longest():
    """A prolate's length over the discocyte's diameter, of the same volume and area."""
    shapes = HelfrichShapes()
    prolate, oblate = (shapes.profile(branch, REDUCED_VOLUME) for branch in ("prolate", "oblate"))
    return _index(float(numpy.ptp(prolate.z) / (2 * oblate.r.max())))


def _root(value):
    return float(numpy.sqrt(value))


def _index(ratio):
    return (ratio**2 - 1) / (ratio**2 + 1)


def _figure(series):
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(figsize=(7.0, 4.2), constrained_layout=True)
    rate, index, low, high = (numpy.array([row[k] for row in series]) for k in (0, 4, 5, 6))
    axes.axvspan(15, 200, color="#eeeeee", label="the paper's rates")
    axes.fill_between(rate, 100 * low, 100 * high, color="#D55E00", alpha=0.25)
    axes.plot(rate, 100 * index, "o-", color="#D55E00", label="Vesica")
    axes.set_xscale("log")
    axes.set_xlabel("shear rate (1/s)")
    axes.set_ylabel("deformation index (%)")
    axes.set_xlim(10, 2000)
    axes.set_ylim(0, 60)
    axes.legend(loc="lower right")
    return figure
