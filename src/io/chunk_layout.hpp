#pragma once

#include "core/cell_box.hpp"

#include <cstdint>

namespace vesica {

/// How an array over a box is cut into chunks that are compressed one by one: whole x-y planes, or where one
/// plane is much by itself whole rows of it, of about 256 kB. It depends on the array alone, not on who has
/// which part of it. Chunks along the box's upper ends reach beyond it.
class ChunkLayout {
public:
    /// `width` bytes an element.
    ChunkLayout(const Vec3<int>& box, std::size_t width);

    Vec3<int> edges() const { return edges_; }
    std::int64_t count() const { return std::int64_t{across_.y} * across_.z; }
    /// Bytes of a chunk, with what lies beyond the box.
    std::size_t bytes() const { return static_cast<std::size_t>(CellBox{{}, edges_}.volume()) * width_; }
    Vec3<int> begin(std::int64_t chunk) const;
    /// Its elements within the box.
    CellBox elements(std::int64_t chunk) const;

private:
    Vec3<int> box_;
    std::size_t width_;
    Vec3<int> edges_;
    Vec3<int> across_; ///< chunks along each axis
};

/// What two boxes have in common; of no volume where that is nothing.
CellBox common(const CellBox& a, const CellBox& b);

} // namespace vesica
