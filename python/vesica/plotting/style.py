"""One look for every picture, in colours that colour-blind readers tell apart (Okabe and Ito 2008)."""

import functools
import os
from pathlib import Path

import matplotlib
import numpy
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from PIL import Image

INK = "#222222"
RUN = "#0072B2"
CYCLE = ("#0072B2", "#E69F00", "#009E73", "#D55E00", "#CC79A7", "#56B4E9")
BRANCH_COLOURS = {"oblate": "#D55E00", "prolate": "#009E73", "stomatocyte": "#CC79A7"}
BRANCH_DASHES = {"oblate": (0, (6, 2)), "prolate": (0, (2, 1.5)), "stomatocyte": (0, (6, 2, 1.5, 2))}

LOOK = {
    "figure.dpi": 160,
    "figure.facecolor": "white",
    "font.family": "DejaVu Sans",
    "font.size": 10,
    "axes.titlesize": 11,
    "axes.titleweight": "bold",
    "axes.titlelocation": "left",
    "axes.labelcolor": INK,
    "axes.edgecolor": "#888888",
    "axes.linewidth": 0.8,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "grid.color": "#dddddd",
    "grid.linewidth": 0.6,
    "text.color": INK,
    "xtick.color": INK,
    "ytick.color": INK,
    "lines.linewidth": 1.8,
    "legend.frameon": False,
    "legend.fontsize": 9,
    "mathtext.fontset": "dejavusans",
    "axes.prop_cycle": matplotlib.cycler(color=CYCLE),
}


def in_style(draw):
    """`draw` returns (figure, ...), made and laid out in this look, whatever the user's own settings are."""

    @functools.wraps(draw)
    def drawn(*arguments, **options):
        with matplotlib.rc_context(LOOK):
            found = draw(*arguments, **options)
            found[0].draw_without_rendering()  # ticks take their look when they are first drawn
        return found

    return drawn


def new_figure(width, height, **options):
    """A figure that belongs to nobody's session: pyplot knows nothing of it."""
    figure = Figure(figsize=(width, height), **options)
    FigureCanvasAgg(figure)
    return figure


def column(rows, width, height, ratios=None, sharex=True):
    """(figure, axes from top to bottom)"""
    figure = new_figure(width, height, layout="constrained")
    axes = figure.subplots(rows, 1, sharex=sharex, squeeze=False, gridspec_kw={"height_ratios": ratios or [1.0] * rows})
    return figure, numpy.ravel(axes)


def save(figure, path, small=False):
    """Writes the picture whole or not at all. `small`: in 256 colours."""
    path = Path(path)
    temporary = path.with_name(f".{path.name}.part")
    try:
        figure.savefig(temporary, format="png", dpi=160)
        if small:
            whole = Image.open(temporary).convert("RGB")
            palette = whole.quantize(256)
            whole.quantize(palette=palette, dither=Image.Dither.FLOYDSTEINBERG).save(temporary, format="png", optimize=True)
        os.replace(temporary, path)
    finally:
        temporary.unlink(missing_ok=True)
