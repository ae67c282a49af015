"""Appendix A: the program's own M, inverse and rates against Table VI and Eqs A5-A18."""

from fractions import Fraction

import numpy

from runs import exact

TITLE = "The collision matrix, its inverse and its rates (Table VI, Eqs A1-A19)"
PAPER = ("Table VI gives nineteen moments, their eigenvalues and equilibria; Eqs A5-A18 the columns of the inverse matrix. No "
         "number is given; the claim is that the inverse is the inverse.")  # fmt: skip
NAMES = ("rho", "rho u_x", "rho u_y", "rho u_z", "P_xx", "P_yy", "P_zz", "P_xy", "P_xz", "P_yz", "N", "J_x", "J_y", "J_z",
         "E_1", "E_2", "E_3", "X_y", "X_x")  # fmt: skip
RATE_OF = ("conserved",) * 4 + ("l4",) * 6 + ("l10",) + ("l11",) * 3 + ("l14",) * 3 + ("l17",) * 2


BASES = {"symmetric": {}, "paper": {"fluid.collision.model": "mrt", "fluid.collision.basis": "paper", **{
    f"fluid.collision.ghost_rates.{name}": rate for name, rate in (("l10", 0.9), ("l11", 1.0), ("l14", 1.1), ("l17", 0.9))}}}  # fmt: skip


def plan(quick):
    """The same discocyte along z and along x, in the symmetric basis and in the paper's with ghost rates of no symmetry."""
    runs = []
    for basis, settings in BASES.items():
        along_z = exact("discocyte", 10.0, bending_times=0.4, tag=f"-{basis}-z", settings=settings)
        size, centre = along_z.settings["lattice.size"], along_z.settings["vesicle[0].centre"]
        turned = {"lattice.size": size[::-1], "vesicle[0].centre": centre[::-1], "vesicle[0].axis": [1, 0, 0]}
        runs += [along_z, exact("discocyte", 10.0, bending_times=0.4, tag=f"-{basis}-x", settings={**settings, **turned})]
    return runs


def _turned(item, finished):
    """How far a vesicle along x is from one along z."""
    theory = item.against("theory")
    for basis in BASES:
        z, x = (finished[f"exact-discocyte-R10-{basis}-{axis}"] for axis in "zx")
        if z.failure is not None or x.failure is not None:
            continue
        speed = abs(x.last("max_speed") / z.last("max_speed") - 1)
        if basis == "symmetric":
            theory.at_most("fastest current of a discocyte along x over that along z, less 1", "symmetric basis", speed, 1e-6)
        else:
            theory.at_least("fastest current of a discocyte along x over that along z, less 1", "the paper's basis, rates .9, 1, 1.1, .9", speed, 1e-4)
        energy = abs(x.last("bending_energy") / z.last("bending_energy") - 1)
        item.results.report("bending energy of a discocyte along x over that along z, less 1", f"{basis} basis", energy)


def table_six(c, g, as_printed=False):
    """Rows h^(p) as the paper's table defines them; as printed, its h14 repeats h15."""
    x, y, z = c.T
    h14 = x * x * y if as_printed else x * y * y
    one = numpy.ones_like(x)
    return numpy.array([one, x, y, z, x * x, y * y, z * z, x * y, x * z, y * z, g, g * x, g * y, g * z, h14, x * x * y,
                        x * x * z, g * y * y, g * x * x])  # fmt: skip


def columns_of_inverse(c, g, t, as_printed=False):
    """k^(p) of Eqs A5-A18, in exact rationals. As printed, A8/A9 end in c_zeta^2 once more, where c_epsilon^2 is meant."""

    def column(i):
        x, y, z = (int(v) for v in c[i])
        w, h = t[i], int(g[i])
        theta = x * x + y * y
        last = {"x": x * x if as_printed else y * y, "y": y * y if as_printed else x * x}
        pair = lambda a, b, e: w * Fraction(-5 + 11 * a + b + 3 * z * z + 2 * h - 2 * h * a - 4 * h * e, 2)
        tail = lambda a, b: w * (2 - 2 * a - b - 3 * z * z - 2 * h + 2 * h * a + 4 * h * b)
        return [
            w * Fraction(12 * h * theta - 15 * theta - 21 * z * z + 23 - 8 * h, 6),
            w * x * (5 + h - 6 * y * y), w * y * (5 + h - 6 * x * x), w * z * (5 + h - 6 * x * x),
            pair(x * x, y * y, last["x"]), pair(y * y, x * x, last["y"]),
            w * Fraction(-6 * h * theta + 3 * theta + 15 * z * z - 7 + 4 * h, 2),
            9 * w * x * y, 9 * w * x * z, 9 * w * y * z,
            w * Fraction(6 * theta - 12 * h * theta + 12 * z * z - 8 + 11 * h, 6),
            w * x * (1 - 3 * y * y + 2 * h), w * y * (1 - 3 * x * x + 2 * h), w * z * (1 - 3 * x * x + 2 * h),
            3 * w * x * (-2 + 6 * y * y - h), 3 * w * y * (-2 + 6 * x * x - h), 3 * w * z * (-2 + 6 * x * x - h),
            tail(x * x, y * y), tail(y * y, x * x),
        ]  # fmt: skip

    return [column(i) for i in range(19)]


def judge(item, finished):
    program = item.paper_formulas()
    c = numpy.array(program["lattice"]["velocities"])
    t, g = (numpy.array(program["lattice"][name]) for name in ("weights", "ghost_weights"))
    M, inverse = numpy.array(program["M"]), numpy.array(program["M_inverse"])
    paper, theory = item.against("paper"), item.against("theory")
    printed = table_six(c, g, as_printed=True)
    exact = [Fraction(w).limit_denominator(36) for w in t]

    corrected = table_six(c, g)
    paper.absolute("program's M less Table VI, largest entry", "h14 read as c_x c_y^2", float(abs(M - corrected).max()), 0.0, 0.0)
    theory.absolute("M M^-1 less the identity, largest entry", "program's matrices", float(abs(M @ inverse - numpy.eye(19)).max()), 0.0, 1e-14)  # fmt: skip
    theory.absolute("rank of Table VI as printed, h14 = c_x^2 c_y", "exact", float(numpy.linalg.matrix_rank(printed)), 18, 0.0)
    columns = columns_of_inverse(c, g, exact)
    off = max(abs(float(columns[i][p]) - inverse[i, p]) for i in range(19) for p in range(19))
    paper.absolute("program's M^-1 less Eqs A5-A18, largest entry", "last term of A8, A9 with c_epsilon^2", off, 0.0, 1e-15)
    wrong = columns_of_inverse(c, g, exact, as_printed=True)
    bad = [p for p in range(19) if any(abs(float(wrong[i][p]) - inverse[i, p]) > 1e-12 for i in range(19))]
    theory.report("columns of the printed inverse that are not the inverse's, of 19", "A8 and A9 as printed", float(len(bad)))

    rows = _rates(program, c, g, M)
    worst = [max(abs(found / asked - 1) for sample in rows for q, asked, found in sample if q == p) for p in range(4, 19)]
    paper.absolute("rate of each moment, measured over asked, less 1", "12 random cells in a force, worst of 15 moments", max(worst), 0.0, 1e-10)  # fmt: skip
    paper.absolute("conserved moments before and after, less the force", "12 random cells with a force, four moments", _conservation(program, M), 0.0, 1e-15)  # fmt: skip
    item.csv("rates.csv", ("moment", "rate asked", "rate measured"), [(NAMES[p], asked, found) for sample in rows for p, asked, found in sample])  # fmt: skip
    item.csv("matrix.csv", ["moment", *range(19)], [[NAMES[p], *map(int, M[p])] for p in range(19)])
    item.csv("inverse.csv", ["direction", *NAMES], [[i, *(inverse[i] * 24).round().astype(int)] for i in range(19)])
    item.choose("lambda_4, lambda_10, lambda_11, lambda_14, lambda_17", "random in .3 to 1.9 here; regularised elsewhere",
                "the paper does not print its rates. Free ones in this basis treat x, y and z differently (the last rows above), with 1.2, .7, 1.5 and 1.9 a discocyte of R = 10 tore within 100 steps. So all other "
                "items run the symmetric basis, whose ghost moments relax at once")  # fmt: skip
    _turned(item, finished)
    item.table("What the printed tables must be read as", ("where", "printed", "right", "what shows it"), [
        ("Table VI, h14", "c_x^2 c_y, as h15", "c_x c_y^2", "the printed rows have rank 18"),
        ("Eqs A8, A9", "-4 g c_zeta^2", "-4 g c_epsilon^2", f"{len(bad)} printed columns are not the inverse's ({', '.join(NAMES[p] for p in bad)})"),
        ("Eq 2 beside A2, A3", "f + A (f - f0)", "m + lambda (m0 - m)", "with Eq 2's sign the moments run away from equilibrium"),
        ("above A3", "M A = M Lambda", "M A = Lambda M", "the rows of M are left eigenvectors"),
    ])  # fmt: skip
    item.picture("matrix.png", _figure(M, inverse), "The program's M (left) and 24 M^-1 (right), by moment and direction.")


def _rates(program, c, g, M):
    """(moment, rate asked, rate found) of each sample: the change of a moment over its distance from equilibrium."""
    found = []
    for sample in program["collisions"]:
        before, after = (M @ (numpy.array(sample[k])) for k in ("before", "after"))
        rho = sample["reference_density"] + before[0]
        force = numpy.array(sample["force"])
        u = (before[1:4] + 0.5 * force) / rho
        equilibrium = _equilibrium(rho, sample["reference_density"], u)
        source = _source(M, c, force, u, program["lattice"]["weights"])
        rates = sample["rates"]
        entries = []
        for p in range(4, 19):
            asked = rates[RATE_OF[p]]
            # m* = m + lambda (m0 - m) + (1 - lambda/2) S, solved for lambda
            lacking = equilibrium[p] - before[p] - 0.5 * source[p]
            entries.append((p, asked, (after[p] - before[p] - source[p]) / lacking))
        found.append(entries)
    return found


def _equilibrium(rho, rho0, u):
    """Of the deviations from t_i rho0, by moment."""
    d = rho - rho0
    x, y, z = u
    return numpy.array([d, rho * x, rho * y, rho * z, d / 3 + rho * x * x, d / 3 + rho * y * y, d / 3 + rho * z * z, rho * x * y,
                        rho * x * z, rho * y * z, 0, 0, 0, 0, rho * x / 3, rho * y / 3, rho * z / 3,
                        0.5 * rho * (x * x + z * z), 0.5 * rho * (y * y + z * z)])  # fmt: skip


def _source(M, c, F, u, t):
    """Moments of Guo's term before its factor."""
    cu, cF, uF = c @ u, c @ F, u @ F
    return M @ (numpy.array(t) * (3 * (cF - uF) + 9 * cu * cF))


def _conservation(program, M):
    worst = 0.0
    for sample in program["collisions"]:
        change = M[:4] @ (numpy.array(sample["after"]) - numpy.array(sample["before"]))
        worst = max(worst, float(abs(change - numpy.array([0.0, *sample["force"]])).max()))
    return worst


def _figure(M, inverse):
    from matplotlib import pyplot

    figure, panels = pyplot.subplots(1, 2, figsize=(8.0, 4.2), constrained_layout=True)
    for axes, values, title in ((panels[0], M, "M"), (panels[1], 24 * inverse, "24 M$^{-1}$")):
        limit = abs(values).max()
        image = axes.imshow(values, cmap="RdBu_r", vmin=-limit, vmax=limit)
        axes.grid(False)
        axes.set_title(title)
        axes.set_xlabel("direction" if values is M else "moment")
        axes.set_ylabel("moment" if values is M else "direction")
        figure.colorbar(image, ax=axes, shrink=0.8)
    return figure
