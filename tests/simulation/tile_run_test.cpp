#include "simulation/tile_run.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numeric>
#include <vector>

using namespace vesica;

namespace {

/// A ball's surface, its rows cut at any cell, in a box of an odd number of tiles.
Band band_of_a_ball(const Grid& grid) {
    std::vector<Band::Seed> core;
    const Vec3<int> size = grid.size();
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x0 = 0; x0 < size.x; x0 += tile_width) {
                unsigned bits = 0;
                for (int k = 0; k < tile_width && x0 + k < size.x; ++k) {
                    const double r = std::hypot(x0 + k - 20.0, y - 16.0, z - 17.0);
                    bits |= (std::abs(r - 9.0) < 1.0 ? 1u : 0u) << k;
                }
                if (bits != 0)
                    core.push_back({grid.index(x0, y, z) / tile_width, static_cast<std::uint8_t>(bits)});
            }
    Band band(grid);
    band.rebuild(core);
    return band;
}

} // namespace

TEST_CASE("tiles in pairs are the tiles one by one: each once, with the same cells, values and neighbours") {
    const Band band = band_of_a_ball(Grid({40, 32, 33}));
    std::vector<float> memory(static_cast<std::size_t>(band.compact_size()));
    std::iota(memory.begin(), memory.end(), 0.0f);
    std::fill_n(memory.begin(), 4 * tile_width, 0.0f); // what stands for everything outside is one value
    const std::span<float> values(memory);
    for (const int level : {0, 4, Band::outermost}) {
        const auto count = static_cast<std::int64_t>(band.of_level(level).size());
        for (const std::int64_t begin : {std::int64_t{0}, std::int64_t{1}, count / 2}) {
            std::vector<std::size_t> visited;
            int pairs = 0;
            const auto compare = [&](const auto& run, std::size_t index) {
                for (int k = 0; k < run.count; ++k) {
                    visited.push_back(index + static_cast<std::size_t>(k));
                    const TileRun<float> one{&band.tiles()[visited.back()]};
                    CHECK((run.bits(level) >> (k * tile_width) & 0xffu) == one.bits(level));
                    CHECK(run.cell() + k * tile_width == one.cell());
                    const auto here = run.load(values);
                    const auto alone = one.load(values);
                    for (int lane = 0; lane < tile_width; ++lane)
                        CHECK(here[k * tile_width + lane] == alone[lane]);
                    for_each_direction([&](auto i) {
                        const auto there = around(values, run)(i);
                        const auto its = around(values, one)(i);
                        for (int lane = 0; lane < tile_width; ++lane)
                            CHECK(there[k * tile_width + lane] == its[lane]);
                    });
                }
                pairs += run.count == 2 ? 1 : 0;
            };
            for_each_run<float, 2>(band, band.of_level(level), begin, count, compare);
            const std::vector<std::int32_t>& list = band.of_level(level);
            CHECK(std::equal(visited.begin(), visited.end(), list.begin() + begin, list.end()));
            CHECK(4 * pairs > static_cast<int>(visited.size()) / 4);
        }
    }
}

TEST_CASE("what is stored by a pair lies where the tiles find it") {
    const Band band = band_of_a_ball(Grid({40, 32, 33}));
    std::vector<float> memory(static_cast<std::size_t>(band.compact_size()), -1.0f);
    const std::span<float> values(memory);
    float next = 0.0f;
    for_each_run<float, 2>(band, band.of_level(4), 0, static_cast<std::int64_t>(band.of_level(4).size()),
                           [&]<class Run>(const Run& run, std::size_t) {
                               float lanes[static_cast<std::size_t>(Run::V::width)];
                               for (float& lane : lanes)
                                   lane = next++;
                               run.store(Run::V::load(lanes), values);
                           });
    float expected = 0.0f;
    for (const std::int32_t index : band.of_level(4)) {
        const auto found = TileRun<float>{&band.tiles()[static_cast<std::size_t>(index)]}.load(values);
        for (int lane = 0; lane < tile_width; ++lane)
            CHECK(found[lane] == expected++);
    }
}
