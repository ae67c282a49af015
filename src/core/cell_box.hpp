#pragma once

#include "core/vec3.hpp"

#include <cstdint>

namespace vesica {

/// A box of cells: those from `begin` to the one before begin + size, along each axis.
struct CellBox {
    Vec3<int> begin{};
    Vec3<int> size{};

    std::int64_t volume() const { return std::int64_t{size.x} * size.y * size.z; }

    friend bool operator==(const CellBox&, const CellBox&) = default;
};

} // namespace vesica
