#pragma once

#include "case/triangle_mesh.hpp"

#include <string>
#include <string_view>

namespace vesica {

bool is_ply(std::string_view contents);

/// Triangles of a PLY file's contents (Turk 1994): format ascii, binary_little_endian or
/// binary_big_endian 1.0; elements "vertex" with properties x, y, z and "face" with a list vertex_indices or
/// vertex_index; all other elements and properties are read over. Throws InputError.
TriangleMesh parse_ply(std::string_view contents, const std::string& source);

} // namespace vesica
