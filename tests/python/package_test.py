"""The package as a whole: stubs, docstrings, its page, its installation, and what it says without its compiled part."""

import inspect
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import vesica
from vesica.compiled import part

SOURCE = Path(__file__).resolve().parents[2]
BUILD = os.environ.get("VESICA_BUILD_DIR", str(SOURCE / "build/release"))
STUB = (SOURCE / "python/vesica/_vesica.pyi").read_text(encoding="utf-8")


def public(thing):
    return {name for name in vars(thing) if not name.startswith("_")}


class Package(unittest.TestCase):
    def test_the_stub_names_what_the_module_has(self):
        classes = dict(re.findall(r"^class (\w+):\n((?:    .*\n|\n)+)", STUB, re.MULTILINE))
        functions = dict(re.findall(r"^def (\w+)\(([^)]*)\)", STUB, re.MULTILINE))
        names = {name for name in public(part) if not inspect.ismodule(getattr(part, name))}
        self.assertEqual(names, {*classes, *functions, *re.findall(r"^(\w+): ", STUB, re.MULTILINE)})
        for name, body in classes.items():
            self.assertEqual(public(getattr(part, name)), set(re.findall(r"def ([a-z]\w*)\(", body)), name)
        for name, arguments in functions.items():
            documented = re.findall(r"(\w+): (?!Any)", getattr(part, name).__doc__.split(")")[0])
            self.assertEqual(documented, re.findall(r"(\w+): ", arguments), name)

    def test_samples_have_the_columns_of_the_metrics(self):
        self.assertEqual(list(vesica.VesicleSample._fields), part.metrics_columns())

    def test_everything_public_is_documented_and_annotated(self):
        for name in vesica.__all__:
            thing = getattr(vesica, name)
            if name == "__version__":
                continue
            self.assertTrue(inspect.getdoc(thing), name)
            members = public(thing) if inspect.isclass(thing) and thing.__module__.startswith("vesica") else ()
            for member in members:
                value = inspect.getattr_static(thing, member)
                function = value.fget if isinstance(value, property) else getattr(value, "__func__", value)
                if not inspect.isfunction(function):
                    continue
                self.assertIn("return", function.__annotations__, f"{name}.{member}")
                if name not in ("Fields", "Steps"):
                    self.assertTrue(inspect.getdoc(function) or len(inspect.getsource(function).splitlines()) < 5,
                                    f"{name}.{member} has no docstring")

    def test_the_reference_is_what_the_docstrings_say(self):
        done = subprocess.run([sys.executable, str(SOURCE / "tools/write-python-page"), "--check"], capture_output=True,
                              text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_without_the_compiled_part_pictures_work_and_the_rest_says_what_to_do(self):
        code = ("import vesica, vesica.plotting.pictures\n"
                "try: vesica.Case\n"
                "except ImportError as problem: print(problem)\n")
        done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True,
                              env={**os.environ, "PYTHONPATH": str(SOURCE / "python")})
        self.assertIn("try `make python`", done.stdout)

    def test_it_is_installed_offline_into_a_fresh_environment_and_again_at_once(self):
        with tempfile.TemporaryDirectory(prefix="vesica-venv-") as folder:
            environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
            command = [str(SOURCE / "tools/make-python"), BUILD, f"{folder}/venv"]
            first = subprocess.run(command, capture_output=True, text=True, check=False, env=environment)
            self.assertEqual(first.returncode, 0, first.stderr)
            stamp = Path(folder, "venv/vesica.stamp").stat().st_mtime_ns
            again = subprocess.run(command, capture_output=True, text=True, check=True, env=environment)
            self.assertEqual(Path(folder, "venv/vesica.stamp").stat().st_mtime_ns, stamp)
            self.assertIn("source ", again.stdout)
            code = ("import vesica, sys; from vesica.plotting.helfrich import HelfrichShapes as H\n"
                    "print(vesica.Simulation.__name__, vesica.__file__, H().range('oblate'))\n"
                    "from vesica.program import find_program; print(find_program())")
            said = subprocess.run([f"{folder}/venv/bin/python3", "-c", code], capture_output=True, text=True, check=True,
                                  cwd=folder, env={k: v for k, v in environment.items() if k != "VESICA_PROGRAM"}).stdout
            self.assertIn(f"Simulation {folder}/venv", said)
            self.assertIn(f"{folder}/venv/bin/vesica", said)


if __name__ == "__main__":
    unittest.main()
