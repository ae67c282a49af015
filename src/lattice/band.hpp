#pragma once

#include "lattice/grid.hpp"

#include <cstdint>
#include <vector>

namespace vesica {

/// One tile of a band: eight cells of which some belong to it.
struct BandTile {
    static constexpr int levels = 10;

    std::int64_t cell = 0;     ///< index of its first cell in the grid
    std::int64_t tile = 0;     ///< index of the tile in the grid
    std::int32_t rows[9] = {}; ///< compact address of the tile below each (dy, dz), (dy + 1) + 3 (dz + 1)
    std::uint8_t bits[levels] = {}; ///< its cells in level 0, 1, ...; cells of the box only, no ghosts
    bool followed = false; ///< the band's next tile lies beside it, and so it is in each of the nine rows

    /// Compact address of its first cell.
    std::int32_t slot() const { return rows[4]; }
};

/// The cells near an interface, found by growing a core of cells level by level along the lattice's own
/// links, and the compact storage of everything that is worked out there only: value `a + k` of a compact
/// array belongs to cell k of the tile whose compact address is `a`. Tiles that follow each other along x do
/// so in compact arrays as well, and one unused tile parts the runs, so that loads shifted by one cell stay
/// with their neighbours. Ghost cells at the box's periodic faces have addresses of their own and are filled
/// by copying.
class Band {
public:
    static constexpr int outermost = BandTile::levels - 1;

    /// Core cells of a tile of the grid.
    struct Seed {
        std::int64_t tile = 0;
        std::uint8_t bits = 0;
    };
    struct GhostCopy {
        std::int32_t from = 0;
        std::int32_t to = 0;
    };

    Band() = default;
    explicit Band(const Grid& grid);

    /// Grows the band anew from its core. Seeds hold cells of the box, each tile at most once.
    void rebuild(const std::vector<Seed>& core);

    const Grid& grid() const { return grid_; }

    /// Tiles sorted as they lie in the grid.
    const std::vector<BandTile>& tiles() const { return tiles_; }
    /// Indices into tiles() of those that have cells in a level.
    const std::vector<std::int32_t>& of_level(int level) const { return of_level_[level]; }
    const std::vector<GhostCopy>& ghost_copies() const { return ghost_copies_; }

    /// Length of a compact array.
    std::int64_t compact_size() const { return compact_size_; }
    /// Compact address of a tile of the grid, -1 outside the band.
    std::int32_t slot_of_tile(std::int64_t tile) const {
        return slot_of_tile_[static_cast<std::size_t>(tile)];
    }

    /// Cells of all levels.
    std::int64_t cell_count() const { return cell_count_; }
    std::size_t bytes() const;

private:
    using Bits = std::vector<std::uint8_t>;

    void clear();
    void grow(int level);
    void spread(std::int64_t row_tile, int tile_in_row, std::uint8_t bits, bool sideways, int level);
    void mark(int level, std::int64_t tile, std::uint8_t bits);
    void lay_out();
    void place_ghosts(std::vector<std::int64_t>& members) const;
    void list_ghost_copies();
    void link(BandTile& tile) const;
    static bool follows(const BandTile& first, const BandTile& second);

    Grid grid_;
    std::vector<BandTile> tiles_;
    std::vector<std::int32_t> of_level_[BandTile::levels];
    std::vector<GhostCopy> ghost_copies_;
    std::vector<std::int32_t> slot_of_tile_;
    std::vector<std::int64_t> occupied_; ///< tiles that have an address
    std::vector<std::int64_t> marked_[BandTile::levels];
    Bits level_bits_[BandTile::levels];
    std::int64_t compact_size_ = 0;
    std::int64_t cell_count_ = 0;
};

} // namespace vesica
