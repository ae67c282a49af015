"""Fig 3: speed, curvatures and the parts of the force on the discocyte's surface."""

import math

import numpy

from drawing import frame_from, paint
from items.deflation import explain_path
from runs import discocyte

TITLE = "Six maps of the discocyte's surface (Fig 3)"
PAPER = ("Panels of |u|, H, K, the total force, bending plus surface tension, and the area force, on phi = 0, without values; 'H is an order "
         "of magnitude larger than K', both vary alike, and |u| scales with the total force.")  # fmt: skip


def plan(quick):
    return [discocyte(quick)]


def judge(item, finished):
    run = next(iter(finished.values()))
    explain_path(item)
    item.choose("unit of the forces", "per membrane area", "the paper's F of Eqs 11-14, before the weight |grad phi|/2; without it the maps would show the layer's profile")
    if run.failure is not None:
        return
    surface = run.surface()
    maps = force_maps(run, surface)
    weights = surface.point_areas()

    def mean(name):
        return float(numpy.average(numpy.abs(maps[name]), weights=weights))

    H, K = maps["H"], maps["K"]
    paper, theory = item.against("paper"), item.against("theory")
    paper.at_least("largest |H| over largest |K|", "1/cell over 1/cell^2", float(abs(H).max() / abs(K).max()), 3.0)
    correlation = float(numpy.cov(H, K, aweights=weights)[0, 1] / math.sqrt(numpy.cov(H, aweights=weights) * numpy.cov(K, aweights=weights)))
    paper.at_least("correlation of H and K over the surface", "by area", correlation, 0.5)
    theory.relative("int K dA over 4 pi", "over the triangles", float((weights * K).sum() / (4 * math.pi)), 1.0, 0.03 if item.quick else 0.01)
    spread = float(maps["total"].std())
    theory.at_most("spread of the total force over its mean", "at rest it balances one pressure jump", spread / mean("total"), 0.3 if item.quick else 0.05)
    item.results.report("mean bending plus tension force over mean total", "the area force takes the difference", mean("bending plus tension") / mean("total"))
    item.results.report("largest speed at rest, cells per step", "micro-current", run.last("max_speed"))
    item.results.report("mean |bending plus tension|", "force per area", mean("bending plus tension"))
    item.results.report("mean |area force|", "force per area", mean("area"))
    item.results.report("constant tension sigma over the whole tension", "what Fig 3E could show of sigma",
                        abs(sigma_of(run) / run.last("tension")))  # fmt: skip
    item.explain(f"At rest the total normal force balances a pressure jump, so that it should be the same everywhere: in panel D it spreads by {100 * spread / mean('total'):.1f} % "
                 "of its mean. The paper's panels have no scale to compare with.")  # fmt: skip
    item.csv("maps.csv", ("quantity", "least", "area mean of the modulus", "greatest"), [(n, float(v.min()), mean(n), float(v.max())) for n, v in maps.items()])  # fmt: skip
    item.picture("maps.png", _figure(surface, maps), "The six maps on phi = 0, in lattice units: speed, mean and Gaussian curvature, and the moduli of the total force, "
                 "bending plus constant tension, and the area constraint's force, per membrane area.")  # fmt: skip


def sigma_of(run):
    sigma = run.run.resolved["vesicle_type"]["vesicle"]["tension"]["sigma"]
    return float(sigma["lattice"] if isinstance(sigma, dict) else sigma)


def force_maps(run, surface):
    """Moduli per membrane area; the file has each part of the force."""
    fields = surface.fields
    bending, tension, area = (fields[f"{part}_force"] for part in ("bending", "tension", "area"))
    return {
        "speed": numpy.linalg.norm(fields["velocity"], axis=1),
        "H": fields["mean_curvature"],
        "K": fields["gaussian_curvature"],
        "total": numpy.abs(fields["total_force"]),
        "bending plus tension": numpy.abs(bending + tension),
        "area": numpy.abs(area),
    }


def _figure(surface, maps):
    from matplotlib import cm, colors, pyplot

    names = {"speed": "(A) $|u|$", "H": "(B) $H$", "K": "(C) $K$", "total": "(D) $|F^{(t)}|$",
             "bending plus tension": "(E) $|F^{(b)} + F^{(l)}|$", "area": "(F) $|F^{(a)}|$"}  # fmt: skip
    figure, panels = pyplot.subplots(2, 3, figsize=(9.0, 5.0), constrained_layout=True)
    frame = frame_from((math.cos(0.7), 0.0, math.sin(0.7)))
    for axes, (key, title) in zip(panels.flat, names.items()):
        values = maps[key]
        low, high = numpy.percentile(values, (1, 99))
        if high - low < 0.02 * abs(high):  # what is constant is to look it
            low, high = 0.0, 1.2 * high
        norm = colors.Normalize(low, high, clip=True)
        paint(axes, surface, frame, values=values, norm=norm, cmap="jet")
        low_y = 0.75 * axes.get_ylim()[1]
        axes.set_ylim(-low_y, low_y)
        axes.set_title(title, fontsize=10)
        bar = figure.colorbar(cm.ScalarMappable(norm, "jet"), ax=axes, shrink=0.7, format="%.2g")
        bar.ax.tick_params(labelsize=7)
        bar.ax.grid(False)
    return figure
