"""Adds what CMake has built to the package. `tools/make-python` runs this; by itself it needs VESICA_BUILD, a build folder."""

import os
import re
import shutil
from pathlib import Path

from setuptools import Distribution, setup
from setuptools.command.build_py import build_py

ROOT = Path(__file__).resolve().parent.parent
VERSION = re.search(r"project\(vesica VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1]


class WithCompiledPart(build_py):
    def run(self):
        super().run()
        build = os.environ.get("VESICA_BUILD", "")
        compiled = list((Path(build) / "python" / "vesica").glob("_vesica.*.so")) if build else []
        if not compiled:
            raise SystemExit("the compiled part of vesica is missing; expected VESICA_BUILD to name a build folder that "
                             "has it; try `make python`")
        package = Path(self.build_lib) / "vesica"
        shutil.copy2(compiled[0], package)
        shutil.copytree(ROOT / "data" / "helfrich", package / "data" / "helfrich", dirs_exist_ok=True,
                        ignore=shutil.ignore_patterns("*.py", "__pycache__"))


class WithBinary(Distribution):
    def has_ext_modules(self):
        return True  # the wheel is for this machine and this Python


setup(version=VERSION, cmdclass={"build_py": WithCompiledPart}, distclass=WithBinary)
