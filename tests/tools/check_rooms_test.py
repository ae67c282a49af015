"""The rooms' edges are enforced."""

import tempfile
import unittest
from pathlib import Path

from tests.tools.script import load

check_rooms = load("check-rooms")

LINES = "vesica_room(core)\nvesica_room(lattice    USES core)\nvesica_room(parallel USES lattice core)\n"


class CheckRooms(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        self.lines(LINES)

    def lines(self, text):
        (self.root / "CMakeLists.txt").write_text(text)

    def source(self, name, text):
        path = self.root / "src" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def test_a_listed_include_and_the_own_room_are_accepted(self):
        self.source("lattice/box.hpp", '#include "core/vec3.hpp"\n#include "lattice/field.hpp"\n#include <vector>\n')
        self.assertEqual(check_rooms.check_tree(self.root), [])

    def test_an_unlisted_include_is_refused_with_its_place(self):
        self.source("core/vec3.hpp", '#pragma once\n#include "lattice/box.hpp"\n')
        self.assertEqual(
            check_rooms.check_tree(self.root),
            ["src/core/vec3.hpp:2: core may not include lattice/box.hpp; its line lists nothing"],
        )

    def test_an_include_that_names_no_room_is_refused(self):
        self.source("core/vec3.cpp", '#include "vec3.hpp"\n')
        self.assertIn("does not name a room", check_rooms.check_tree(self.root)[0])

    def test_a_kernel_room_may_not_use_parallel(self):
        self.lines(LINES + "vesica_room(membrane USES parallel lattice core)\n")
        self.assertIn("the kernel room membrane must not use parallel", check_rooms.check_tree(self.root)[0])

    def test_a_cycle_is_refused(self):
        self.lines("vesica_room(core USES lattice)\nvesica_room(lattice USES core)\n")
        self.assertIn("core uses lattice, which is not declared above it", check_rooms.check_tree(self.root)[0])

    def test_a_room_may_not_use_itself(self):
        self.lines("vesica_room(core USES core)\n")
        self.assertIn("core uses core, which is not declared above it", check_rooms.check_tree(self.root)[0])

    def test_a_folder_without_a_line_is_refused(self):
        self.source("attic/old.hpp", "")
        self.assertIn("src/attic: no vesica_room line", check_rooms.check_tree(self.root)[0])

    def test_the_projects_own_lines_are_read(self):
        text = (Path(__file__).resolve().parents[2] / "CMakeLists.txt").read_text()
        rooms, errors = check_rooms.read_rooms(text)
        self.assertEqual(errors, [])
        self.assertEqual(len(rooms), text.count("\nvesica_room("))
        self.assertIn("geometry", rooms["membrane"])


if __name__ == "__main__":
    unittest.main()
