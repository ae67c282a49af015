#pragma once

#include "lattice/block.hpp"
#include "lattice/grid.hpp"
#include "lattice/velocity_set.hpp"

#include <cstdint>
#include <vector>

namespace vesica {

/// Which cells of a block are solid, its ghosts included. Per tile a byte, of which bit k stands for cell k.
class SolidCells {
public:
    SolidCells() = default;

    /// is_solid(cell of the periodic box)
    template <class IsSolid>
    SolidCells(const Block& block, const IsSolid& is_solid) {
        const Grid grid(block.own.size);
        bits_.assign(static_cast<std::size_t>(grid.tiles()), 0);
        for (int i = 0; i < direction_count; ++i)
            rows_[i] = grid.tile_offset(velocity(i, 1), velocity(i, 2));
        const Vec3<int> size = grid.size();
        for (int z = -1; z <= size.z; ++z)
            for (int y = -1; y <= size.y; ++y)
                for (int x = -1; x <= size.x; ++x) {
                    Vec3<int> place = Vec3<int>{x, y, z} + block.own.begin;
                    for (int a = 0; a < 3; ++a)
                        place[a] = (place[a] + block.box[a]) % block.box[a];
                    if (!is_solid(place))
                        continue;
                    const std::int64_t cell = grid.index(x, y, z);
                    bits_[static_cast<std::size_t>(cell / Grid::tile)] |=
                        static_cast<std::uint8_t>(1u << (cell % Grid::tile));
                }
    }

    /// The case has solids, if not in this block.
    explicit operator bool() const { return !bits_.empty(); }

    std::size_t bytes() const { return bits_.capacity(); }

    bool has(std::int64_t cell) const {
        return !bits_.empty() &&
               (bits_[static_cast<std::size_t>(cell / Grid::tile)] >> (cell % Grid::tile) & 1) != 0;
    }

    std::uint8_t of_tile(std::int64_t tile) const {
        return bits_.empty() ? std::uint8_t{0} : bits_[static_cast<std::size_t>(tile)];
    }

    /// Of `count` tiles one beside the other: bit k, whether cell k is solid.
    std::uint32_t of_tiles(std::int64_t tile, int count) const {
        std::uint32_t bits = 0;
        for (int k = 0; k < count; ++k)
            bits |= std::uint32_t{bits_[static_cast<std::size_t>(tile + k)]} << (k * Grid::tile);
        return bits;
    }

    /// The same of the cells' neighbours at velocity i.
    std::uint32_t beside_tiles(std::int64_t tile, int count, int i) const {
        std::uint32_t bits = 0;
        for (int k = 0; k < count; ++k)
            bits |= std::uint32_t{beside(tile + rows_[i] + k, velocity(i, 0))} << (k * Grid::tile);
        return bits;
    }

    /// Whether any neighbour of a tile's cells is solid.
    bool near(std::int64_t tile) const {
        for (int i = 1; i < direction_count && !bits_.empty(); ++i)
            if (beside(tile + rows_[i], velocity(i, 0)) != 0)
                return true;
        return false;
    }

private:
    std::uint8_t beside(std::int64_t tile, int dx) const {
        const auto at = static_cast<std::size_t>(tile);
        const unsigned here = bits_[at];
        if (dx > 0)
            return static_cast<std::uint8_t>(here >> 1 | (bits_[at + 1] & 1u) << (Grid::tile - 1));
        if (dx < 0)
            return static_cast<std::uint8_t>(here << 1 | bits_[at - 1] >> (Grid::tile - 1));
        return static_cast<std::uint8_t>(here);
    }

    std::vector<std::uint8_t> bits_;
    std::int64_t rows_[direction_count] = {};
};

} // namespace vesica
