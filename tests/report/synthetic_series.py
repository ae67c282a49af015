"""Surfaces as a run leaves them, made here: a hundred frames of a sphere of twenty thousand triangles that becomes flat."""

import numpy


def sphere(rings=101, around=101):
    """Points of a sphere in rings, and its triangles, outwards."""
    latitude = numpy.pi * numpy.arange(1, rings) / rings
    longitude = 2 * numpy.pi * numpy.arange(around) / around
    body = numpy.stack([numpy.outer(numpy.sin(latitude), numpy.cos(longitude)),
                        numpy.outer(numpy.sin(latitude), numpy.sin(longitude)),
                        numpy.repeat(numpy.cos(latitude)[:, None], around, axis=1)], axis=2).reshape(-1, 3)
    points = numpy.vstack([[[0, 0, 1]], body, [[0, 0, -1]]])
    ring, place = numpy.meshgrid(numpy.arange(rings - 2), numpy.arange(around), indexing="ij")
    a = 1 + ring * around + place
    b = 1 + ring * around + (place + 1) % around
    sides = numpy.concatenate([numpy.stack([a, a + around, b], axis=-1), numpy.stack([b, a + around, b + around], axis=-1)])
    edge = numpy.arange(around)
    following = (edge + 1) % around
    last = 1 + (rings - 2) * around
    caps = numpy.concatenate([numpy.stack([0 * edge, 1 + edge, 1 + following], axis=1),
                              numpy.stack([0 * edge + len(points) - 1, last + following, last + edge], axis=1)])
    return points, numpy.concatenate([sides.reshape(-1, 3), caps])


def write_surface(path, step, points, triangles, quantities):
    """Write VTK PolyData as src/io/surface_file.cpp does."""
    data = b""

    def tag(name, values, components=1):
        nonlocal data
        values = numpy.ascontiguousarray(values)
        kind = {"float32": "Float32", "float64": "Float64", "int32": "Int32", "int64": "Int64"}[values.dtype.name]
        text = (f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{components}" format="appended" '
                f'offset="{len(data)}"/>\n')
        data += numpy.uint64(values.nbytes).tobytes() + values.tobytes()
        return text

    text = ('<?xml version="1.0"?>\n<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt64">\n'
            '<PolyData>\n<FieldData>\n' + tag("TimeValue", numpy.array([float(step)])) + tag("step", numpy.array([step])) +
            f'</FieldData>\n<Piece NumberOfPoints="{len(points)}" NumberOfPolys="{len(triangles)}">\n<PointData>\n')
    for name, values in quantities.items():
        text += tag(name, values.astype("float32"), 1 if values.ndim == 1 else 3)
    text += "</PointData>\n<CellData>\n" + tag("vesicle", numpy.zeros(len(triangles), "int32"))
    text += "</CellData>\n<Points>\n" + tag("Points", points.astype("float32"), 3)
    text += "</Points>\n<Polys>\n" + tag("connectivity", triangles.astype("int64"))
    text += tag("offsets", 3 * (1 + numpy.arange(len(triangles), dtype="int64")))
    text += '</Polys>\n</Piece>\n</PolyData>\n<AppendedData encoding="raw">\n_'
    path.write_bytes(text.encode() + data + b"\n</AppendedData>\n</VTKFile>\n")


def write_series(directory, frames=100):
    """A run's directory with so many frames and as many samples."""
    (directory / "surfaces").mkdir(parents=True)
    points, triangles = sphere()
    noise = numpy.random.default_rng(1)
    rows = ["step,time,vesicle,area,bending_energy"]
    for frame in range(frames):
        step = 100 * frame
        flat = 1 - 0.6 * frame / frames
        shape = 32 + 15 * points * [1, 1, flat] * (1 + 2e-4 * noise.standard_normal((len(points), 1)))
        height = points[:, 2]
        write_surface(directory / "surfaces" / f"surface_{step:09}.vtp", step, shape, triangles, {
            "mean_curvature": 0.06 + 0.04 * height**2 * (1 - flat), "gaussian_curvature": 0.004 + 0.002 * height,
            "bending_force": 1e-5 * numpy.sin(5 * height), "tension_force": 1e-6 * height,
            "velocity": 1e-3 * points * flat + 1e-6 * noise.standard_normal(points.shape)})
        rows.append(f"{step},{step},0,{2800 + frame},{1 + 0.01 * frame}")
    (directory / "metrics.csv").write_text("\n".join(rows) + "\n")
    return len(triangles)
