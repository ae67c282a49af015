"""Where the program `vesica` is."""

import os
import shutil
import sys
from pathlib import Path

from vesica.errors import RunError


def find_program() -> str:
    """$VESICA_PROGRAM, the one beside this Python (`make python` puts it there), the build's, or the one on the PATH."""
    build = Path(__file__).parents[2] / "bin" / "vesica"
    for candidate in (os.environ.get("VESICA_PROGRAM"), Path(sys.prefix) / "bin" / "vesica", build, shutil.which("vesica")):
        if candidate and os.access(candidate, os.X_OK):
            return str(candidate)
    raise RunError("the program vesica is not found; expected it on the PATH; try setting VESICA_PROGRAM to it")
