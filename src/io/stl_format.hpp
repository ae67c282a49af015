#pragma once

#include "case/triangle_mesh.hpp"

#include <string>
#include <string_view>

namespace vesica {

/// Triangles of an STL file's contents, each with vertices of its own; text if it starts with "solid" and
/// holds "facet", binary (80 bytes, a count, 50 bytes per triangle, little endian) otherwise. Normals and
/// attributes are ignored: the order of the corners says what is outside. Throws InputError.
TriangleMesh parse_stl(std::string_view contents, const std::string& source);

} // namespace vesica
