#include "lattice/band.hpp"
#include "lattice/block_samples.hpp"
#include "lattice/velocity_set.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <random>
#include <vector>

using namespace vesica;
using namespace vesica::test;

namespace {

int wrapped(int x, int size) {
    return ((x % size) + size) % size;
}

std::size_t cell_number(Vec3<int> cell, const Vec3<int>& box) {
    for (int a = 0; a < 3; ++a)
        cell[a] = wrapped(cell[a], box[a]);
    return static_cast<std::size_t>(cell.x + box.x * (cell.y + box.y * cell.z));
}

std::vector<BandSeed> seeds_in(const Block& block, const std::vector<char>& core) {
    const Grid grid(block.own.size);
    std::vector<BandSeed> seeds;
    for (std::int64_t t = 0; t < grid.tiles(); ++t) {
        const Vec3<int> first = grid.tile_origin(t);
        const std::uint8_t inside = grid.interior_bits(first);
        std::uint8_t bits = 0;
        for (int k = 0; k < Grid::tile; ++k)
            if ((inside >> k & 1) != 0 &&
                core[cell_number(block.own.begin + first + Vec3<int>{k, 0, 0}, block.box)] != 0)
                bits |= static_cast<std::uint8_t>(1u << k);
        if (bits != 0)
            seeds.push_back({t, bits});
    }
    return seeds;
}

/// As neighbours would send them.
std::vector<ForeignSeed> seeds_of_others(const CutBox& cut, int self, const std::vector<char>& core) {
    std::vector<ForeignSeed> foreign;
    for (int other = 0; other < cut.count(); ++other) {
        if (other == self)
            continue;
        const Block block = cut.block(other);
        const Grid grid(block.own.size);
        for (const BandSeed& seed : seeds_in(block, core)) {
            const Vec3<int> first = grid.tile_origin(seed.tile) + block.own.begin;
            if (matters_to(cut.block(self), first))
                foreign.push_back({first, seed.bits});
        }
    }
    return foreign;
}

std::vector<char> random_core(const Vec3<int>& box, int count, std::mt19937_64& random) {
    std::vector<char> core(static_cast<std::size_t>(box.x * box.y * box.z), 0);
    for (int k = 0; k < count; ++k)
        core[random() % core.size()] = 1;
    return core;
}

/// Per cell of the whole box: the lowest level it belongs to, `levels` outside the band.
std::vector<int> levels_of(const Band& band, const Block& block, std::vector<int> levels) {
    const Grid& grid = band.grid();
    for (const BandTile& t : band.tiles())
        for (int k = 0; k < Grid::tile; ++k)
            for (int level = 0; level <= Band::outermost; ++level)
                if ((t.bits[level] >> k & 1) != 0) {
                    const Vec3<int> cell = grid.tile_origin(t.tile) + block.own.begin + Vec3<int>{k, 0, 0};
                    int& lowest = levels[cell_number(cell, block.box)];
                    lowest = std::min(lowest, level);
                }
    return levels;
}

} // namespace

TEST_CASE("the pieces of a block's surface fit those of its neighbours", "[lattice]") {
    for (const CutBox& cut : cut_boxes())
        for (int self = 0; self < cut.count(); ++self) {
            const std::vector<HaloPart> parts = halo_parts(cut.block(self));
            for (const HaloPart& part : parts) {
                const int other = cut.neighbour(self, part.link);
                const std::vector<HaloPart> theirs = halo_parts(cut.block(other));
                const std::size_t opposite = opposite_part(theirs, part.link);
                REQUIRE(opposite < theirs.size());
                CHECK(theirs[opposite].rim.size == part.ghosts.size);
                // Our ghosts are their rim, seen across the box's periodic faces if need be.
                for (int a = 0; a < 3; ++a) {
                    const int ours = cut.block(self).own.begin[a] + part.ghosts.begin[a];
                    const int others = cut.block(other).own.begin[a] + theirs[opposite].rim.begin[a];
                    CHECK(wrapped(ours - others, cut.box[a]) == 0);
                }
            }
            const Vec3<bool> divided = cut.block(self).divided;
            const int axes = (divided.x ? 1 : 0) + (divided.y ? 1 : 0) + (divided.z ? 1 : 0);
            CHECK(parts.size() == (axes == 1 ? 2u : axes == 2 ? 8u : 18u));
        }
    CHECK(halo_parts(Block::whole({5, 6, 7})).empty());
}

TEST_CASE("bands grown block by block are the band of the whole box", "[lattice]") {
    std::mt19937_64 random(9);
    for (const CutBox& cut : cut_boxes())
        for (int trial = 0; trial < 5; ++trial) {
            INFO("box " << cut.box.x << " x " << cut.box.y << " x " << cut.box.z);
            const std::vector<char> core = random_core(cut.box, 1 + trial, random);
            const Block whole = Block::whole(cut.box);
            Band one(whole);
            one.rebuild(seeds_in(whole, core));
            const std::vector<int> nowhere(core.size(), BandTile::levels);
            std::vector<int> together = nowhere;
            std::int64_t cells = 0;
            for (int self = 0; self < cut.count(); ++self) {
                Band band(cut.block(self));
                band.rebuild(seeds_in(cut.block(self), core), seeds_of_others(cut, self, core));
                together = levels_of(band, cut.block(self), together);
                cells += band.cell_count();
                for (int level = 0; level <= Band::outermost; ++level) {
                    std::vector<std::int32_t> parted = band.rim_of_level(level);
                    const std::vector<std::int32_t>& inner = band.inner_of_level(level);
                    parted.insert(parted.end(), inner.begin(), inner.end());
                    std::sort(parted.begin(), parted.end());
                    CHECK(parted == band.of_level(level));
                    // What neighbours wait for lies in the rim's tiles.
                    std::vector<bool> late(static_cast<std::size_t>(band.compact_size() / Grid::tile), false);
                    for (const std::int32_t index : inner)
                        late[static_cast<std::size_t>(band.tiles()[static_cast<std::size_t>(index)].slot() /
                                                      Grid::tile)] = true;
                    std::int64_t missed = 0;
                    for (const Band::PartCells& part : band.part_cells())
                        missed += std::count_if(part.rim.begin(), part.rim.end(), [&](std::int32_t address) {
                            return late[static_cast<std::size_t>(address / Grid::tile)];
                        });
                    CHECK(missed == 0);
                }
            }
            CHECK(together == levels_of(one, whole, nowhere));
            CHECK(cells == one.cell_count());
        }
}

TEST_CASE("once blocks have told each other their rims, every link of a band's cell finds its neighbour",
          "[lattice]") {
    std::mt19937_64 random(10);
    for (const CutBox& cut : cut_boxes())
        for (int trial = 0; trial < 5; ++trial) {
            INFO("box " << cut.box.x << " x " << cut.box.y << " x " << cut.box.z);
            const std::vector<char> core = random_core(cut.box, 1 + trial, random);
            std::vector<int> members(core.size(), BandTile::levels);
            std::vector<Band> bands;
            std::vector<std::vector<std::int64_t>> values;
            std::vector<std::vector<std::int64_t>> before; // messages leave before ghosts have been copied
            for (int self = 0; self < cut.count(); ++self) {
                const Block block = cut.block(self);
                Band& band = bands.emplace_back(block);
                band.rebuild(seeds_in(block, core), seeds_of_others(cut, self, core));
                members = levels_of(band, block, members);
                auto& own = values.emplace_back(static_cast<std::size_t>(band.compact_size()), -1);
                for (const BandTile& t : band.tiles())
                    for (int k = 0; k < Grid::tile; ++k)
                        if ((t.bits[Band::outermost] >> k & 1) != 0)
                            own[static_cast<std::size_t>(t.slot() + k)] =
                                static_cast<std::int64_t>(cell_number(
                                    band.grid().tile_origin(t.tile) + block.own.begin + Vec3<int>{k, 0, 0},
                                    cut.box));
                before.push_back(own);
                for (const Band::GhostCopy& copy : band.ghost_copies()) {
                    CHECK(own[static_cast<std::size_t>(copy.to)] == -1);
                    CHECK(own[static_cast<std::size_t>(copy.from)] != -1);
                    own[static_cast<std::size_t>(copy.to)] = own[static_cast<std::size_t>(copy.from)];
                }
            }
            for (int self = 0; self < cut.count(); ++self) {
                const std::vector<HaloPart> parts = halo_parts(cut.block(self));
                const auto at = static_cast<std::size_t>(self);
                for (std::size_t k = 0; k < parts.size(); ++k) {
                    const auto other = static_cast<std::size_t>(cut.neighbour(self, parts[k].link));
                    const std::size_t theirs =
                        opposite_part(halo_parts(cut.block(static_cast<int>(other))), parts[k].link);
                    const std::vector<std::int32_t>& to = bands[at].part_cells()[k].ghosts;
                    const std::vector<std::int32_t>& from = bands[other].part_cells()[theirs].rim;
                    REQUIRE(to.size() == from.size());
                    for (std::size_t cell = 0; cell < to.size(); ++cell) {
                        std::int64_t& ghost = values[at][static_cast<std::size_t>(to[cell])];
                        CHECK(ghost == -1); // nobody's cell, and sent once
                        ghost = before[other][static_cast<std::size_t>(from[cell])];
                    }
                }
            }
            std::int64_t idle = 0; // tiles with an address that hold nothing of the band
            for (std::size_t at = 0; at < bands.size(); ++at)
                for (std::int64_t t = 0; t < bands[at].grid().tiles(); ++t)
                    if (const std::int32_t slot = bands[at].slot_of_tile(t, 0); slot >= 0) {
                        const auto first = values[at].begin() + slot;
                        idle += std::count(first, first + Grid::tile, -1) == Grid::tile ? 1 : 0;
                    }
            // Where all axes are cut, corners that no link reaches may have an address.
            const Vec3<int> pieces = cut.blocks();
            CHECK((idle == 0 || std::min({pieces.x, pieces.y, pieces.z}) > 1));
            std::int64_t wrong = 0;
            for (int self = 0; self < cut.count(); ++self) {
                const auto at = static_cast<std::size_t>(self);
                for (const BandTile& t : bands[at].tiles())
                    for (int k = 0; k < Grid::tile; ++k) {
                        if ((t.bits[Band::outermost - 1] >> k & 1) == 0)
                            continue;
                        const Vec3<int> cell = bands[at].grid().tile_origin(t.tile) +
                                               cut.block(self).own.begin + Vec3<int>{k, 0, 0};
                        for (int i = 0; i < direction_count; ++i) {
                            const int row = (velocity(i, 1) + 1) + 3 * (velocity(i, 2) + 1);
                            const std::size_t neighbour = cell_number(
                                cell + Vec3<int>{velocity(i, 0), velocity(i, 1), velocity(i, 2)}, cut.box);
                            const std::int64_t found =
                                values[at][static_cast<std::size_t>(t.rows[row] + k + velocity(i, 0))];
                            wrong += found == static_cast<std::int64_t>(neighbour) ? 0 : 1;
                        }
                    }
            }
            CHECK(wrong == 0);
        }
}

TEST_CASE("a block's band remembers nothing of the core it had before", "[lattice]") {
    std::mt19937_64 random(11);
    for (const CutBox& cut : cut_boxes()) {
        INFO("box " << cut.box.x << " x " << cut.box.y << " x " << cut.box.z);
        const std::vector<char> first = random_core(cut.box, 6, random);
        const std::vector<char> second = random_core(cut.box, 3, random);
        for (int self = 0; self < cut.count(); ++self) {
            const Block block = cut.block(self);
            Band moved(block);
            moved.rebuild(seeds_in(block, first), seeds_of_others(cut, self, first));
            moved.rebuild(seeds_in(block, second), seeds_of_others(cut, self, second));
            Band fresh(block);
            fresh.rebuild(seeds_in(block, second), seeds_of_others(cut, self, second));
            CHECK(moved.compact_size() == fresh.compact_size());
            CHECK(moved.cell_count() == fresh.cell_count());
            for (int level = 0; level <= Band::outermost; ++level) {
                CHECK(moved.of_level(level) == fresh.of_level(level));
                CHECK(moved.rim_of_level(level) == fresh.rim_of_level(level));
                CHECK(moved.inner_of_level(level) == fresh.inner_of_level(level));
            }
            REQUIRE(moved.part_cells().size() == fresh.part_cells().size());
            for (std::size_t part = 0; part < fresh.part_cells().size(); ++part) {
                CHECK(moved.part_cells()[part].rim == fresh.part_cells()[part].rim);
                CHECK(moved.part_cells()[part].ghosts == fresh.part_cells()[part].ghosts);
            }
        }
    }
}
