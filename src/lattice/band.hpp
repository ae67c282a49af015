#pragma once

#include "lattice/band_growth.hpp"
#include "lattice/block.hpp"
#include "lattice/grid.hpp"
#include "lattice/sliding_faces.hpp"
#include "lattice/solid_cells.hpp"

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace vesica {

/// One tile of a label's band: eight cells of which some belong to it.
struct BandTile {
    static constexpr int levels = BandGrowth::levels;

    std::int64_t cell = 0;     ///< index of its first cell in the grid
    std::int64_t tile = 0;     ///< index of the tile in the grid
    std::int32_t label = 0;    ///< of the vesicle
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
/// so in compact arrays as well. A load shifted by one cell reaches, at the end of such a run, some other
/// cell of the band: only cells of the outermost level have neighbours there. Ghost cells at the block's
/// faces have addresses of their own: those that stand for cells of the same block are filled by copying,
/// those of another process by what it sends.
///
/// Each vesicle, by its label, has a band of its own. Where they overlap a tile is listed, and has compact
/// addresses, once for each.
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

    /// A ghost cell beyond a sliding face: between cells of the image there.
    struct SlidGhost {
        static constexpr std::int32_t pure_blue = -1; ///< a cell outside its label's band
        static constexpr std::int32_t pure_red = -2;

        std::int32_t to = 0;
        std::array<std::int32_t, Displacement::reads> from{};
        std::array<std::uint8_t, Displacement::reads> level{}; ///< the lowest that cell belongs to
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

    /// Grows the band anew from its core. Seeds hold cells of the block, each tile at most once per label;
    /// with them the core of others, as far as it lies within BandGrowth::core_reach of the block.
    /// Where the box slides, `slid` are the whole cells that the images above have moved on; then join() has
    /// to be called for each part that slides.
    void rebuild(const std::vector<Seed>& core, const std::vector<ForeignSeed>& foreign = {}, int slid = 0);

    /// What a neighbour beyond a sliding face must know of a cell along it.
    struct RimCell {
        std::int32_t cell = 0; ///< of the rim's home cells, in the order z, y, x
        std::int32_t label = 0;
        std::int32_t level =
            0; ///< the lowest it belongs to; outside_level: none, but it lies inside that vesicle
    };
    static constexpr std::int32_t outside_level = outermost + 1;
    /// Those of a part, ascending by cell and label. `owner_of` has, for a cell of the grid, the label of the
    /// vesicle inside which it lies beyond that one's band, or -1.
    std::vector<RimCell> rim_cells(std::size_t part, const std::function<int(std::int64_t)>& owner_of) const;
    /// The rim of the neighbour at that part.
    void join(std::size_t part, std::span<const RimCell> rim);

    const Grid& grid() const { return grid_; }

    /// Tiles sorted by the rows they lie in, then by label, then along the row.
    const std::vector<BandTile>& tiles() const { return tiles_; }
    /// Whether one comes before the other in such a list.
    bool precedes(const BandTile& a, const BandTile& b) const { return key_of(a) < key_of(b); }
    /// Indices into tiles() of those that have cells in a level.
    const std::vector<std::int32_t>& of_level(int level) const { return of_level_[level]; }
    const std::vector<GhostCopy>& ghost_copies() const { return ghost_copies_; }
    /// One per halo part. What arrives through a sliding face are cells of the image there, not ghosts.
    const std::vector<PartCells>& part_cells() const { return part_cells_; }
    /// Like of_level: the tiles that hold cells of which other processes have ghosts, and the rest. Empty in
    /// a block that meets no others, nor images of its own that slide.
    const std::vector<std::int32_t>& rim_of_level(int level) const { return rim_of_level_[level]; }
    const std::vector<std::int32_t>& inner_of_level(int level) const { return inner_of_level_[level]; }

    /// Length of a compact array.
    std::int64_t compact_size() const { return compact_size_; }
    /// Compact address of a tile of the grid, -1 outside the label's band.
    std::int32_t slot_of_tile(std::int64_t tile, int label) const {
        std::int32_t at = first_place_[static_cast<std::size_t>(tile)];
        while (at >= 0 && places_[static_cast<std::size_t>(at)].label < label)
            at = places_[static_cast<std::size_t>(at)].next;
        return at >= 0 && places_[static_cast<std::size_t>(at)].label == label
                   ? places_[static_cast<std::size_t>(at)].slot
                   : -1;
    }
    /// body(label, compact address) for all that have one for a tile of the grid, in ascending order.
    template <class Body>
    void for_each_label(std::int64_t tile, const Body& body) const {
        for (std::int32_t at = first_place_[static_cast<std::size_t>(tile)]; at >= 0;
             at = places_[static_cast<std::size_t>(at)].next)
            body(static_cast<int>(places_[static_cast<std::size_t>(at)].label),
                 places_[static_cast<std::size_t>(at)].slot);
    }
    /// Tiles that have compact addresses for several labels, ascending.
    const std::vector<std::int64_t>& shared_tiles() const { return shared_tiles_; }

    /// The block's solid cells that have fluid cells of the band beside them, and those.
    const std::vector<SolidCell>& solid_cells() const { return solid_cells_; }
    const std::vector<FluidNeighbour>& fluid_neighbours() const { return fluid_neighbours_; }

    const std::vector<SlidGhost>& slid_ghosts() const { return slid_ghosts_; }

    /// Cells of all levels.
    std::int64_t cell_count() const { return cell_count_; }
    std::size_t bytes() const;

private:
    void clear();
    /// A tile of a label that needs an address, in the order of addresses.
    struct Member {
        std::int64_t row = 0;
        std::int32_t label = 0;
        std::int64_t tile = 0;

        friend auto operator<=>(const Member&, const Member&) = default;
    };
    /// The address of a tile of a label.
    struct Place {
        std::int32_t label = 0;
        std::int32_t slot = 0;
        std::int32_t next = -1; ///< of the same tile, with a higher label
    };

    Member key_of(const BandTile& t) const { return member(t.tile, t.label); }
    Member member(std::int64_t tile, int label) const { return {tile / grid_.tiles_per_row(), label, tile}; }
    void lay_out();
    std::vector<Member> tiles_to_address() const;
    void place(const Member& member, std::int32_t slot);
    void list_tiles(const std::vector<Member>& members);
    void link(BandTile& tile) const;
    /// That the cell belongs to, while the band is being laid out; one more than outermost outside.
    int lowest_level(const Vec3<int>& cell, int label) const {
        int level = 0;
        while (level <= outermost && !growth_.has(level, cell, label))
            ++level;
        return level;
    }
    static bool follows(const BandTile& first, const BandTile& second);
    void list_ghost_copies(const std::vector<Member>& members);
    void list_part_cells();
    CellBox home_cells(CellBox box) const;
    void separate_rim();
    void list_solid_cells();

    /// Cells of a tile of the grid that belong to the label's level and to the block.
    std::uint8_t own_bits(int level, std::int64_t tile, int label) const {
        const Vec3<int> first = grid_.tile_origin(tile);
        const std::uint8_t inside = grid_.interior_bits(first);
        return inside == 0 ? std::uint8_t{0}
                           : static_cast<std::uint8_t>(inside & growth_.bits(level, first, label));
    }

    std::int32_t address_of(const Vec3<int>& cell, int label) const {
        const std::int64_t index = grid_.index(cell);
        return slot_of_tile(index / Grid::tile, label) + static_cast<std::int32_t>(index % Grid::tile);
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
    /// A ghost beyond a sliding face before it is known what lies there.
    struct SlidPlace {
        std::size_t part = 0;
        Vec3<int> home{};
        std::int32_t to = 0;
        std::int32_t label = 0;
    };
    std::vector<SlidPlace> slid_places_;
    std::vector<std::vector<RimCell>> rim_cells_; ///< per part, of those that slide: those within a band
    std::vector<SlidGhost> slid_ghosts_;
    int slid_ = 0;
    std::vector<SolidCell> solid_cells_;
    std::vector<FluidNeighbour> fluid_neighbours_;
    std::vector<std::int32_t> first_place_; ///< per tile: of its lowest label, -1 if it has no address
    std::vector<Place> places_;
    std::vector<std::int64_t> occupied_; ///< tiles that have an address
    std::vector<std::int64_t> shared_tiles_;
    std::int64_t compact_size_ = 0;
    std::int64_t cell_count_ = 0;
};

} // namespace vesica
