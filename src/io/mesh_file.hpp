#pragma once

#include "case/triangle_mesh.hpp"

#include <filesystem>

namespace vesica {

/// Reads the triangles of an STL file (text or binary) or a PLY file (text, or binary of either byte order;
/// faces with more than three corners are cut into fans). Vertices with equal coordinates become one and
/// vertices that no triangle uses are left out. The file's units are kept. Whether the triangles bound a
/// vesicle is for the shape to decide. Throws InputError, naming the file, the place in it and the remedy,
/// for files that do not exist, are not of these formats, are cut short, hold numbers that are not finite, or
/// are too large.
TriangleMesh read_triangle_mesh(const std::filesystem::path& file);

} // namespace vesica
