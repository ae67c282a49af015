"""Table V: twelve cells of kappa_B and sigma, by the paper's soft and sudden path, and what equilibrium gives."""

import math

import numpy

from drawing import frame_from, paint
from item import reason
from runs import RADIUS, from_sphere
from shape_class import classify
from shared import OWN_CASES, HelfrichShapes, Simulation, bending_time, read_surface, surface_files

TITLE = "The phase diagram of kappa_B and sigma (Table V)"
PAPER = "Classes A oblate, B prolate, C not axisymmetric, for sigma = 1e-1, 1e-3, 1e-5: kappa_B .01: C A C; .1: A A A; .25: B A A; 1: A A A."
CLASSES = {0.01: "CAC", 0.1: "AAA", 0.25: "BAA", 1.0: "AAA"}
JUMP = OWN_CASES / "jump.toml"
SIGMAS = (1e-1, 1e-3, 1e-5)
FORMS = {"paper": {"vesicle_type.vesicle.bending.form": "paper", "vesicle_type.vesicle.bending.laplacian_coefficient": 1.5},
         "helfrich": {}}  # fmt: skip
NU, MODULUS, STEPS, BOX = 1 / 6, 0.5, 20000, 64
STIFF = ((1.0, 1e-1), (1.0, 1e-3), (1.0, 1e-5))


def alpha_of(radius, modulus=MODULUS):
    """K_A = alpha A A0/2 with A near A0."""
    area = 4 * math.pi * radius**2 * 1.31
    return 2 * modulus / area**2


def soft_runs(quick):
    """(form, kappa_B, sigma) -> run: a sphere whose target area jumps."""
    radius, box, steps = (9.0, 40, 400) if quick else (RADIUS, BOX, STEPS)
    cells = [(1.0, 1e-1), (0.25, 1e-3)] if quick else [(k, s) for k in CLASSES for s in SIGMAS]
    runs = {}
    for form in ("paper",) if quick else FORMS:
        for kappa_b, sigma in cells:
            runs[form, kappa_b, sigma] = Simulation(f"table5-{form}-{kappa_b:g}-{sigma:g}" + ("-quick" if quick else ""), JUMP, {
                "lattice.size": [box] * 3, "vesicle[0].centre": [box / 2] * 3, "vesicle[0].radius": radius,
                "fluid.kinematic_viscosity": NU,
                "vesicle_type.vesicle.bending.paper_modulus": kappa_b, "vesicle_type.vesicle.tension.sigma": sigma,
                "vesicle_type.vesicle.area.constraint": "paper", "vesicle_type.vesicle.area.alpha": alpha_of(radius),
                "vesicle_type.vesicle.area.ramp": 0, "numerics.precision": "single",
                "run.steps": steps, "output.fields.every": 0, "output.surfaces.every": steps // 4,
                "output.checkpoint.every": max(steps // 4, 500), **FORMS[form],
            }, ("--accept-soft-membranes",))  # fmt: skip
    return runs


def stiff_runs(quick):
    if quick:
        return {}
    return {cell: from_sphere(f"table5-stiff-{cell[0]:g}-{cell[1]:g}", RADIUS, cell[0], nu=NU, sigma=cell[1],
                              settings={"numerics.precision": "single"}) for cell in STIFF}  # fmt: skip


def plan(quick):
    return [*soft_runs(quick).values(), *stiff_runs(quick).values()]


def judge(item, finished):
    item.choose("alpha", f"K_A = alpha A0^2/2 = {MODULUS:g} for all cells", "not given. 'F_a about max(F_b, F_l)' holds in any equilibrium, so it fixes nothing. With sigma = .1 a K_A below .42 leaves the sphere a sphere, "
                "and with 1 the sudden target wrinkles soft membranes until they tear (kappa_B = .25 and .01 within 300 steps): .5 lies between")  # fmt: skip
    item.choose("path", "A0 jumps to 1.31 A_sphere at step 0", "the paper sets a target area and starts; it mentions no ramp")
    item.choose("perturbation", "all harmonics of l = 2 to 6, r.m.s. 1 %, seed 1", "the paper's is the lattice's own noise")
    item.choose("steps", f"{STEPS}", "not given; in tau_b = eta R^3/kappa below, since soft cells are far from equilibrium after any affordable length")
    item.choose("nu, precision", "1/6, single", "not given; shapes are the same in single precision")
    rows, shots, agree = [], {}, {}
    for (form, kappa_b, sigma), simulation in soft_runs(item.quick).items():
        run = finished[simulation.name]
        published = CLASSES[kappa_b][SIGMAS.index(sigma)]
        row = _row(run, form, kappa_b, sigma, published)
        rows.append(row)
        if run.failure is None:
            shots[form, kappa_b, sigma] = (read_surface(surface_files(run)[-1][1]), row[3], published)
            agree.setdefault(form, []).append(row[3].startswith(published))
    paper = item.against("paper")
    for form, same in agree.items():
        total = 2 if item.quick else 12
        paper.at_least(f"cells of {total} with the paper's class", f"{form} bending, soft constraint, sudden path", float(sum(same)), total)
    item.table("A soft constraint and a sudden target: what each cell has become", ("bending", "kappa_B", "sigma", "class", "paper", "tau_b run", "A/A0", "v", "E/(8 pi kappa)", "int K dA/(4 pi)"), rows)  # fmt: skip
    item.csv("cells.csv", ("bending", "kappa_B", "sigma", "class", "paper", "tau_b", "A/A0", "v", "E", "K/4pi"), rows)
    _stiff(item, finished)
    item.explain("At equilibrium the area force and sigma's are equal and opposite but for the small tension that the shape wants: 'F_a about max(F_b, F_l)' "
                 "is then true of any alpha. What alpha does decide is by how much the area falls short, sigma/K_A: with sigma = .1 and K_A = .5 a fifth, so that the first "
                 "column is at another reduced volume than the third. And it decides how hard the sudden target squeezes the sphere, K_A (1 - 1/1.31) R^2/kappa "
                 "= 106 at kappa_B = 1 and 10,600 at .01, where 50 suffices to buckle modes above l = 2: tori, several holes and starfish come from there.")  # fmt: skip
    if shots:
        item.picture("cells.png", _figure(shots, item.quick), "The cells, paper's bending form above, Helfrich's below; ours (paper's) class.")


def _row(run, form, kappa_b, sigma, published):
    if run.failure is not None:
        return (form, kappa_b, sigma, "ended early: " + reason(run), published)
    shape = classify(run.surface())
    radius = (3 * run.last("volume") / (4 * math.pi)) ** (1 / 3)
    time = bending_time(radius, kappa_b / 4, NU)
    return (form, kappa_b, sigma, shape.words(), published, run.steps() / time, run.last("area_ratio"), run.last("reduced_volume"),
            run.last("bending_energy"), run.last("gaussian_curvature_over_pi") / 4)  # fmt: skip


def _stiff(item, finished):
    theory, shapes, rows = item.against("theory"), HelfrichShapes(), []
    for (kappa_b, sigma), simulation in stiff_runs(item.quick).items():
        run = finished[simulation.name]
        if run.failure is not None:
            continue
        v, energy = run.last("reduced_volume"), run.last("bending_energy")
        exact = float(shapes.energy("oblate", v))
        rows.append((kappa_b, sigma, classify(run.surface()).words(), v, energy, exact, run.last("tension")))
        theory.relative("energy with a stiff constraint against Helfrich's oblate", f"kappa_B = {kappa_b:g}, sigma = {sigma:g}", energy, exact, 0.01)
    if len(rows) > 1:
        spread = numpy.ptp([row[4] for row in rows]) / rows[0][4]
        theory.at_most("spread of the energy over four decades of sigma, relative", "the multiplier takes sigma up", float(spread), 0.002)
        item.table("A stiff constraint, a slow ramp, equilibrium: sigma decides nothing, and kappa_B only how long it takes",
                   ("kappa_B", "sigma", "class", "v", "E/(8 pi kappa)", "Helfrich's", "whole tension"), rows)  # fmt: skip


def _figure(shots, quick):
    from matplotlib import pyplot

    forms = list(dict.fromkeys(key[0] for key in shots))
    kappas = list(dict.fromkeys(key[1] for key in shots))
    figure, panels = pyplot.subplots(len(forms) * len(kappas), 3, figsize=(6.0, 1.6 * len(forms) * len(kappas)), squeeze=False, constrained_layout=True)
    for axes in panels.flat:
        axes.axis("off")
    frame = frame_from((1.0, 0.5, 0.7))
    for (form, kappa_b, sigma), (surface, found, published) in shots.items():
        axes = panels[forms.index(form) * len(kappas) + kappas.index(kappa_b), SIGMAS.index(sigma)]
        paint(axes, surface, frame, alpha=0.6)
        axes.set_title(rf"{form}, $\kappa_B$ {kappa_b:g}, $\sigma$ {sigma:g}: {found} ({published})", fontsize=6, fontweight="normal")
    return figure
