#pragma once

#include "core/vec3.hpp"

#include <array>
#include <string>
#include <vector>

namespace vesica {

/// A surface of triangles; corners run counter-clockwise as seen from outside.
struct TriangleMesh {
    std::vector<Vec3<double>> vertices;
    std::vector<std::array<int, 3>> triangles; ///< indices into vertices, from 0
    std::string source;                        ///< the file it was read from, for messages
};

} // namespace vesica
