#pragma once

#include "core/vec3.hpp"

#include <cstddef>
#include <cstdint>

namespace vesica {

/// A box of cells: those from `begin` to the one before begin + size, along each axis.
struct CellBox {
    Vec3<int> begin{};
    Vec3<int> size{};

    std::int64_t volume() const { return std::int64_t{size.x} * size.y * size.z; }

    /// Of one of its cells, in the order z, y, x.
    std::size_t index_of(const Vec3<int>& cell) const {
        const Vec3<int> at = cell - begin;
        return static_cast<std::size_t>(at.x + size.x * (at.y + std::int64_t{size.y} * at.z));
    }

    friend bool operator==(const CellBox&, const CellBox&) = default;
};

} // namespace vesica
