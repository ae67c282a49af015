"""What the folders of `validation/` share: running cases so that an interrupted campaign goes on where it stopped,
judging numbers against targets, and keeping both as results."""

import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[2] / "python"))  # vesica.plotting: theory, and reading of runs
