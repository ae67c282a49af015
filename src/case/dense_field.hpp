#pragma once

#include "core/vec3.hpp"

#include <vector>

namespace vesica {

/// A field on a box of cells, z slowest, then y, x, components fastest.
struct DenseField {
    Vec3<int> size{};
    int components = 1;
    std::vector<double> values;
};

} // namespace vesica
