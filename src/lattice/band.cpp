#include "lattice/band.hpp"

#include <algorithm>
#include <bit>
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
      slot_of_tile_(static_cast<std::size_t>(grid_.tiles()), -1) {}

void Band::rebuild(const std::vector<Seed>& core, const std::vector<ForeignSeed>& foreign, int slid) {
    clear();
    slid_ = slid;
    growth_.grow(core, foreign, slid);
    lay_out();
    growth_.forget();
}

void Band::clear() {
    for (const std::int64_t t : occupied_)
        slot_of_tile_[static_cast<std::size_t>(t)] = -1;
    occupied_.clear();
    tiles_.clear();
    ghost_copies_.clear();
    part_cells_.clear();
    slid_ghosts_.clear();
    slid_places_.clear();
    rim_levels_.clear();
    solid_cells_.clear();
    fluid_neighbours_.clear();
    for (int level = 0; level <= outermost; ++level) {
        of_level_[level].clear();
        rim_of_level_[level].clear();
        inner_of_level_[level].clear();
    }
}

/// The tiles of the band in the block, and those of its ghosts that stand for cells of the band.
std::vector<std::int64_t> Band::tiles_to_address() const {
    std::vector<std::int64_t> members;
    const Vec3<int> size = grid_.size();
    const auto add_row = [&](const Vec3<int>& first, int y, int z) {
        const std::uint8_t bits = growth_.bits(outermost, first);
        if (block_.divided.x) {
            // The ghosts at the row's ends are cells of the margin: a tile may hold some of either.
            unsigned within = 0;
            for (int k = 0; k < tile; ++k)
                if (first.x + k >= -1 && first.x + k <= size.x)
                    within |= 1u << k;
            if ((bits & within) != 0)
                members.push_back(grid_.index(first.x, y, z) / tile);
            return;
        }
        const int last = std::min(tile, size.x - first.x) - 1;
        members.push_back(grid_.index(first.x, y, z) / tile);
        if (first.x == 0 && (bits & 1u) != 0)
            members.push_back(grid_.index(size.x, y, z) / tile);
        if (first.x + last == size.x - 1 && (bits >> last & 1u) != 0)
            members.push_back(grid_.index(-tile, y, z) / tile);
    };
    growth_.for_each_tile([&](const Vec3<int>& first) {
        for (int dz = -1; dz <= 1; ++dz)
            for (int dy = -1; dy <= 1; ++dy) {
                const int y = first.y + dy * size.y;
                const int z = first.z + dz * size.z;
                const bool image_of_other = (dy != 0 && block_.divided.y) || (dz != 0 && block_.divided.z);
                if (!image_of_other && y >= -1 && y <= size.y && z >= -1 && z <= size.z)
                    add_row(first, y, z);
            }
    });
    std::sort(members.begin(), members.end());
    members.erase(std::unique(members.begin(), members.end()), members.end());
    return members;
}

void Band::lay_out() {
    std::vector<std::int64_t> members = tiles_to_address();
    // Addresses: tiles 1 and 2 stand for everything outside the band, with an unused tile on either side.
    std::int64_t address = 3 * tile;
    std::int64_t previous = -2;
    for (const std::int64_t t : members) {
        if (t != previous + 1)
            address += tile;
        slot_of_tile_[static_cast<std::size_t>(t)] = static_cast<std::int32_t>(address);
        address += tile;
        previous = t;
    }
    compact_size_ = address + tile;
    list_tiles(members);
    list_ghost_copies(members);
    if (solids_ != nullptr)
        list_solid_cells();
    occupied_ = std::move(members);
    if (parts_.empty())
        return;
    list_part_cells();
    separate_rim();
}

void Band::list_tiles(const std::vector<std::int64_t>& members) {
    cell_count_ = 0;
    for (const std::int64_t t : members) {
        if (own_bits(outermost, t) == 0)
            continue;
        BandTile band_tile;
        band_tile.tile = t;
        band_tile.cell = t * tile;
        for (int level = 0; level <= outermost; ++level) {
            const std::uint8_t grown = own_bits(level, t);
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
            const std::int32_t slot = slot_of_tile(band_tile.tile + grid_.tile_offset(dy, dz));
            band_tile.rows[(dy + 1) + 3 * (dz + 1)] = slot >= 0 ? slot : tile;
        }
}

bool Band::follows(const BandTile& first, const BandTile& second) {
    if (second.tile != first.tile + 1)
        return false;
    for (int row = 0; row < 9; ++row)
        if (second.rows[row] != (first.rows[row] == tile ? tile : first.rows[row] + tile))
            return false;
    return true;
}

/// Ghosts that stand for cells of this block.
void Band::list_ghost_copies(const std::vector<std::int64_t>& members) {
    const Vec3<int> size = grid_.size();
    const auto is_outside = [&](const Vec3<int>& cell, int axis) {
        return cell[axis] < 0 || cell[axis] >= size[axis];
    };
    for (const std::int64_t t : members) {
        const Vec3<int> first = grid_.tile_origin(t);
        const bool ghost_row = !grid_.is_interior_row(first.y, first.z);
        for (int k = 0; k < tile; ++k) {
            const Vec3<int> cell{first.x + k, first.y, first.z};
            if (cell.x < -1 || cell.x > size.x || !(ghost_row || cell.x == -1 || cell.x == size.x))
                continue;
            bool foreign = false;
            for (int a = 0; a < 3; ++a)
                foreign = foreign || (block_.divided[a] && is_outside(cell, a));
            if (!foreign && growth_.has(outermost, cell))
                ghost_copies_.push_back(
                    {address_of(block_.home(cell)), slot_of_tile(t) + static_cast<std::int32_t>(k)});
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
            if (growth_.has(outermost, cell))
                body(cell);
        });
    };
    for (const HaloPart& part : parts_) {
        PartCells cells;
        const bool slides = block_.slides_at(part.link);
        for_each_cell(slides ? home_cells(part.rim) : part.rim,
                      [&](const Vec3<int>& cell) { cells.rim.push_back(address_of(block_.home(cell))); });
        for_each_cell(part.ghosts, [&](const Vec3<int>& cell) {
            if (slides)
                slid_places_.push_back({part_cells_.size(), block_.home(cell), address_of(cell)});
            else
                cells.ghosts.push_back(address_of(cell));
        });
        part_cells_.push_back(std::move(cells));
        rim_levels_.emplace_back();
        if (slides)
            for_each_place(home_cells(part.rim), [&](const Vec3<int>& cell) {
                rim_levels_.back().push_back(static_cast<std::uint8_t>(lowest_level(cell)));
            });
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

std::vector<std::uint8_t> Band::rim_cells(std::size_t part, const std::vector<std::uint8_t>& inside) const {
    const CellBox box = home_cells(parts_[part].rim);
    std::vector<std::uint8_t> cells = rim_levels_[part];
    std::size_t at = 0;
    for (int z = box.begin.z; z < box.begin.z + box.size.z; ++z)
        for (int y = box.begin.y; y < box.begin.y + box.size.y; ++y)
            for (int x = box.begin.x; x < box.begin.x + box.size.x; ++x, ++at) {
                const std::int64_t cell = grid_.index(x, y, z);
                if ((inside[static_cast<std::size_t>(cell / tile)] >> (cell % tile) & 1) != 0)
                    cells[at] = static_cast<std::uint8_t>(cells[at] | red_side);
            }
    return cells;
}

/// Cells of the image have addresses of their own, behind all others, and ghosts know which they lie between.
std::size_t Band::join(std::size_t index, std::span<const std::byte> rim) {
    const HaloPart& part = parts_[index];
    const int along = block_.slide->velocity;
    const CellBox box = home_cells(part.ghosts);
    const auto count = static_cast<std::size_t>(box.volume());
    std::vector<std::int32_t> addresses;
    for (const std::byte byte : rim.first(count)) {
        const auto cell = std::to_integer<unsigned>(byte);
        if ((cell & ~red_side) <= outermost) {
            addresses.push_back(static_cast<std::int32_t>(compact_size_++));
            part_cells_[index].ghosts.push_back(addresses.back());
        } else {
            addresses.push_back((cell & red_side) != 0 ? SlidGhost::pure_red : SlidGhost::pure_blue);
        }
    }
    compact_size_ = (compact_size_ + tile - 1) / tile * tile;
    // Below the lower face the image has moved back, and its cells lie farther on.
    const int direction = -part.link[block_.slide->gradient];
    const int length = grid_.size()[along];
    for (const SlidPlace& place : slid_places_) {
        if (place.part != index)
            continue;
        SlidGhost ghost{place.to, {}, {}};
        for (int n = 0; n < Displacement::reads; ++n) {
            Vec3<int> from = place.home;
            from[along] = ((from[along] + direction * (slid_ + n - 1)) % length + length) % length;
            const std::size_t cell = box.index_of(from);
            ghost.from[static_cast<std::size_t>(n)] = addresses[cell];
            ghost.level[static_cast<std::size_t>(n)] =
                static_cast<std::uint8_t>(std::to_integer<unsigned>(rim[cell]) & ~red_side);
        }
        slid_ghosts_.push_back(ghost);
    }
    return count;
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
                const int level = solids_->has(grid_.index(beside)) ? outermost + 1 : lowest_level(beside);
                if (level <= outermost)
                    fluid_neighbours_.push_back(
                        {address_of(beside), static_cast<std::int8_t>(i), static_cast<std::int8_t>(level)});
            }
            cell.end = static_cast<std::uint32_t>(fluid_neighbours_.size());
            if (cell.end > cell.begin)
                solid_cells_.push_back(cell);
        }
    }
}

std::size_t Band::bytes() const {
    std::size_t sum =
        slot_of_tile_.capacity() * sizeof(std::int32_t) + tiles_.capacity() * sizeof(BandTile) +
        ghost_copies_.capacity() * sizeof(GhostCopy) + occupied_.capacity() * sizeof(std::int64_t) +
        growth_.bytes() + solid_cells_.capacity() * sizeof(SolidCell) +
        slid_places_.capacity() * sizeof(SlidPlace) + slid_ghosts_.capacity() * sizeof(SlidGhost) +
        fluid_neighbours_.capacity() * sizeof(FluidNeighbour);
    for (int level = 0; level <= outermost; ++level)
        sum += (of_level_[level].capacity() + rim_of_level_[level].capacity() +
                inner_of_level_[level].capacity()) *
               sizeof(std::int32_t);
    for (const std::vector<std::uint8_t>& levels : rim_levels_)
        sum += levels.capacity();
    for (const PartCells& cells : part_cells_)
        sum += (cells.rim.capacity() + cells.ghosts.capacity()) * sizeof(std::int32_t);
    return sum;
}

} // namespace vesica
