#pragma once

#include "lattice/block.hpp"
#include "lattice/grid.hpp"

#include <cstdint>
#include <vector>

namespace vesica {

/// Core cells of a tile of a block's grid, of the vesicle that `label` stands for.
struct BandSeed {
    std::int64_t tile = 0;
    std::uint8_t bits = 0;
    std::int32_t label = 0;
};

/// Core cells of another process: eight in a row, from a place in the whole box.
struct ForeignSeed {
    Vec3<int> first{};
    std::uint32_t bits = 0;
    std::int32_t label = 0;
};

/// Whether one of the eight cells from `first`, or an image of it, lies near enough to a block for its band.
bool matters_to(const Block& block, const Vec3<int>& first);

/// Grows the cores of labels level by level along the lattice's own links, in a block and, across its divided
/// axes, as far beyond it as cells may matter to it. Each label grows by itself: where bands overlap a cell
/// belongs to several.
class BandGrowth {
public:
    static constexpr int levels = 9;
    static constexpr int outermost = levels - 1;
    /// Cores farther than this from a block do not matter to it or its ghosts.
    static constexpr int core_reach = outermost + 1;

    BandGrowth() = default;
    explicit BandGrowth(const Block& block);

    /// Seeds hold cells of the block, each tile at most once per label.
    /// Where the box slides, `slid` are the whole cells that the images above have moved on.
    void grow(const std::vector<BandSeed>& core, const std::vector<ForeignSeed>& foreign, int slid = 0);
    void forget();

    /// Cells of the level in the tile that begins at this place of the block or of its ghosts: a multiple of
    /// eight along x, within the row.
    std::uint8_t bits(int level, const Vec3<int>& first, int label) const {
        const std::int32_t node = find(tile_at(block_.home(first)), label);
        return node < 0 ? std::uint8_t{0} : node_at(node).bits[level];
    }
    bool has(int level, const Vec3<int>& cell, int label) const {
        const Vec3<int> home = block_.home(cell);
        const int k = home.x & (Grid::tile - 1);
        return (bits(level, {home.x - k, home.y, home.z}, label) >> k & 1) != 0;
    }
    /// body(label) for those that have the cell in their outermost level, in ascending order.
    template <class Body>
    void for_each_label(const Vec3<int>& cell, const Body& body) const {
        const Vec3<int> home = block_.home(cell);
        const int k = home.x & (Grid::tile - 1);
        const std::int64_t tile = tile_at({home.x - k, home.y, home.z});
        for (std::int32_t node = first_[static_cast<std::size_t>(tile)]; node >= 0; node = node_at(node).next)
            if ((node_at(node).bits[outermost] >> k & 1) != 0)
                body(static_cast<int>(node_at(node).label));
    }

    /// body(place, label): where tiles begin that hold cells of the outermost level, each once per label, in
    /// no order.
    template <class Body>
    void for_each_tile(const Body& body) const {
        for (const std::int32_t node : marked_[outermost])
            body(wide_.tile_origin(node_at(node).tile) - margin_, static_cast<int>(node_at(node).label));
    }

    std::size_t bytes() const;

private:
    /// What a label has in a tile, level by level.
    struct Node {
        std::int64_t tile = 0;
        std::int32_t label = 0;
        std::int32_t next = -1; ///< of the same tile, with a higher label
        std::uint8_t bits[levels] = {};
    };

    /// -1: none.
    std::int32_t find(std::int64_t tile, int label) const {
        std::int32_t node = first_[static_cast<std::size_t>(tile)];
        while (node >= 0 && node_at(node).label < label)
            node = node_at(node).next;
        return node >= 0 && node_at(node).label == label ? node : -1;
    }
    std::int32_t find_or_add(std::int64_t tile, int label);
    const Node& node_at(std::int32_t node) const { return nodes_[static_cast<std::size_t>(node)]; }

    void mark(int level, std::int64_t tile, std::uint8_t bits, int label);
    void mark_cell(int level, std::int64_t row_tile, int x, int label);
    void mark_images(const Vec3<int>& cell, int slid, int label);
    bool near_sliding_face(const Vec3<int>& cell) const;
    void mark_beside(Vec3<int> place, int label);
    void grow_level(int level);
    void spread(std::int64_t row_tile, int tile_in_row, std::uint8_t bits, bool sideways, int level,
                int label);

    /// From the block's coordinates, the tile of the wide grid.
    std::int64_t tile_at(const Vec3<int>& first) const { return wide_.index(first + margin_) / Grid::tile; }

    Block block_;
    Vec3<int> margin_{};              ///< whole tiles along x
    Grid wide_;                       ///< the block and its margin
    std::vector<std::int32_t> first_; ///< per tile: its node with the lowest label, -1 if it has none
    std::vector<Node> nodes_;
    std::vector<std::int32_t> marked_[levels]; ///< nodes with cells in the level
};

} // namespace vesica
