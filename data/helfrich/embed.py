#!/usr/bin/python3
"""Write src/shape/helfrich_table.cpp from helfrich_c0_0_fourier.json.

The table is committed; run this again only when the json changes:

    data/helfrich/embed.py > src/shape/helfrich_table.cpp
"""

import json
import pathlib
import sys

HERE = pathlib.Path(__file__).parent
# Below v = 0.5035 the oblate's poles pass through each other: such an entry is a solution, but no vesicle.
LOWEST = {"oblate": 0.52, "prolate": 0.5, "stomatocyte": 0.5}
# Mirror-symmetric shapes have even harmonics only.
STRIDE = {"oblate": 2, "prolate": 2, "stomatocyte": 1}


def entries(series, branch):
    """The branch's entries by falling reduced volume, coefficients dense in steps of the stride."""
    for name in sorted(series, key=lambda key: -float(key.split("_")[1])):
        if not name.startswith(branch + "_"):
            continue
        reduced_volume = float(name.split("_")[1])
        if reduced_volume < LOWEST[branch]:
            continue
        coefficients = dict(series[name]["a"])
        stride = STRIDE[branch]
        assert all(order % stride == 0 for order in coefficients), name
        dense = [coefficients.get(order, 0.0) for order in range(stride, max(coefficients) + 1, stride)]
        yield reduced_volume, series[name]["L"], dense


def rows(numbers, per_row=5):
    """Thirteen digits: the library corrects the reduced volume anyway."""
    for start in range(0, len(numbers), per_row):
        yield "    " + ", ".join(f"{number:.13g}" for number in numbers[start : start + per_row]) + ","


def main():
    series = json.loads((HERE / "helfrich_c0_0_fourier.json").read_text())
    out = sys.stdout.write
    out("// Written by data/helfrich/embed.py from data/helfrich/helfrich_c0_0_fourier.json; do not edit by hand.\n")
    out("// clang-format off\n")
    out('#include "shape/helfrich_table.hpp"\n\nnamespace vesica {\nnamespace {\n\n')
    for branch in STRIDE:
        found = list(entries(series, branch))
        flat = [number for _, _, dense in found for number in dense]
        out(f"constexpr double {branch}_coefficients[] = {{\n" + "\n".join(rows(flat)) + "\n};\n\n")
        out(f"constexpr HelfrichEntry {branch}_entries[] = {{\n")
        offset = 0
        for reduced_volume, length, dense in found:
            out(f"    {{{reduced_volume!r}, {length!r}, {{{branch}_coefficients + {offset}, {len(dense)}}}}},\n")
            offset += len(dense)
        out("};\n\n")
    out("} // namespace\n\nHelfrichBranchTable helfrich_table(HelfrichBranch branch)\n{\n    switch (branch) {\n")
    names = {"oblate": "discocyte", "prolate": "prolate", "stomatocyte": "stomatocyte"}
    for branch, stride in STRIDE.items():
        out(f"    case HelfrichBranch::{names[branch]}: return {{{stride}, {branch}_entries}};\n")
    out("    }\n    return {};\n}\n\n} // namespace vesica\n")


if __name__ == "__main__":
    main()
