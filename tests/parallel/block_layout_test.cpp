#include "parallel/block_layout.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

using namespace vesica;

namespace {

double heaviest(const BlockLayout& layout, int axis, const std::vector<double>& weight) {
    double most = 0.0;
    for (int k = 0; k < layout.blocks()[axis]; ++k)
        most = std::max(most, std::accumulate(weight.begin() + layout.cut(axis, k),
                                              weight.begin() + layout.cut(axis, k + 1), 0.0));
    return most;
}

/// The lightest that the heaviest slab can be, by trying all cuts.
double lightest(const std::vector<double>& weight, std::size_t begin, int slabs) {
    if (slabs == 1)
        return std::accumulate(weight.begin() + static_cast<std::ptrdiff_t>(begin), weight.end(), 0.0);
    double best = 1e300;
    double sum =
        std::accumulate(weight.begin() + static_cast<std::ptrdiff_t>(begin),
                        weight.begin() + static_cast<std::ptrdiff_t>(begin) + BlockLayout::narrowest, 0.0);
    for (std::size_t end = begin + BlockLayout::narrowest;
         end + static_cast<std::size_t>((slabs - 1) * BlockLayout::narrowest) <= weight.size(); ++end) {
        best = std::min(best, std::max(sum, lightest(weight, end, slabs - 1)));
        if (end < weight.size())
            sum += weight[end];
    }
    return best;
}

} // namespace

TEST_CASE("blocks cover the box once", "[parallel]") {
    const BlockLayout layout({47, 20, 33}, {4, 1, 3});
    CHECK(layout.count() == 12);
    std::vector<int> held(47 * 20 * 33, 0);
    for (int z = 0; z < 3; ++z)
        for (int x = 0; x < 4; ++x) {
            const Block block = layout.block({x, 0, z});
            CHECK(block.divided == Vec3<bool>{true, false, true});
            CHECK(std::min(block.own.size.x, block.own.size.z) >= BlockLayout::narrowest);
            for (int k = 0; k < block.own.size.z; ++k)
                for (int j = 0; j < block.own.size.y; ++j)
                    for (int i = 0; i < block.own.size.x; ++i)
                        ++held[static_cast<std::size_t>(
                            block.own.begin.x + i +
                            47 * (block.own.begin.y + j + 20 * (block.own.begin.z + k)))];
        }
    CHECK(std::count(held.begin(), held.end(), 1) == 47 * 20 * 33);
}

TEST_CASE("a box is cut across its long axes, and across x last", "[parallel]") {
    CHECK(*choose_blocks({64, 64, 64}, 1) == Vec3<int>{1, 1, 1});
    CHECK(*choose_blocks({64, 64, 64}, 8) == Vec3<int>{1, 2, 4});
    CHECK(*choose_blocks({256, 32, 32}, 4) == Vec3<int>{4, 1, 1});
    CHECK(*choose_blocks({32, 256, 32}, 4) == Vec3<int>{1, 4, 1});
    CHECK(*choose_blocks({100, 64, 64}, 2) == Vec3<int>{1, 1, 2}); // less than twice as long
    CHECK(*choose_blocks({140, 64, 64}, 2) == Vec3<int>{2, 1, 1});
    const Vec3<int> many = *choose_blocks({1024, 1024, 1024}, 4096);
    CHECK(many.x * many.y * many.z == 4096);
    CHECK(many.x >= 8);
}

TEST_CASE("a box that cannot be cut into so many blocks is refused, and the most it can is told",
          "[parallel]") {
    CHECK_FALSE(choose_blocks({19, 19, 19}, 2));
    CHECK(choose_blocks({20, 5, 5}, 2));
    CHECK_FALSE(choose_blocks({64, 64, 64}, 7 * 7));
    CHECK_FALSE(choose_blocks({64, 64, 64}, 13));
    CHECK(most_blocks({64, 64, 64}, 13) == 12);
    CHECK(most_blocks({19, 19, 19}, 64) == 1);
    CHECK_FALSE(fits({64, 64, 64}, {7, 1, 1}));
    CHECK_FALSE(fits({64, 64, 64}, {0, 1, 1}));
    CHECK(fits({64, 3, 64}, {6, 1, 1}));
    CHECK_FALSE(fits({64, 64, 64}, {2, 1, 1}, Slide{2, 0})); // lines along the velocity stay whole
    CHECK(*choose_blocks({256, 32, 32}, 4, Slide{2, 0}) == Vec3<int>{1, 2, 2});
    CHECK(*choose_blocks({256, 32, 32}, 4, Slide{0, 1}) == Vec3<int>{4, 1, 1});
    CHECK(BlockLayout({40, 40, 40}, {1, 1, 1}, Slide{2, 0}).block({}).divided ==
          Vec3<bool>{false, false, true});
}

TEST_CASE("balanced cuts leave the heaviest slab as light as it can be", "[parallel]") {
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> any(0.1, 1.0);
    for (const int slabs : {2, 3})
        for (const int planes : {30, 37, 64})
            for (int trial = 0; trial < 10; ++trial) {
                std::vector<double> weight(static_cast<std::size_t>(planes));
                for (double& w : weight)
                    w = any(random);
                for (int k = 0; k < planes / 4; ++k) // an interface somewhere
                    weight[(static_cast<std::size_t>(trial) * 7 + static_cast<std::size_t>(k)) %
                           weight.size()] += 5.0;
                BlockLayout layout({16, 16, planes}, {1, 1, slabs});
                layout.balance(2, weight);
                CHECK(heaviest(layout, 2, weight) == Approx(lightest(weight, 0, slabs)).epsilon(1e-9));
                for (int k = 0; k < slabs; ++k)
                    CHECK(layout.cut(2, k + 1) - layout.cut(2, k) >= BlockLayout::narrowest);
            }
}

TEST_CASE("an axis that is not cut stays so, and equal planes are shared evenly", "[parallel]") {
    BlockLayout layout({40, 40, 40}, {1, 4, 1});
    layout.balance(0, std::vector<double>(40, 1.0));
    layout.balance(1, std::vector<double>(40, 1.0));
    CHECK(layout.blocks() == Vec3<int>{1, 4, 1});
    for (int k = 0; k <= 4; ++k)
        CHECK(layout.cut(1, k) == 10 * k);
}
