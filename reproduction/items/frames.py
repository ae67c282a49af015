"""Appendix B: curvatures in the paper's three frames against the frame-free form and the exact ones."""

import numpy

TITLE = "Principal curvatures in three local frames (Eqs B1-B10)"
PAPER = "Three choices of tangent axes give the same curvatures; frame 1 is recommended where N_Z is the largest component."


def plan(quick):
    return []


def judge(item, finished):
    surfaces = item.paper_formulas()["surfaces"]
    exact = numpy.array([[sum(s["principal_curvatures"]) / 2, numpy.prod(s["principal_curvatures"])] for s in surfaces])
    normals = numpy.array([s["normal"] for s in surfaces])
    frames = numpy.array([s["frames"] for s in surfaces])  # sample, frame, (H, K)
    chosen = numpy.array([s["chosen"] for s in surfaces])
    projected = numpy.array([s["frame_free"] for s in surfaces])
    # The program's frame-free K gives back what a lattice's derivatives lose; here they are exact.
    restored = 1 + (4 * exact[:, 0] ** 2 - 2 * exact[:, 1]) / 6
    projected[:, 1] /= restored**2

    theory = item.against("theory")
    count = f"{len(surfaces)} random surfaces, curvatures up to .2"
    theory.absolute("H of the frame-free form, largest error", count, float(abs(projected - exact)[:, 0].max()), 0.0, 1e-14)
    theory.absolute("K of the frame-free form, largest error", count, float(abs(projected - exact)[:, 1].max()), 0.0, 1e-14)
    paper = item.against("paper")
    divided = 1 - normals[:, [2, 0, 1]] ** 2  # what each frame divides by
    for k in range(3):
        well = divided[:, k] > 0.02
        error = abs(frames[well, k] - projected[well]).max()
        paper.absolute(f"H and K in frame {k + 1} less the frame-free ones", f"where 1 - N^2 > .02 ({well.sum()})", float(error), 0.0, 1e-12)  # fmt: skip
    paper.absolute("H and K in the frame that the program chooses, largest error", count, float(abs(chosen - exact).max()), 0.0, 1e-14)

    rows, printed = [], _as_printed(surfaces)
    for k in range(3):
        wrong = float(numpy.median(abs(printed[:, k] - exact).max(axis=1)))
        rows.append((f"frame {k + 1}", float(abs(frames[:, k] - exact).max(axis=1).max()), wrong))
    item.table("Errors of H or K, the greater: the corrected Eqs B8-B10, largest, beside those as printed, median",
               ("frame", "corrected", "as printed"), rows)  # fmt: skip
    theory.at_most("median error of frame 2 as printed", "B9 is right there", rows[1][2], 1e-15)
    theory.at_least("median error of frames 1 and 3 as printed, the smaller", "B9 wants [N_Y^2 N_Z^2] (N_Y)_Y and [1 - N_Z^2]^2 (N_Z)_Z; [1 - N_Y^2]^2 (N_Y)_Y", min(rows[0][2], rows[2][2]), 1e-6)  # fmt: skip

    best, worst = numpy.argmin(abs(normals), axis=1), numpy.argmax(abs(normals), axis=1)
    frame_of_axis = numpy.array([1, 2, 0])  # axis x -> frame 2, y -> 3, z -> 1
    errors = abs(frames - exact[:, None]).max(axis=2)
    index = numpy.arange(len(surfaces))
    smallest, largest = errors[index, frame_of_axis[best]].max(), errors[index, frame_of_axis[worst]].max()
    theory.at_least("largest error with the frame of the largest component of N over that of the smallest", "what B says against what is right",
                    float(largest / smallest), 10.0)  # fmt: skip
    item.explain("The text of Appendix B prefers frame 1 where N_Z is the *largest* component. Frame 1 divides by 1 - N_Z^2: it is "
                 "the *smallest* component that must choose, as the errors by either rule show.")  # fmt: skip
    item.csv("errors.csv", ("N_X", "N_Y", "N_Z", "frame 1", "frame 2", "frame 3", "chosen", "frame-free"),
             [(*map(float, n), *map(float, e), float(a), float(b)) for n, e, a, b in
              zip(normals, errors, abs(chosen - exact).max(axis=1), abs(projected - exact).max(axis=1))])  # fmt: skip
    item.picture("errors.png", _figure(divided, errors, abs(chosen - exact).max(axis=1)),
                 "Rounding error of H or K in each frame against what the frame divides by. The chosen frame stays at the bottom.")  # fmt: skip


def _as_printed(surfaces):
    """H and K with B8-B10 letter by letter; [...]_P are the normal's components, (N_a)_b its derivatives."""
    found = []
    for s in surfaces:
        (X, Y, Z), G = s["normal"], s["derivatives"]
        (Xx, Xy, Xz), (Yx, Yy, Yz), (Zx, Zy, Zz) = G
        qx, qy, qz = 1 - X * X, 1 - Y * Y, 1 - Z * Z
        xx = ((Y * Y * Xx + X * X * Yy - X * Y * (Xy + Yx)) / qz, (Z * Z * Yy + Y * Y * Zz - Y * Z * (Yz + Zy)) / qx,
              (Z * Z * Xx + X * X * Zz - X * Z * (Xz + Zx)) / qy)  # fmt: skip
        yy = (
            (X * X * Z * Z * Xx + X * Y * Z * Z * (Yx + Xy) - X * Z * qz * (Zx + Xz) + Y * Z * Z * Yy + qz * Zz
             - Y * Z * qz * (Zy + Yz)) / qz,
            (qx * qx * Xx - X * Y * qx * (Yx + Xy) - X * Z * qx * (Zx + Xz) + X * X * Y * Y * Yy + X * X * Z * Z * Zz
             + X * X * Y * Z * (Zy + Yz)) / qx,
            (X * X * Y * Y * Xx - X * Y * qy * (Yx + Xy) + X * Y * Y * Z * (Zx + Xz) + qy * Yy + Y * Y * Z * Z * Zz
             - Y * Z * qy * (Zy + Yz)) / qy,
        )  # fmt: skip
        yx = (
            (X * Y * Z * (Xx - Yy) + Y * Y * Z * Yx - X * X * Z * Xy + X * qz * Zy - Y * qz * Zx) / qz,
            (X * Y * Z * (Yy - Zz) - Z * qx * Xy + X * Z * Z * Zy + Y * qx * Xz - X * Y * Y * Yz) / qx,
            (X * Y * Z * (Zz - Xx) + Z * qy * Yx - Y * Z * Z * Zx + X * X * Y * Xz - X * qy * Yz) / qy,
        )
        found.append([[0.5 * (a + b), a * b - c * c] for a, b, c in zip(xx, yy, yx)])
    return numpy.array(found)


def _figure(divided, errors, chosen):
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(figsize=(7.0, 4.2), constrained_layout=True)
    for k in range(3):
        axes.loglog(divided[:, k], errors[:, k] + 1e-20, ".", markersize=4, alpha=0.6, label=f"frame {k + 1}")
    axes.loglog(divided.max(axis=1), chosen + 1e-20, "k.", markersize=3, label="chosen")
    axes.set_xlabel("what the frame divides by, $1 - N_a^2$")
    axes.set_ylabel("error of H or K (1/cells, 1/cells²)")
    axes.legend()
    return figure
