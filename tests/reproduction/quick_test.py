"""Quick items come out as expected, and `vesica reproduce` says plainly when something does not."""

import json
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = os.environ.get("VESICA_PROGRAM", str(ROOT / "build/release/bin/vesica"))
ITEMS = ["fig1", "fig2", "fig3", "fig4", "fig5", "fig6", "fig7", "fig8", "fig9", "fig10", "table3", "table4", "table5",
         "gauss-bonnet", "appendix-a", "appendix-b"]  # fmt: skip
QUICK = ("appendix-a", "appendix-b", "gauss-bonnet", "fig5")


class Reproduce(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="vesica-reproduction-")
        self.addCleanup(scratch.cleanup)
        self.out = Path(scratch.name) / "out"

    def vesica(self, *arguments, environment=None, command=(PROGRAM, "reproduce")):
        done = subprocess.run([*command, *map(str, arguments)], capture_output=True, text=True, check=False, timeout=600,
                              cwd=self.out.parent, env={**os.environ, **(environment or {})})  # fmt: skip
        return done.returncode, done.stdout, done.stderr

    def with_program(self, text, *arguments):
        """The same script with another program in the place of vesica."""
        stub = self.out.parent / "stub"
        stub.write_text(text)
        stub.chmod(0o755)
        script = (sys.executable, "-B", str(ROOT / "reproduction/reproduce.py"), "--program", str(stub))
        return self.vesica("--output", self.out, *arguments, command=script)


class Quick(Reproduce):
    def test_four_quick_items_come_out_as_expected_and_are_not_run_again(self):
        arguments = (*QUICK, "--quick", "--threads", 1, "-o", self.out)
        status, out, errors = self.vesica(*arguments)
        self.assertEqual(status, 0, out[-3000:] + errors[-3000:])
        for item in QUICK:
            self.assertRegex(out, rf"(?m)^{item}: ([1-9]\d*) of \1 as expected, of the quick set-up")
            folder = self.out / "quick" / item
            results = json.loads((folder / "results.json").read_text())
            self.assertTrue(results["quick"])
            self.assertIn("verdicts.csv", results["data"])
            for name in [*results["data"], *(picture for picture, _ in results["pictures"])]:
                self.assertGreater((folder / name).stat().st_size, 50, name)
        self.assertIn("starts", out)
        status, again, errors = self.vesica(*arguments)
        self.assertEqual(status, 0, errors)
        self.assertNotIn("starts", again)
        number = re.compile(r"^(?:met|missed|reported) .*$", re.MULTILINE)
        self.assertEqual(number.findall(out), number.findall(again))


class Plain(Reproduce):
    def test_a_number_that_is_not_the_papers_is_printed_as_missed_and_is_no_failure(self):
        formulas = json.loads(subprocess.run([PROGRAM, "paper-formulas"], capture_output=True, text=True, check=True).stdout)
        formulas["surfaces"][0]["chosen"][1] += 1e-3  # K of one surface
        tables = self.out.parent / "tables.json"
        tables.write_text(json.dumps(formulas))
        status, out, errors = self.with_program(f"#!/bin/sh\ncat {tables}\n", "appendix-b")
        self.assertEqual(status, 0, errors)
        self.assertIn("missed    H and K in the frame that the program chooses", out)
        self.assertIn('"verdict": "missed"', (self.out / "whole/appendix-b/results.json").read_text())

    def test_a_run_that_fails_is_status_one(self):
        status, out, errors = self.with_program("#!/bin/sh\necho 'vesica: it broke' >&2\nexit 1\n", "fig1", "--quick")
        self.assertEqual(status, 1, out)
        self.assertIn("a run failed: discocyte-quick: it broke", errors)

    def test_the_list_names_every_item(self):
        status, out, errors = self.vesica("--list")
        self.assertEqual((status, errors), (0, ""))
        self.assertEqual([line.split()[0] for line in out.splitlines()], ITEMS)

    def test_wrong_input_is_status_two(self):
        for arguments, saying in (
            (("fig99",), "fig99 is not an item; expected one of fig1, fig2"),
            (("tabel4",), "try `vesica reproduce table4`"),
            ((), "no item is named"),
            (("--all", "fig1"), "both --all and fig1 are given"),
            (("fig1", "--fast"), "--fast"),
            (("appendix-a", "-o", "/dev/null/x"), "expected a directory to write to"),
        ):
            status, _, errors = self.vesica(*arguments)
            self.assertEqual(status, 2, errors)
            self.assertIn(saying, errors)

    def test_what_is_missing_is_named(self):
        status, _, errors = self.vesica("--list", environment={"VESICA_PYTHON": "/nowhere/python3"})
        self.assertEqual(status, 1)
        self.assertIn("/nowhere/python3 cannot be started", errors)
        status, _, errors = self.vesica("--list", environment={"VESICA_REPRODUCTION": "/nowhere"})
        self.assertEqual(status, 2)
        self.assertIn("VESICA_REPRODUCTION is /nowhere; expected", errors)

    def test_a_python_without_the_packages_says_which(self):
        bare = self.out.parent / "python"
        bare.write_text(f"#!/bin/sh\nexec {sys.executable} -S \"$@\"\n")  # without Debian's packages
        bare.chmod(0o755)
        status, _, errors = self.vesica("appendix-a", environment={"VESICA_PYTHON": str(bare)})
        self.assertEqual(status, 1, errors)
        self.assertIn("apt-get install python3-numpy", errors)


if __name__ == "__main__":
    unittest.main()
