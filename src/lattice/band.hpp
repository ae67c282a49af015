#pragma once

#include "lattice/band_growth.hpp"
#include "lattice/block.hpp"
#include "lattice/grid.hpp"
#include "lattice/solid_cells.hpp"

#include <cstdint>
#include <vector>

namespace vesica {

/// One tile of a band: eight cells of which some belong to it.
struct BandTile {
    static constexpr int levels = BandGrowth::levels;

    std::int64_t cell = 0;     ///< index of its first cell in the grid
    std::int64_t tile = 0;     ///< index of the tile in the grid
    std::int32_t rows[9] = {}; ///< compact address of the tile below each (dy, dz), (dy + 1) + 3 (dz + 1)
    std::uint8_t bits[levels] = {}; ///< its fluid cells in level 0, 1, ...; cells of the box only, no ghosts
    bool beside_solid = false;      ///< a neighbour of one of its cells is solid
    bool followed = false; ///< the band's next tile lies beside it, and so it is in each of the nine rows

    /// Compact address of its first cell.
    std::int32_t slot() const { return rows[4]; }
};

/// The cells near an interface, found by growing a core of cells level by level along the lattice's own
/// links, and the compact storage of everything that is worked out there only: value `a + k` of a compact
/// array belongs to cell k of the tile whose compact address is `a`. Tiles that follow each other along x do
/// so in compact arrays as well, and one unused tile parts the runs, so that loads shifted by one cell stay
/// with their neighbours. Ghost cells at the block's faces have addresses of their own: those that stand for
/// cells of the same block are filled by copying, those of another process by what it sends.
class Band {
public:
    static constexpr int outermost = BandTile::levels - 1;
    using Seed = BandSeed;

    struct GhostCopy {
        std::int32_t from = 0;
        std::int32_t to = 0;
    };
    /// Compact addresses of the band's cells along one of the block's halo_parts: what goes to the neighbour
    /// there, and where what it sends belongs. The neighbour's lists of the opposite part have as many, in
    /// the same order.
    struct PartCells {
        std::vector<std::int32_t> rim;
        std::vector<std::int32_t> ghosts;
    };

    /// A fluid cell beside a solid one.
    struct FluidNeighbour {
        std::int32_t address = 0;
        std::int8_t direction = 0; ///< of the link that leads there
        std::int8_t level = 0;     ///< the lowest it belongs to
    };
    struct SolidCell {
        std::int32_t address = 0;
        std::uint32_t begin = 0; ///< of its share of fluid_neighbours()
        std::uint32_t end = 0;
    };

    Band() = default;
    explicit Band(const Grid& grid) : Band(Block::whole(grid.size())) {}
    /// `solids` may be null and must outlive the band. The band grows through solid cells, and lists their
    /// tiles, but they belong to no level.
    explicit Band(const Block& block, const SolidCells* solids = nullptr);

    /// Grows the band anew from its core. Seeds hold cells of the block, each tile at most once; with them
    /// the core of others, as far as it lies within BandGrowth::core_reach of the block.
    void rebuild(const std::vector<Seed>& core, const std::vector<ForeignSeed>& foreign = {});

    const Grid& grid() const { return grid_; }

    /// Tiles sorted as they lie in the grid.
    const std::vector<BandTile>& tiles() const { return tiles_; }
    /// Indices into tiles() of those that have cells in a level.
    const std::vector<std::int32_t>& of_level(int level) const { return of_level_[level]; }
    const std::vector<GhostCopy>& ghost_copies() const { return ghost_copies_; }
    /// One per halo part.
    const std::vector<PartCells>& part_cells() const { return part_cells_; }
    /// Like of_level: the tiles that hold cells of which other processes have ghosts, and the rest. Empty in
    /// a block that is the whole box.
    const std::vector<std::int32_t>& rim_of_level(int level) const { return rim_of_level_[level]; }
    const std::vector<std::int32_t>& inner_of_level(int level) const { return inner_of_level_[level]; }

    /// Length of a compact array.
    std::int64_t compact_size() const { return compact_size_; }
    /// Compact address of a tile of the grid, -1 outside the band.
    std::int32_t slot_of_tile(std::int64_t tile) const {
        return slot_of_tile_[static_cast<std::size_t>(tile)];
    }

    /// The block's solid cells that have fluid cells of the band beside them, and those.
    const std::vector<SolidCell>& solid_cells() const { return solid_cells_; }
    const std::vector<FluidNeighbour>& fluid_neighbours() const { return fluid_neighbours_; }

    /// Cells of all levels.
    std::int64_t cell_count() const { return cell_count_; }
    std::size_t bytes() const;

private:
    void clear();
    void lay_out();
    std::vector<std::int64_t> tiles_to_address() const;
    void list_tiles(const std::vector<std::int64_t>& members);
    void link(BandTile& tile) const;
    static bool follows(const BandTile& first, const BandTile& second);
    void list_ghost_copies(const std::vector<std::int64_t>& members);
    void list_part_cells();
    void separate_rim();
    void list_solid_cells();

    /// Cells of a tile of the grid that belong to the level and to the block.
    std::uint8_t own_bits(int level, std::int64_t tile) const {
        const Vec3<int> first = grid_.tile_origin(tile);
        const std::uint8_t inside = grid_.interior_bits(first);
        return inside == 0 ? std::uint8_t{0} : static_cast<std::uint8_t>(inside & growth_.bits(level, first));
    }

    std::int32_t address_of(const Vec3<int>& cell) const {
        const std::int64_t index = grid_.index(cell);
        return slot_of_tile(index / Grid::tile) + static_cast<std::int32_t>(index % Grid::tile);
    }

    Block block_;
    const SolidCells* solids_ = nullptr;
    Grid grid_;
    BandGrowth growth_;
    std::vector<HaloPart> parts_;
    std::vector<BandTile> tiles_;
    std::vector<std::int32_t> of_level_[BandTile::levels];
    std::vector<std::int32_t> rim_of_level_[BandTile::levels];
    std::vector<std::int32_t> inner_of_level_[BandTile::levels];
    std::vector<GhostCopy> ghost_copies_;
    std::vector<PartCells> part_cells_;
    std::vector<SolidCell> solid_cells_;
    std::vector<FluidNeighbour> fluid_neighbours_;
    std::vector<std::int32_t> slot_of_tile_;
    std::vector<std::int64_t> occupied_; ///< tiles that have an address
    std::int64_t compact_size_ = 0;
    std::int64_t cell_count_ = 0;
};

} // namespace vesica
