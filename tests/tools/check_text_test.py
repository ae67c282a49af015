"""What must not stand in the project's files is refused."""

import unittest

from tests.tools.script import load

check_text = load("check-text").check_text


class CheckText(unittest.TestCase):
    def refused(self, name, text, message):
        errors = check_text(name, text)
        self.assertEqual(len(errors), 1, errors)
        self.assertIn(message, errors[0])

    def test_ordinary_text_is_accepted(self):
        self.assertEqual(check_text("docs/a.md", "See https://example.org/work/a and ${HOME}/work/b.\n"), [])

    def test_a_path_of_one_machine_is_refused_with_its_place(self):
        self.refused("docs/a.md", "fine\nin /wo" "rk/main\n", "docs/a.md:2: /wo" "rk/ is a path of one machine")
        self.refused("docs/a.md", "/tmp/te" "am/brief", "a path of one machine")
        self.refused("docs/a.md", "/ho" "me/someone/vesica", "a path of one machine")

    def test_a_number_of_a_tracker_is_refused(self):
        self.refused("CHANGELOG.md", "closes issue" " #12", "a number of a tracker")

    def test_a_note_for_later_is_refused(self):
        self.refused("src/core/a.hpp", "// TO" "DO: more", "a note for later")
        self.refused("src/core/a.hpp", "// FIX" "ME", "a note for later")

    def test_four_hundred_lines_are_accepted_and_one_more_is_refused(self):
        self.assertEqual(check_text("src/core/a.hpp", "\n" * 400), [])
        self.refused("src/core/a.hpp", "\n" * 401, "split it")
        self.assertEqual(check_text("docs/a.md", "\n" * 401), [])

    def test_a_name_that_says_nothing_is_refused(self):
        for name in ("src/core/utils.hpp", "src/io/helpers.cpp", "tests/io/common_test.cpp", "tools/types.py"):
            self.refused(name, "", "the name says nothing")


if __name__ == "__main__":
    unittest.main()
