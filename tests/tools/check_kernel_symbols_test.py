"""Only the entries of an instruction set may be visible."""

import unittest

from tests.tools.script import load

strangers = load("check-kernel-symbols").strangers

ENTRY = "0000000000000010 T _Z17run_isa_entry_avx2Rd"


class CheckKernelSymbols(unittest.TestCase):
    def others(self, line):
        return strangers(f"{ENTRY}\n{line}", "isa_entry_avx2")[1]

    def test_an_entry_is_recognised(self):
        self.assertEqual(strangers(ENTRY, "isa_entry_avx2"), (["T _Z17run_isa_entry_avx2Rd"], []))

    def test_an_inline_function_is_a_stranger(self):
        self.assertEqual(self.others("0000000000000000 W _ZNSt6vectorIdE4sizeEv"), ["W _ZNSt6vectorIdE4sizeEv"])

    def test_a_variable_is_a_stranger(self):
        self.assertEqual(self.others("0000000000000000 u counter"), ["u counter"])

    def test_an_entry_of_another_set_is_a_stranger(self):
        self.assertEqual(len(self.others("0000000000000000 T _Z17run_isa_entry_avx512Rd")), 1)


if __name__ == "__main__":
    unittest.main()
