"""What the items take from the house's other scripts: the one place that says where those lie.

In the sources and in an installation (share/vesica) alike, `tools`, `python` and `cases` are beside this folder."""

import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
CASES = ROOT / "cases"
OWN_CASES = Path(__file__).resolve().parent / "cases"
sys.path.insert(0, str(ROOT / "tools"))
sys.path.insert(1, str(ROOT / "python"))

# ruff: noqa: E402, F401
from validation.page import row_line, table_lines
from validation.pair import both, judge_integrity, separation, surface_files
from validation.results import Results, number
from validation.shapes_at_rest import BRANCH_OF, bending_time, rest_case
from validation.simulations import Simulation, run_all
from vesica.plotting import style
from vesica.plotting.comparison import compare
from vesica.plotting.helfrich import HelfrichShapes
from vesica.plotting.surface import fold, read_surface
