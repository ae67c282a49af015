#include "lattice/band.hpp"

#include <algorithm>
#include <bit>
#include <tuple>
#include <utility>

namespace vesica {

namespace {

constexpr int tile = Grid::tile;

} // namespace

Band::Band(const Block& block, const SolidCells* solids)
    : block_(block),
      solids_(solids),
      grid_(block.own.size),
      growth_(block),
      parts_(halo_parts(block)),
      first_place_(static_cast<std::size_t>(grid_.tiles()), -1) {}

void Band::rebuild(const std::vector<Seed>& core, const std::vector<ForeignSeed>& foreign, int slid) {
    clear();
    slid_ = slid;
    growth_.grow(core, foreign, slid);
    lay_out();
    growth_.forget();
}

void Band::clear() {
    for (const std::int64_t t : occupied_)
        first_place_[static_cast<std::size_t>(t)] = -1;
    occupied_.clear();
    places_.clear();
    shared_tiles_.clear();
    tiles_.clear();
    ghost_copies_.clear();
    part_cells_.clear();
    slid_ghosts_.clear();
    slid_places_.clear();
    rim_cells_.clear();
    solid_cells_.clear();
    fluid_neighbours_.clear();
    for (int level = 0; level <= outermost; ++level) {
        of_level_[level].clear();
        rim_of_level_[level].clear();
        inner_of_level_[level].clear();
    }
}

/// The tiles of the band in the block, and those of its ghosts that stand for cells of the band.
std::vector<Band::Member> Band::tiles_to_address() const {
    std::vector<Member> members;
    const Vec3<int> size = grid_.size();
    const auto add_row = [&](const Vec3<int>& first, int y, int z, int label) {
        const std::uint8_t bits = growth_.bits(outermost, first, label);
        if (block_.divided.x) {
            // The ghosts at the row's ends are cells of the margin: a tile may hold some of either.
            unsigned within = 0;
            for (int k = 0; k < tile; ++k)
                if (first.x + k >= -1 && first.x + k <= size.x)
                    within |= 1u << k;
            if ((bits & within) != 0)
                members.push_back(member(grid_.index(first.x, y, z) / tile, label));
            return;
        }
        const int last = std::min(tile, size.x - first.x) - 1;
        members.push_back(member(grid_.index(first.x, y, z) / tile, label));
        if (first.x == 0 && (bits & 1u) != 0)
            members.push_back(member(grid_.index(size.x, y, z) / tile, label));
        if (first.x + last == size.x - 1 && (bits >> last & 1u) != 0)
            members.push_back(member(grid_.index(-tile, y, z) / tile, label));
    };
    growth_.for_each_tile([&](const Vec3<int>& first, int label) {
        for (int dz = -1; dz <= 1; ++dz)
            for (int dy = -1; dy <= 1; ++dy) {
                const int y = first.y + dy * size.y;
                const int z = first.z + dz * size.z;
                const bool image_of_other = (dy != 0 && block_.divided.y) || (dz != 0 && block_.divided.z);
                if (!image_of_other && y >= -1 && y <= size.y && z >= -1 && z <= size.z)
                    add_row(first, y, z, label);
            }
    });
    std::sort(members.begin(), members.end());
    members.erase(std::unique(members.begin(), members.end()), members.end());
    return members;
}

void Band::lay_out() {
    const std::vector<Member> members = tiles_to_address();
    // Addresses: tiles 1 and 2 stand for everything outside the band, with an unused tile on either side.
    std::int64_t address = 4 * tile;
    tiles_.reserve(members.size());
    places_.reserve(members.size());
    occupied_.reserve(members.size());
    Member previous{0, -1, -2};
    for (const Member& next : members) {
        // Whoever looks at two tiles at once must see that they are not one vesicle's.
        if (next.label != previous.label && next.tile == previous.tile + 1)
            address += tile;
        place(next, static_cast<std::int32_t>(address));
        address += tile;
        previous = next;
    }
    compact_size_ = address + tile;
    std::sort(shared_tiles_.begin(), shared_tiles_.end());
    shared_tiles_.erase(std::unique(shared_tiles_.begin(), shared_tiles_.end()), shared_tiles_.end());
    list_tiles(members);
    list_ghost_copies(members);
    if (solids_ != nullptr)
        list_solid_cells();
    if (parts_.empty())
        return;
    list_part_cells();
    separate_rim();
}

/// Members come with ascending labels.
void Band::place(const Member& added, std::int32_t slot) {
    std::int32_t& first = first_place_[static_cast<std::size_t>(added.tile)];
    const auto index = static_cast<std::int32_t>(places_.size());
    places_.push_back({added.label, slot, -1});
    if (first < 0) {
        first = index;
        occupied_.push_back(added.tile);
        return;
    }
    std::int32_t last = first;
    while (places_[static_cast<std::size_t>(last)].next >= 0)
        last = places_[static_cast<std::size_t>(last)].next;
    places_[static_cast<std::size_t>(last)].next = index;
    shared_tiles_.push_back(added.tile);
}

void Band::list_tiles(const std::vector<Member>& members) {
    cell_count_ = 0;
    for (const Member& member : members) {
        const std::int64_t t = member.tile;
        if (own_bits(outermost, t, member.label) == 0)
            continue;
        BandTile band_tile;
        band_tile.tile = t;
        band_tile.label = member.label;
        band_tile.cell = t * tile;
        for (int level = 0; level <= outermost; ++level) {
            const std::uint8_t grown = own_bits(level, t, member.label);
            if (grown != 0)
                of_level_[level].push_back(static_cast<std::int32_t>(tiles_.size()));
            band_tile.bits[level] =
                solids_ != nullptr ? static_cast<std::uint8_t>(grown & ~solids_->of_tile(t)) : grown;
        }
        band_tile.beside_solid = solids_ != nullptr && solids_->near(t);
        cell_count_ += std::popcount(band_tile.bits[outermost]);
        link(band_tile);
        if (!tiles_.empty())
            tiles_.back().followed = follows(tiles_.back(), band_tile);
        tiles_.push_back(band_tile);
    }
}

void Band::link(BandTile& band_tile) const {
    for (int dz = -1; dz <= 1; ++dz)
        for (int dy = -1; dy <= 1; ++dy) {
            const std::int32_t slot =
                slot_of_tile(band_tile.tile + grid_.tile_offset(dy, dz), band_tile.label);
            band_tile.rows[(dy + 1) + 3 * (dz + 1)] = slot >= 0 ? slot : tile;
        }
}

bool Band::follows(const BandTile& first, const BandTile& second) {
    if (second.label != first.label || second.tile != first.tile + 1)
        return false;
    for (int row = 0; row < 9; ++row)
        if (second.rows[row] != (first.rows[row] == tile ? tile : first.rows[row] + tile))
            return false;
    return true;
}

/// Ghosts that stand for cells of this block.
void Band::list_ghost_copies(const std::vector<Member>& members) {
    const Vec3<int> size = grid_.size();
    const auto is_outside = [&](const Vec3<int>& cell, int axis) {
        return cell[axis] < 0 || cell[axis] >= size[axis];
    };
    for (const auto& [row, label, t] : members) {
        const Vec3<int> first = grid_.tile_origin(t);
        const bool ghost_row = !grid_.is_interior_row(first.y, first.z);
        for (int k = 0; k < tile; ++k) {
            const Vec3<int> cell{first.x + k, first.y, first.z};
            if (cell.x < -1 || cell.x > size.x || !(ghost_row || cell.x == -1 || cell.x == size.x))
                continue;
            bool foreign = false;
            for (int a = 0; a < 3; ++a)
                foreign = foreign || (block_.divided[a] && is_outside(cell, a));
            if (!foreign && growth_.has(outermost, cell, label))
                ghost_copies_.push_back({address_of(block_.home(cell), label), address_of(cell, label)});
        }
    }
}

void Band::list_part_cells() {
    const auto for_each_place = [](const CellBox& box, const auto& body) {
        for (int z = box.begin.z; z < box.begin.z + box.size.z; ++z)
            for (int y = box.begin.y; y < box.begin.y + box.size.y; ++y)
                for (int x = box.begin.x; x < box.begin.x + box.size.x; ++x)
                    body(Vec3<int>{x, y, z});
    };
    const auto for_each_cell = [&](const CellBox& box, const auto& body) {
        for_each_place(box, [&](const Vec3<int>& cell) {
            growth_.for_each_label(cell, [&](int label) { body(cell, label); });
        });
    };
    for (const HaloPart& part : parts_) {
        PartCells cells;
        const bool slides = block_.slides_at(part.link);
        for_each_cell(slides ? home_cells(part.rim) : part.rim, [&](const Vec3<int>& cell, int label) {
            cells.rim.push_back(address_of(block_.home(cell), label));
        });
        for_each_cell(part.ghosts, [&](const Vec3<int>& cell, int label) {
            if (slides)
                slid_places_.push_back(
                    {part_cells_.size(), block_.home(cell), address_of(cell, label), label});
            else
                cells.ghosts.push_back(address_of(cell, label));
        });
        part_cells_.push_back(std::move(cells));
        rim_cells_.emplace_back();
        if (slides) {
            const CellBox box = home_cells(part.rim);
            for_each_cell(box, [&](const Vec3<int>& cell, int label) {
                rim_cells_.back().push_back(
                    {static_cast<std::int32_t>(box.index_of(cell)), label, lowest_level(cell, label)});
            });
        }
    }
}

/// Without the block's own ghosts.
CellBox Band::home_cells(CellBox box) const {
    for (int a = 0; a < 3; ++a)
        if (!block_.divided[a]) {
            box.begin[a] = 0;
            box.size[a] = grid_.size()[a];
        }
    return box;
}

std::vector<Band::RimCell> Band::rim_cells(std::size_t part,
                                           const std::function<int(std::int64_t)>& owner_of) const {
    const CellBox box = home_cells(parts_[part].rim);
    std::vector<RimCell> cells = rim_cells_[part];
    for (int z = box.begin.z; z < box.begin.z + box.size.z; ++z)
        for (int y = box.begin.y; y < box.begin.y + box.size.y; ++y)
            for (int x = box.begin.x; x < box.begin.x + box.size.x; ++x) {
                if (const int owner = owner_of(grid_.index(x, y, z)); owner >= 0)
                    cells.push_back(
                        {static_cast<std::int32_t>(box.index_of({x, y, z})), owner, outside_level});
            }
    std::sort(cells.begin(), cells.end(), [](const RimCell& a, const RimCell& b) {
        return std::tie(a.cell, a.label) < std::tie(b.cell, b.label);
    });
    return cells;
}

/// Cells of the image have addresses of their own, behind all others, and ghosts know which they lie between.
void Band::join(std::size_t index, std::span<const RimCell> rim) {
    const HaloPart& part = parts_[index];
    const int along = block_.slide->velocity;
    const CellBox box = home_cells(part.ghosts);
    std::vector<std::int32_t> addresses;
    for (const RimCell& cell : rim) {
        addresses.push_back(cell.level == outside_level ? SlidGhost::pure_red
                                                        : static_cast<std::int32_t>(compact_size_++));
        if (cell.level != outside_level)
            part_cells_[index].ghosts.push_back(addresses.back());
    }
    compact_size_ = (compact_size_ + tile - 1) / tile * tile;
    const auto find = [&](std::size_t cell, int label) {
        const auto found = std::lower_bound(
            rim.begin(), rim.end(), std::pair(static_cast<std::int32_t>(cell), label),
            [](const RimCell& a, const auto& wanted) { return std::pair(a.cell, a.label) < wanted; });
        const bool is_there =
            found != rim.end() && found->cell == static_cast<std::int32_t>(cell) && found->label == label;
        return is_there ? found - rim.begin() : std::ptrdiff_t{-1};
    };
    // Below the lower face the image has moved back, and its cells lie farther on.
    const int direction = -part.link[block_.slide->gradient];
    const int length = grid_.size()[along];
    for (const SlidPlace& place : slid_places_) {
        if (place.part != index)
            continue;
        SlidGhost ghost{place.to, {}, {}};
        for (std::size_t n = 0; n < Displacement::reads; ++n) {
            Vec3<int> from = place.home;
            from[along] =
                ((from[along] + direction * (slid_ + static_cast<int>(n) - 1)) % length + length) % length;
            const std::ptrdiff_t cell = find(box.index_of(from), place.label);
            ghost.from[n] = cell < 0 ? SlidGhost::pure_blue : addresses[static_cast<std::size_t>(cell)];
            ghost.level[n] = static_cast<std::uint8_t>(cell < 0 ? outside_level
                                                                : rim[static_cast<std::size_t>(cell)].level);
        }
        slid_ghosts_.push_back(ghost);
    }
}

void Band::separate_rim() {
    std::vector<bool> waited_for(static_cast<std::size_t>(compact_size_ / tile), false); // by address
    for (const PartCells& cells : part_cells_)
        for (const std::int32_t address : cells.rim)
            waited_for[static_cast<std::size_t>(address / tile)] = true;
    for (int level = 0; level <= outermost; ++level)
        for (const std::int32_t index : of_level_[level]) {
            const std::int32_t slot = tiles_[static_cast<std::size_t>(index)].slot();
            const bool rim = waited_for[static_cast<std::size_t>(slot / tile)];
            (rim ? rim_of_level_ : inner_of_level_)[level].push_back(index);
        }
}

void Band::list_solid_cells() {
    for (const BandTile& t : tiles_) {
        const Vec3<int> first = grid_.tile_origin(t.tile);
        const unsigned solid = solids_->of_tile(t.tile) & grid_.interior_bits(first);
        for (int k = 0; k < tile; ++k) {
            if ((solid >> k & 1u) == 0)
                continue;
            SolidCell cell{t.slot() + k, static_cast<std::uint32_t>(fluid_neighbours_.size()), 0};
            for (int i = 1; i < direction_count; ++i) {
                const Vec3<int> beside =
                    first + Vec3<int>{k + velocity(i, 0), velocity(i, 1), velocity(i, 2)};
                const int level =
                    solids_->has(grid_.index(beside)) ? outside_level : lowest_level(beside, t.label);
                if (level <= outermost)
                    fluid_neighbours_.push_back({address_of(beside, t.label), static_cast<std::int8_t>(i),
                                                 static_cast<std::int8_t>(level)});
            }
            cell.end = static_cast<std::uint32_t>(fluid_neighbours_.size());
            if (cell.end > cell.begin)
                solid_cells_.push_back(cell);
        }
    }
}

std::size_t Band::bytes() const {
    std::size_t sum =
        first_place_.capacity() * sizeof(std::int32_t) + places_.capacity() * sizeof(Place) +
        tiles_.capacity() * sizeof(BandTile) + ghost_copies_.capacity() * sizeof(GhostCopy) +
        (occupied_.capacity() + shared_tiles_.capacity()) * sizeof(std::int64_t) + growth_.bytes() +
        solid_cells_.capacity() * sizeof(SolidCell) + slid_places_.capacity() * sizeof(SlidPlace) +
        slid_ghosts_.capacity() * sizeof(SlidGhost) + fluid_neighbours_.capacity() * sizeof(FluidNeighbour);
    for (int level = 0; level <= outermost; ++level)
        sum += (of_level_[level].capacity() + rim_of_level_[level].capacity() +
                inner_of_level_[level].capacity()) *
               sizeof(std::int32_t);
    for (const std::vector<RimCell>& cells : rim_cells_)
        sum += cells.capacity() * sizeof(RimCell);
    for (const PartCells& cells : part_cells_)
        sum += (cells.rim.capacity() + cells.ghosts.capacity()) * sizeof(std::int32_t);
    return sum;
}

} // namespace vesica
