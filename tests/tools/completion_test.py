"""The completion and the man page offer what the program's own help offers."""

import os
import re
import subprocess
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = os.environ.get("VESICA_PROGRAM", "")
COMMANDS = ("run", "check", "resume", "new", "info", "bench", "reproduce", "report")
LONG_OPTION = re.compile(r"--[a-z][a-z-]*")


def complete(*words):
    """Return what bash offers for the last of the words after `vesica`."""
    script = f"""
        source {ROOT}/tools/completion/vesica.bash
        COMP_WORDS=(vesica {' '.join(f"'{word}'" for word in words)}) COMP_CWORD={len(words)}
        _vesica vesica '{words[-1]}' '{words[-2] if len(words) > 1 else "vesica"}'
        printf '%s\\n' "${{COMPREPLY[@]}}"
    """
    return set(subprocess.run(["bash", "-c", script], capture_output=True, text=True, check=True).stdout.split())


class Completion(unittest.TestCase):
    def test_the_commands_are_offered(self):
        self.assertEqual(complete(""), {*COMMANDS, "--help", "--version"})
        self.assertEqual(complete("re"), {"resume", "reproduce", "report"})

    def test_cases_are_offered_to_run_and_check(self):
        for command in ("run", "check"):
            self.assertIn(f"{ROOT}/cases/discocyte.toml", complete(command, f"{ROOT}/cases/disco"))

    @unittest.skipUnless(Path(PROGRAM).is_file(), "the program is not built")
    def test_each_command_offers_the_options_of_its_help(self):
        page = (ROOT / "docs/man/vesica.1").read_text().replace("\\-", "-")
        for command in COMMANDS:
            with self.subTest(command):
                run = subprocess.run([PROGRAM, command, "--help"], capture_output=True, text=True, check=True)
                lines = [line.strip() for line in run.stdout.splitlines() if line.strip().startswith("-")]
                options = {option for line in lines for option in LONG_OPTION.findall(line.split("  ")[0])}
                self.assertIn("--help", options)
                self.assertEqual(complete(command, "-"), options)
                for option in options:
                    self.assertIn(option, page)


if __name__ == "__main__":
    unittest.main()
