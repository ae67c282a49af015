#include "lattice/band.hpp"

#include <algorithm>
#include <bit>

namespace vesica {

namespace {

constexpr int tile = Grid::tile;

int wrapped(int value, int size) {
    return value < 0 ? value + size : value >= size ? value - size : value;
}

} // namespace

Band::Band(const Grid& grid) : grid_(grid), slot_of_tile_(static_cast<std::size_t>(grid.tiles()), -1) {
    for (Bits& bits : level_bits_)
        bits.assign(static_cast<std::size_t>(grid.tiles()), 0);
}

void Band::rebuild(const std::vector<Seed>& core) {
    clear();
    for (const Seed& seed : core)
        mark(0, seed.tile, seed.bits);
    for (int level = 0; level < outermost; ++level)
        grow(level);
    lay_out();
    for (int level = 0; level <= outermost; ++level) {
        for (const std::int64_t t : marked_[level])
            level_bits_[level][static_cast<std::size_t>(t)] = 0;
        marked_[level].clear();
    }
}

void Band::clear() {
    for (const std::int64_t t : occupied_)
        slot_of_tile_[static_cast<std::size_t>(t)] = -1;
    occupied_.clear();
    tiles_.clear();
    ghost_copies_.clear();
    for (auto& list : of_level_)
        list.clear();
}

void Band::mark(int level, std::int64_t t, std::uint8_t bits) {
    std::uint8_t& held = level_bits_[level][static_cast<std::size_t>(t)];
    if (held == 0 && bits != 0)
        marked_[level].push_back(t);
    held |= bits;
}

/// Marks bits in a row at level; with `sideways` also their neighbours along x, across the periodic face if
/// need be.
void Band::spread(std::int64_t row_tile, int tile_in_row, std::uint8_t bits, bool sideways, int level) {
    mark(level, row_tile + tile_in_row, bits);
    if (!sideways)
        return;
    const int nx = grid_.size().x;
    const int x0 = (tile_in_row - 1) * tile;
    const auto mark_cell = [&](int x) {
        mark(level, row_tile + 1 + x / tile, static_cast<std::uint8_t>(1u << (x % tile)));
    };
    const unsigned wide = bits;
    const unsigned last = static_cast<unsigned>(std::min(tile, nx - x0)) - 1;
    const unsigned inside = (2u << last) - 1;
    mark(level, row_tile + tile_in_row, static_cast<std::uint8_t>((wide << 1 | wide >> 1) & inside));
    if (wide & 1u)
        mark_cell(wrapped(x0 - 1, nx));
    if (wide >> last & 1u)
        mark_cell(wrapped(x0 + static_cast<int>(last) + 1, nx));
}

/// level + 1 is level and all cells one link of D3Q19 away from it.
void Band::grow(int level) {
    const Vec3<int> size = grid_.size();
    // marked_ of this level is complete; the next level's list grows while we go through it.
    for (std::size_t k = 0; k < marked_[level].size(); ++k) {
        const std::int64_t t = marked_[level][k];
        const std::uint8_t bits = level_bits_[level][static_cast<std::size_t>(t)];
        mark(level + 1, t, bits);
        // Neighbours of what the level before held belong to this level, and so to the next, already.
        const std::uint8_t before = level > 0 ? level_bits_[level - 1][static_cast<std::size_t>(t)] : 0;
        const auto fresh = static_cast<std::uint8_t>(bits & ~before);
        if (fresh == 0)
            continue;
        const Vec3<int> origin = grid_.tile_origin(t);
        const int tile_in_row = static_cast<int>(t % grid_.tiles_per_row());
        for (int dz = -1; dz <= 1; ++dz)
            for (int dy = -1; dy <= 1; ++dy) {
                const std::int64_t row =
                    grid_.index(-tile, wrapped(origin.y + dy, size.y), wrapped(origin.z + dz, size.z)) / tile;
                spread(row, tile_in_row, fresh, dy == 0 || dz == 0, level + 1);
            }
    }
}

/// Ghost tiles whose cells mirror cells of the band: they get addresses too.
void Band::place_ghosts(std::vector<std::int64_t>& members) const {
    const Vec3<int> size = grid_.size();
    const std::size_t interior = members.size();
    for (std::size_t k = 0; k < interior; ++k) {
        const std::int64_t t = members[k];
        const Vec3<int> o = grid_.tile_origin(t);
        const int last = std::min(tile, size.x - o.x) - 1;
        const std::uint8_t bits = level_bits_[outermost][static_cast<std::size_t>(t)];
        const bool low_x = o.x == 0 && (bits & 1u) != 0;
        const bool high_x = o.x + last == size.x - 1 && (bits >> last & 1u) != 0;
        for (int dz = -1; dz <= 1; ++dz)
            for (int dy = -1; dy <= 1; ++dy) {
                const int y = o.y + dy * size.y;
                const int z = o.z + dz * size.z;
                if (y < -1 || y > size.y || z < -1 || z > size.z)
                    continue;
                if (dy != 0 || dz != 0)
                    members.push_back(grid_.index(o.x, y, z) / tile);
                if (low_x)
                    members.push_back(grid_.index(size.x, y, z) / tile);
                if (high_x)
                    members.push_back(grid_.index(-tile, y, z) / tile);
            }
    }
}

void Band::lay_out() {
    std::vector<std::int64_t> members = marked_[outermost];
    place_ghosts(members);
    std::sort(members.begin(), members.end());
    members.erase(std::unique(members.begin(), members.end()), members.end());

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
    cell_count_ = 0;

    for (const std::int64_t t : members) {
        const std::size_t at = static_cast<std::size_t>(t);
        if (level_bits_[outermost][at] == 0)
            continue;
        BandTile band_tile;
        band_tile.tile = t;
        band_tile.cell = t * tile;
        for (int level = 0; level <= outermost; ++level) {
            band_tile.bits[level] = level_bits_[level][at];
            if (band_tile.bits[level] != 0)
                of_level_[level].push_back(static_cast<std::int32_t>(tiles_.size()));
        }
        cell_count_ += std::popcount(band_tile.bits[outermost]);
        link(band_tile);
        if (!tiles_.empty())
            tiles_.back().followed = follows(tiles_.back(), band_tile);
        tiles_.push_back(band_tile);
    }
    occupied_ = std::move(members);
    list_ghost_copies();
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

void Band::list_ghost_copies() {
    const Vec3<int> size = grid_.size();
    for (const std::int64_t t : occupied_) {
        const Vec3<int> o = grid_.tile_origin(t);
        const bool ghost_row = !grid_.is_interior_row(o.y, o.z);
        for (int k = 0; k < tile; ++k) {
            const int x = o.x + k;
            if (x < -1 || x > size.x || !(ghost_row || x == -1 || x == size.x))
                continue;
            const Vec3<int> image{wrapped(x, size.x), wrapped(o.y, size.y), wrapped(o.z, size.z)};
            const std::int64_t source = grid_.index(image);
            const std::size_t source_tile = static_cast<std::size_t>(source / tile);
            if ((level_bits_[outermost][source_tile] >> (source % tile) & 1) == 0)
                continue;
            ghost_copies_.push_back({static_cast<std::int32_t>(slot_of_tile_[source_tile] + source % tile),
                                     static_cast<std::int32_t>(slot_of_tile(t) + k)});
        }
    }
}

std::size_t Band::bytes() const {
    std::size_t sum = slot_of_tile_.capacity() * sizeof(std::int32_t) + tiles_.capacity() * sizeof(BandTile) +
                      ghost_copies_.capacity() * sizeof(GhostCopy) +
                      occupied_.capacity() * sizeof(std::int64_t);
    for (int level = 0; level <= outermost; ++level)
        sum += of_level_[level].capacity() * sizeof(std::int32_t) + level_bits_[level].capacity() +
               marked_[level].capacity() * sizeof(std::int64_t);
    return sum;
}

} // namespace vesica
