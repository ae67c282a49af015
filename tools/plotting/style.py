"""One look for every picture, in colours that colour-blind readers tell apart (Okabe and Ito 2008)."""

import os
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot
from PIL import Image  # noqa: E402  (the backend must be chosen first)

INK = "#222222"
RUN = "#0072B2"
BRANCH_COLOURS = {"oblate": "#D55E00", "prolate": "#009E73", "stomatocyte": "#CC79A7"}
BRANCH_DASHES = {"oblate": (0, (6, 2)), "prolate": (0, (2, 1.5)), "stomatocyte": (0, (6, 2, 1.5, 2))}

matplotlib.rcParams.update(
    {
        "figure.dpi": 100,
        "savefig.dpi": 160,
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
    }
)


def save(figure, path, small=False):
    """Writes the picture whole or not at all, and forgets the figure. `small`: in 128 colours."""
    path = Path(path)
    temporary = path.with_name(f".{path.name}.part")
    try:
        figure.savefig(temporary, format="png")
        if small:
            Image.open(temporary).convert("RGB").quantize(128).save(temporary, format="png", optimize=True)
        os.replace(temporary, path)
    finally:
        pyplot.close(figure)
        temporary.unlink(missing_ok=True)
