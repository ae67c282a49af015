#pragma once

#include "lattice/block.hpp"
#include "lattice/grid.hpp"

#include <cstdint>
#include <vector>

namespace vesica {

/// Core cells of a tile of a block's grid.
struct BandSeed {
    std::int64_t tile = 0;
    std::uint8_t bits = 0;
};

/// Core cells of another process: eight in a row, from a place in the whole box.
struct ForeignSeed {
    Vec3<int> first{};
    std::uint32_t bits = 0;
};

/// Whether one of the eight cells from `first`, or an image of it, lies near enough to a block for its band.
bool matters_to(const Block& block, const Vec3<int>& first);

/// Grows a core of cells level by level along the lattice's own links, in a block and, across its divided
/// axes, as far beyond it as cells may matter to it.
class BandGrowth {
public:
    static constexpr int levels = 10;
    static constexpr int outermost = levels - 1;
    /// Cores farther than this from a block do not matter to it or its ghosts.
    static constexpr int core_reach = outermost + 1;

    BandGrowth() = default;
    explicit BandGrowth(const Block& block);

    /// Seeds hold cells of the block, each tile at most once.
    /// Where the box slides, `slid` are the whole cells that the images above have moved on.
    void grow(const std::vector<BandSeed>& core, const std::vector<ForeignSeed>& foreign, int slid = 0);
    void forget();

    /// Cells of the level in the tile that begins at this place of the block or of its ghosts: a multiple of
    /// eight along x, within the row.
    std::uint8_t bits(int level, const Vec3<int>& first) const {
        return level_bits_[level][static_cast<std::size_t>(tile_at(block_.home(first)))];
    }
    bool has(int level, const Vec3<int>& cell) const {
        const Vec3<int> home = block_.home(cell);
        const int k = home.x & (Grid::tile - 1);
        return (level_bits_[level][static_cast<std::size_t>(tile_at({home.x - k, home.y, home.z}))] >> k &
                1) != 0;
    }

    /// Where tiles begin that hold cells of the outermost level, each once, in no order.
    template <class Body>
    void for_each_tile(const Body& body) const {
        for (const std::int64_t t : marked_[outermost])
            body(wide_.tile_origin(t) - margin_);
    }

    std::size_t bytes() const;

private:
    void mark(int level, std::int64_t tile, std::uint8_t bits);
    void mark_cell(int level, std::int64_t row_tile, int x);
    void mark_images(const Vec3<int>& cell, int slid);
    bool near_sliding_face(const Vec3<int>& cell) const;
    void mark_beside(Vec3<int> place);
    void grow_level(int level);
    void spread(std::int64_t row_tile, int tile_in_row, std::uint8_t bits, bool sideways, int level);

    /// From the block's coordinates, the tile of the wide grid.
    std::int64_t tile_at(const Vec3<int>& first) const { return wide_.index(first + margin_) / Grid::tile; }

    Block block_;
    Vec3<int> margin_{}; ///< whole tiles along x
    Grid wide_;          ///< the block and its margin
    std::vector<std::int64_t> marked_[levels];
    std::vector<std::uint8_t> level_bits_[levels];
};

} // namespace vesica
