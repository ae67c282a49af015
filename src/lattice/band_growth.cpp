#include "lattice/band_growth.hpp"

#include "lattice/sliding_faces.hpp"

#include <algorithm>
#include <utility>

namespace vesica {

namespace {

constexpr int tile = Grid::tile;

Vec3<int> margin_of(const Block& block) {
    constexpr int whole_tiles = (BandGrowth::core_reach + tile - 1) / tile * tile;
    return {block.divided.x ? whole_tiles : 0, block.divided.y ? BandGrowth::core_reach : 0,
            block.divided.z ? BandGrowth::core_reach : 0};
}

} // namespace

bool matters_to(const Block& block, const Vec3<int>& first) {
    for (int a = 0; a < 3; ++a) {
        bool near = !block.divided[a];
        for (int image = -1; image <= 1; ++image) {
            const int begin = first[a] + image * block.box[a] - block.own.begin[a];
            const int last = begin + (a == 0 ? tile - 1 : 0);
            near = near ||
                   (last >= -BandGrowth::core_reach && begin < block.own.size[a] + BandGrowth::core_reach);
        }
        if (!near)
            return false;
    }
    return true;
}

BandGrowth::BandGrowth(const Block& block)
    : block_(block),
      margin_(margin_of(block)),
      wide_(block.own.size + 2 * margin_),
      first_(static_cast<std::size_t>(wide_.tiles()), -1) {}

void BandGrowth::grow(const std::vector<BandSeed>& core, const std::vector<ForeignSeed>& foreign, int slid) {
    const Grid own(block_.own.size);
    for (const BandSeed& seed : core) {
        const Vec3<int> first = own.tile_origin(seed.tile);
        mark(0, tile_at(first), seed.bits, seed.label);
        for (int k = 0; k < tile; ++k) {
            const Vec3<int> cell = first + Vec3<int>{k, 0, 0};
            if ((seed.bits >> k & 1) != 0 && near_sliding_face(cell + block_.own.begin))
                mark_beside(cell + margin_, seed.label);
        }
    }
    for (const ForeignSeed& seed : foreign)
        for (int k = 0; k < tile; ++k)
            if ((seed.bits >> k & 1) != 0)
                mark_images({seed.first.x + k, seed.first.y, seed.first.z}, slid, seed.label);
    for (int level = 0; level < outermost; ++level)
        grow_level(level);
}

void BandGrowth::forget() {
    for (const Node& node : nodes_)
        first_[static_cast<std::size_t>(node.tile)] = -1;
    // Between two layouts the memory serves others.
    nodes_ = {};
    for (auto& marked : marked_)
        marked = {};
}

std::int32_t BandGrowth::find_or_add(std::int64_t t, int label) {
    std::int32_t before = -1;
    std::int32_t node = first_[static_cast<std::size_t>(t)];
    while (node >= 0 && node_at(node).label < label) {
        before = node;
        node = node_at(node).next;
    }
    if (node >= 0 && node_at(node).label == label)
        return node;
    const auto added = static_cast<std::int32_t>(nodes_.size());
    nodes_.push_back({t, label, node, {}});
    (before < 0 ? first_[static_cast<std::size_t>(t)] : nodes_[static_cast<std::size_t>(before)].next) =
        added;
    return added;
}

void BandGrowth::mark(int level, std::int64_t t, std::uint8_t bits, int label) {
    if (bits == 0)
        return;
    const std::int32_t node = find_or_add(t, label);
    std::uint8_t& held = nodes_[static_cast<std::size_t>(node)].bits[level];
    if (held == 0)
        marked_[level].push_back(node);
    held |= bits;
}

void BandGrowth::mark_cell(int level, std::int64_t row_tile, int x, int label) {
    mark(level, row_tile + 1 + x / tile, static_cast<std::uint8_t>(1u << (x % tile)), label);
}

bool BandGrowth::near_sliding_face(const Vec3<int>& cell) const {
    if (!block_.slide)
        return false;
    const int place = cell[block_.slide->gradient];
    return place < core_reach || place >= block_.box[block_.slide->gradient] - core_reach;
}

/// A value beyond a sliding face is taken from cells beside the one that lies nearest: a core there has to
/// have as much around them as around itself.
void BandGrowth::mark_beside(Vec3<int> place, int label) {
    constexpr int farthest = Displacement::reads - 1;
    const int along = block_.slide->velocity;
    const int length = wide_.size()[along];
    const int middle = place[along];
    for (int away = -farthest; away <= farthest; ++away) {
        place[along] = ((middle + away) % length + length) % length;
        mark_cell(0, wide_.index(-tile, place.y, place.z) / tile, place.x, label);
    }
}

/// Every image of a cell of the whole box that lies in the block or its margin; beyond a sliding face all
/// places that a value there may be taken from are as good as the cell itself.
void BandGrowth::mark_images(const Vec3<int>& cell, int slid, int label) {
    std::vector<std::pair<int, int>> places[3]; // along each axis: place, image
    for (int a = 0; a < 3; ++a)
        for (int image = -1; image <= 1; ++image) {
            const int place = cell[a] - block_.own.begin[a] + image * block_.box[a] + margin_[a];
            if (place >= 0 && place < wide_.size()[a] && (block_.divided[a] || image == 0))
                places[a].emplace_back(place, image);
        }
    const auto mark_at = [&](const Vec3<int>& place) {
        mark_cell(0, wide_.index(-tile, place.y, place.z) / tile, place.x, label);
    };
    for (const auto& [z, image_z] : places[2])
        for (const auto& [y, image_y] : places[1])
            for (const auto& [x, image_x] : places[0]) {
                const Vec3<int> image{image_x, image_y, image_z};
                Vec3<int> place{x, y, z};
                const int slides = block_.slide ? image[block_.slide->gradient] : 0;
                if (slides == 0) {
                    mark_at(place);
                    if (near_sliding_face(cell))
                        mark_beside(place, label);
                    continue;
                }
                const int along = block_.slide->velocity;
                const int length = wide_.size()[along];
                const int from = place[along];
                for (int n = 0; n < Displacement::reads; ++n) {
                    place[along] = ((from + slides * (slid + n - 1)) % length + length) % length;
                    mark_at(place);
                }
            }
}

/// Marks bits in a row at level; with `sideways` also their neighbours along x, across the periodic face if
/// need be.
void BandGrowth::spread(std::int64_t row_tile, int tile_in_row, std::uint8_t bits, bool sideways, int level,
                        int label) {
    mark(level, row_tile + tile_in_row, bits, label);
    if (!sideways)
        return;
    const int nx = wide_.size().x;
    const int x0 = (tile_in_row - 1) * tile;
    const unsigned wide = bits;
    const unsigned last = static_cast<unsigned>(std::min(tile, nx - x0)) - 1;
    const unsigned inside = (2u << last) - 1;
    mark(level, row_tile + tile_in_row, static_cast<std::uint8_t>((wide << 1 | wide >> 1) & inside), label);
    const int before = x0 - 1;
    const int behind = x0 + static_cast<int>(last) + 1;
    if ((wide & 1u) != 0 && (before >= 0 || !block_.divided.x))
        mark_cell(level, row_tile, before >= 0 ? before : nx - 1, label);
    if ((wide >> last & 1u) != 0 && (behind < nx || !block_.divided.x))
        mark_cell(level, row_tile, behind < nx ? behind : 0, label);
}

/// level + 1 is level and all cells one link of D3Q19 away from it.
void BandGrowth::grow_level(int level) {
    const Vec3<int> size = wide_.size();
    // Across a divided axis nothing comes round: beyond the margin nothing matters to the block.
    const auto leaves = [&](int& place, int axis) {
        if (place >= 0 && place < size[axis])
            return false;
        place += place < 0 ? size[axis] : -size[axis];
        return block_.divided[axis];
    };
    // marked_ of this level is complete; the next level's list grows while we go through it.
    for (std::size_t k = 0; k < marked_[level].size(); ++k) {
        const Node node = node_at(marked_[level][k]); // the list of nodes grows meanwhile
        const std::int64_t t = node.tile;
        const std::uint8_t bits = node.bits[level];
        mark(level + 1, t, bits, node.label);
        // Neighbours of what the level before held belong to this level, and so to the next, already.
        const std::uint8_t before = level > 0 ? node.bits[level - 1] : std::uint8_t{0};
        const auto fresh = static_cast<std::uint8_t>(bits & ~before);
        if (fresh == 0)
            continue;
        const Vec3<int> origin = wide_.tile_origin(t);
        const int tile_in_row = static_cast<int>(t % wide_.tiles_per_row());
        for (int dz = -1; dz <= 1; ++dz)
            for (int dy = -1; dy <= 1; ++dy) {
                int y = origin.y + dy;
                int z = origin.z + dz;
                if (leaves(y, 1) || leaves(z, 2))
                    continue;
                spread(wide_.index(-tile, y, z) / tile, tile_in_row, fresh, dy == 0 || dz == 0, level + 1,
                       node.label);
            }
    }
}

std::size_t BandGrowth::bytes() const {
    std::size_t sum = first_.capacity() * sizeof(std::int32_t) + nodes_.capacity() * sizeof(Node);
    for (const auto& marked : marked_)
        sum += marked.capacity() * sizeof(std::int32_t);
    return sum;
}

} // namespace vesica
