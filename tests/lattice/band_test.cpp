#include "lattice/band.hpp"
#include "lattice/velocity_set.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <random>
#include <vector>

using namespace vesica;

namespace {

int wrapped(int x, int size) {
    return ((x % size) + size) % size;
}

/// Cells of a periodic box by brute force: one flag each.
struct Cells {
    Vec3<int> size{};
    std::vector<char> flags;

    explicit Cells(const Vec3<int>& s) : size(s), flags(static_cast<std::size_t>(s.x * s.y * s.z), 0) {}

    std::size_t at(int x, int y, int z) const {
        return static_cast<std::size_t>(wrapped(x, size.x) +
                                        size.x * (wrapped(y, size.y) + size.y * wrapped(z, size.z)));
    }

    template <class Body>
    void for_each(const Body& body) const {
        for (int z = 0; z < size.z; ++z)
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < size.x; ++x)
                    body(x, y, z);
    }

    /// These cells and those one link away.
    Cells grown() const {
        Cells larger(size);
        for_each([&](int x, int y, int z) {
            if (flags[at(x, y, z)] == 0)
                return;
            for (int i = 0; i < direction_count; ++i)
                larger.flags[at(x + velocity(i, 0), y + velocity(i, 1), z + velocity(i, 2))] = 1;
        });
        return larger;
    }
};

Cells random_core(const Vec3<int>& size, int count, std::mt19937_64& random) {
    Cells core(size);
    for (int k = 0; k < count; ++k)
        core.flags[random() % core.flags.size()] = 1;
    return core;
}

std::vector<Band::Seed> seeds_of(const Cells& core, const Grid& grid) {
    std::vector<std::uint8_t> bits(static_cast<std::size_t>(grid.tiles()), 0);
    core.for_each([&](int x, int y, int z) {
        const std::int64_t cell = grid.index(x, y, z);
        if (core.flags[core.at(x, y, z)] != 0)
            bits[static_cast<std::size_t>(cell / Grid::tile)] |=
                static_cast<std::uint8_t>(1u << (cell % Grid::tile));
    });
    std::vector<Band::Seed> seeds;
    for (std::size_t t = 0; t < bits.size(); ++t)
        if (bits[t] != 0)
            seeds.push_back({static_cast<std::int64_t>(t), bits[t]});
    return seeds;
}

/// The cells of one level as the band states them.
Cells level_of(const Band& band, int level) {
    const Grid& grid = band.grid();
    Cells cells(grid.size());
    for (const std::int32_t index : band.of_level(level)) {
        const BandTile& t = band.tiles()[static_cast<std::size_t>(index)];
        const Vec3<int> origin = grid.tile_origin(t.tile);
        CHECK((t.bits[level] & ~grid.interior_bits(origin)) == 0);
        for (int k = 0; k < Grid::tile; ++k)
            if ((t.bits[level] >> k & 1) != 0)
                cells.flags[cells.at(origin.x + k, origin.y, origin.z)] = 1;
    }
    return cells;
}

struct BoxWithCore {
    Vec3<int> size;
    int core;
};
const BoxWithCore boxes[] = {{{1, 1, 1}, 1},    {{3, 1, 9}, 1},    {{1, 17, 1}, 2},
                             {{17, 3, 8}, 1},   {{8, 1, 24}, 2},   {{20, 19, 18}, 1},
                             {{25, 17, 16}, 3}, {{33, 20, 21}, 4}, {{40, 7, 31}, 2}};

bool same(const Band& a, const Band& b) {
    if (a.compact_size() != b.compact_size() || a.tiles().size() != b.tiles().size())
        return false;
    for (std::size_t k = 0; k < a.tiles().size(); ++k) {
        const BandTile& s = a.tiles()[k];
        const BandTile& t = b.tiles()[k];
        if (s.tile != t.tile || s.cell != t.cell || !std::equal(s.rows, s.rows + 9, t.rows) ||
            !std::equal(s.bits, s.bits + BandTile::levels, t.bits) || s.followed != t.followed)
            return false;
    }
    for (int level = 0; level <= Band::outermost; ++level)
        if (a.of_level(level) != b.of_level(level))
            return false;
    return std::equal(
        a.ghost_copies().begin(), a.ghost_copies().end(), b.ghost_copies().begin(), b.ghost_copies().end(),
        [](const Band::GhostCopy& s, const Band::GhostCopy& t) { return s.from == t.from && s.to == t.to; });
}

} // namespace

TEST_CASE("each level of a band is the one before and all cells one link away, across periodic faces",
          "[lattice]") {
    std::mt19937_64 random(3);
    for (const auto& [size, count] : boxes)
        for (int trial = 0; trial < 4; ++trial) {
            INFO("box " << size.x << " x " << size.y << " x " << size.z);
            Cells expected = random_core(size, count, random);
            Band band{Grid(size)};
            band.rebuild(seeds_of(expected, band.grid()));
            for (int level = 0; level <= Band::outermost; ++level) {
                CHECK(level_of(band, level).flags == expected.flags);
                if (level == Band::outermost)
                    CHECK(band.cell_count() == std::count(expected.flags.begin(), expected.flags.end(), 1));
                expected = expected.grown();
            }
        }
}

TEST_CASE(
    "a compact address shifted along a link holds the neighbour's value, ghosts once copied, but beyond the "
    "outermost level",
    "[lattice]") {
    std::mt19937_64 random(5);
    for (const auto& [size, count] : boxes)
        for (int trial = 0; trial < 4; ++trial) {
            INFO("box " << size.x << " x " << size.y << " x " << size.z);
            const Cells core = random_core(size, count, random);
            const Grid grid(size);
            Band band(grid);
            band.rebuild(seeds_of(core, grid));
            std::vector<std::int64_t> values(static_cast<std::size_t>(band.compact_size()), -1);
            for (const BandTile& t : band.tiles())
                for (int k = 0; k < Grid::tile; ++k) {
                    const Vec3<int> o = grid.tile_origin(t.tile);
                    if ((t.bits[Band::outermost] >> k & 1) != 0)
                        values[static_cast<std::size_t>(t.slot() + k)] =
                            static_cast<std::int64_t>(core.at(o.x + k, o.y, o.z));
                }
            for (const Band::GhostCopy& copy : band.ghost_copies()) {
                CHECK(values[static_cast<std::size_t>(copy.to)] ==
                      -1); // no copy overwrites a cell or another copy
                values[static_cast<std::size_t>(copy.to)] = values[static_cast<std::size_t>(copy.from)];
            }

            std::int64_t wrong = 0;
            for (const std::int32_t index : band.of_level(Band::outermost)) {
                const BandTile& t = band.tiles()[static_cast<std::size_t>(index)];
                const Vec3<int> o = grid.tile_origin(t.tile);
                for (int k = 0; k < Grid::tile; ++k) {
                    if ((t.bits[Band::outermost] >> k & 1) == 0)
                        continue;
                    const bool on_rim = (t.bits[Band::outermost - 1] >> k & 1) == 0;
                    for (int i = 0; i < direction_count; ++i) {
                        const int row = (velocity(i, 1) + 1) + 3 * (velocity(i, 2) + 1);
                        const auto address = static_cast<std::size_t>(t.rows[row] + k + velocity(i, 0));
                        const std::size_t neighbour =
                            core.at(o.x + k + velocity(i, 0), o.y + velocity(i, 1), o.z + velocity(i, 2));
                        const std::int64_t found = values[address];
                        wrong += on_rim || found == static_cast<std::int64_t>(neighbour) ? 0 : 1;
                    }
                }
            }
            CHECK(wrong == 0);
        }
}

TEST_CASE("whole tiles shifted along any link stay inside the compact arrays", "[lattice]") {
    std::mt19937_64 random(6);
    for (const auto& [size, count] : boxes) {
        const Grid grid(size);
        Band band(grid);
        band.rebuild(seeds_of(random_core(size, count, random), grid));
        for (const BandTile& t : band.tiles())
            for (const std::int32_t row : t.rows) {
                CHECK(row >= 1);
                CHECK(row + Grid::tile + 1 <= band.compact_size());
            }
    }
}

TEST_CASE("a tile and the one that follows it are one run of twice the length in all nine rows",
          "[lattice]") {
    std::mt19937_64 random(8);
    int followed = 0;
    int apart = 0;
    for (const auto& [size, count] : boxes) {
        const Grid grid(size);
        Band band(grid);
        band.rebuild(seeds_of(random_core(size, count, random), grid));
        const std::vector<BandTile>& tiles = band.tiles();
        for (std::size_t k = 0; k + 1 < tiles.size(); ++k) {
            const BandTile& a = tiles[k];
            const BandTile& b = tiles[k + 1];
            bool alike = b.tile == a.tile + 1;
            for (int dz = -1; dz <= 1 && alike; ++dz)
                for (int dy = -1; dy <= 1 && alike; ++dy) {
                    const std::int64_t row = grid.tile_offset(dy, dz);
                    alike =
                        (band.slot_of_tile(a.tile + row, 0) < 0) == (band.slot_of_tile(b.tile + row, 0) < 0);
                }
            CHECK(a.followed == alike);
            (alike ? followed : apart) += b.tile == a.tile + 1 ? 1 : 0;
            if (!a.followed)
                continue;
            for (int row = 0; row < 9; ++row) {
                const bool outside = a.rows[row] == Grid::tile;
                CHECK(b.rows[row] == (outside ? Grid::tile : a.rows[row] + Grid::tile));
            }
        }
        if (!tiles.empty())
            CHECK_FALSE(tiles.back().followed);
        // Twice the tile that stands for everything outside, and a margin, belong to nobody.
        for (std::int64_t t = 0; t < grid.tiles(); ++t)
            CHECK((band.slot_of_tile(t, 0) < 0 || band.slot_of_tile(t, 0) >= 4 * Grid::tile));
    }
    CHECK(followed > 10);
    CHECK(apart > 10);
}

TEST_CASE("a band remembers nothing of the core it had before", "[lattice]") {
    std::mt19937_64 random(7);
    for (const auto& [size, count] : boxes) {
        const Grid grid(size);
        const auto first = seeds_of(random_core(size, count + 2, random), grid);
        const auto second = seeds_of(random_core(size, count, random), grid);
        Band moved(grid);
        moved.rebuild(first);
        moved.rebuild(second);
        moved.rebuild(second);
        Band fresh(grid);
        fresh.rebuild(second);
        CHECK(same(moved, fresh));
        std::int64_t addressed = 0;
        std::int64_t addressed_fresh = 0;
        for (std::int64_t t = 0; t < grid.tiles(); ++t) {
            addressed += moved.slot_of_tile(t, 0) >= 0 ? 1 : 0;
            addressed_fresh += fresh.slot_of_tile(t, 0) >= 0 ? 1 : 0;
        }
        CHECK(addressed == addressed_fresh);
        moved.rebuild({});
        CHECK(moved.tiles().empty());
        CHECK(moved.cell_count() == 0);
    }
}

TEST_CASE("each label's band is what it would be alone, and tiles follow each other row by row",
          "[lattice]") {
    std::mt19937_64 random(13);
    int shared = 0;
    for (const auto& [size, count] : boxes) {
        const Grid grid(size);
        std::vector<BandSeed> all;
        std::vector<Band> alone;
        for (const int label : {0, 3, 4}) {
            std::vector<BandSeed> core = seeds_of(random_core(size, count, random), grid);
            alone.emplace_back(grid).rebuild(core);
            for (BandSeed& seed : core) {
                seed.label = label;
                all.push_back(seed);
            }
        }
        std::shuffle(all.begin(), all.end(), random);
        Band band(grid);
        band.rebuild(all);
        CHECK(std::is_sorted(band.tiles().begin(), band.tiles().end(),
                             [&](const BandTile& a, const BandTile& b) { return band.precedes(a, b); }));
        std::size_t next[] = {0, 0, 0};
        std::vector<bool> taken(static_cast<std::size_t>(band.compact_size() / Grid::tile), false);
        for (const BandTile& t : band.tiles()) {
            const std::size_t which = t.label == 0 ? 0 : static_cast<std::size_t>(t.label - 2);
            REQUIRE(next[which] < alone[which].tiles().size());
            const BandTile& own = alone[which].tiles()[next[which]++];
            CHECK(t.tile == own.tile);
            CHECK(t.followed == own.followed);
            CHECK(std::equal(std::begin(t.bits), std::end(t.bits), std::begin(own.bits)));
            for (std::size_t row = 0; row < 9; ++row)
                CHECK((t.rows[row] == Grid::tile) == (own.rows[row] == Grid::tile));
            CHECK(band.slot_of_tile(t.tile, t.label) == t.slot());
            const auto place = static_cast<std::size_t>(t.slot() / Grid::tile);
            CHECK_FALSE(taken[place]);
            taken[place] = true;
            int labels = 0;
            int previous = -1;
            band.for_each_label(t.tile, [&](int label, std::int32_t slot) {
                CHECK(label > previous);
                CHECK(slot == band.slot_of_tile(t.tile, label));
                previous = label;
                ++labels;
            });
            const auto& several = band.shared_tiles();
            CHECK(std::binary_search(several.begin(), several.end(), t.tile) == (labels > 1));
            shared += labels > 1 ? 1 : 0;
        }
        std::int64_t cells = 0;
        std::size_t copies = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            CHECK(next[k] == alone[k].tiles().size());
            cells += alone[k].cell_count();
            copies += alone[k].ghost_copies().size();
        }
        CHECK(band.cell_count() == cells);
        CHECK(band.ghost_copies().size() == copies);
    }
    CHECK(shared > 100);
}
