#!/usr/bin/python3
"""Writes cases/torus.ply: the circular torus of the volume of a sphere of R = 15 and 1.31 times its area, axis z."""

import math
from pathlib import Path

import numpy

CASE = Path(__file__).resolve().parent / "cases" / "torus.toml"
MESH = CASE.with_suffix(".ply")
RADIUS, DEFLATION = 15.0, 1.31
AROUND, TUBE = 96, 48


def write_torus():
    volume, area = 4 / 3 * math.pi * RADIUS**3, DEFLATION * 4 * math.pi * RADIUS**2
    tube = 2 * volume / area
    ring = volume / (2 * math.pi**2 * tube**2)
    u, w = numpy.meshgrid(2 * math.pi * numpy.arange(AROUND) / AROUND, 2 * math.pi * numpy.arange(TUBE) / TUBE, indexing="ij")
    r = ring + tube * numpy.cos(w)
    points = numpy.stack((r * numpy.cos(u), r * numpy.sin(u), tube * numpy.sin(w)), axis=-1).reshape(-1, 3)
    lines = ["ply", "format ascii 1.0", f"element vertex {AROUND * TUBE}", "property float x", "property float y", "property float z",
             f"element face {2 * AROUND * TUBE}", "property list uchar int vertex_indices", "end_header"]  # fmt: skip
    lines += [" ".join(f"{c:.5f}" for c in p) for p in points]
    for i in range(AROUND):
        for j in range(TUBE):
            a, b = i * TUBE + j, (i + 1) % AROUND * TUBE + j
            c, d = (i + 1) % AROUND * TUBE + (j + 1) % TUBE, i * TUBE + (j + 1) % TUBE
            lines += [f"3 {a} {b} {c}", f"3 {a} {c} {d}"]
    MESH.write_text("\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    write_torus()
