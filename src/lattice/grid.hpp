#pragma once

#include "core/vec3.hpp"

#include <cassert>
#include <cstddef>
#include <cstdint>

namespace vesica {

/// How a box of cells lies in memory: rows along x, one ghost cell on each side of every axis. Rows are cut
/// into tiles of eight cells; the first tile of a row holds the ghost at x = -1 in its last cell, so that x =
/// 0 starts a tile, and there is room for one more tile after the last cell, so that shifted loads of whole
/// tiles stay inside.
class Grid {
public:
    static constexpr int tile = 8;

    Grid() = default;
    explicit Grid(const Vec3<int>& size)
        : size_(size), tiles_(1 + (size.x + tile - 1) / tile + 1), rows_y_(size.y + 2), rows_z_(size.z + 2) {
        assert(size.x > 0 && size.y > 0 && size.z > 0);
    }

    const Vec3<int>& size() const { return size_; }
    std::int64_t volume() const { return std::int64_t{size_.x} * size_.y * size_.z; }

    int tiles_per_row() const { return tiles_; }
    int row_stride() const { return tiles_ * tile; }
    std::int64_t plane_stride() const { return std::int64_t{row_stride()} * rows_y_; }
    int rows() const { return rows_y_ * rows_z_; }
    std::int64_t cells() const { return plane_stride() * rows_z_; }
    std::int64_t tiles() const { return cells() / tile; }

    /// Index of a cell; coordinates from -1 (ghost) to size (ghost).
    std::int64_t index(int x, int y, int z) const {
        return (std::int64_t{z + 1} * rows_y_ + (y + 1)) * row_stride() + tile + x;
    }
    std::int64_t index(const Vec3<int>& cell) const { return index(cell.x, cell.y, cell.z); }

    /// Step in index from a cell to its neighbour at (dx, dy, dz).
    std::int64_t offset(int dx, int dy, int dz) const {
        return dx + dy * std::int64_t{row_stride()} + dz * plane_stride();
    }

    /// The same step counted in tiles, for neighbours in other rows.
    std::int64_t tile_offset(int dy, int dz) const { return (dy + dz * std::int64_t{rows_y_}) * tiles_; }

    /// The coordinates of the first cell of a tile.
    Vec3<int> tile_origin(std::int64_t tile_index) const {
        const std::int64_t row = tile_index / tiles_;
        return {static_cast<int>(tile_index % tiles_ - 1) * tile, static_cast<int>(row % rows_y_) - 1,
                static_cast<int>(row / rows_y_) - 1};
    }

    bool is_interior_row(int y, int z) const { return y >= 0 && y < size_.y && z >= 0 && z < size_.z; }

    /// Which cells of a tile lie inside the box: bit k for cell k.
    std::uint8_t interior_bits(const Vec3<int>& origin) const {
        if (!is_interior_row(origin.y, origin.z))
            return 0;
        unsigned bits = 0;
        for (int k = 0; k < tile; ++k)
            if (origin.x + k >= 0 && origin.x + k < size_.x)
                bits |= 1u << k;
        return static_cast<std::uint8_t>(bits);
    }

private:
    Vec3<int> size_{};
    int tiles_ = 0;
    int rows_y_ = 0;
    int rows_z_ = 0;
};

} // namespace vesica
