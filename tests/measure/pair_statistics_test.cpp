#include "measure/pair_statistics.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <random>

using namespace vesica;

namespace {

std::vector<Vec3<double>> random_places(const PairBox& box, int count, unsigned seed) {
    std::mt19937_64 random(seed);
    const auto below = [&](int bound) {
        return bound * (static_cast<double>(random() >> 11) * 0x1p-53);
    };
    std::vector<Vec3<double>> places;
    while (static_cast<int>(places.size()) < count) {
        const Vec3<double> place{below(box.size.x), below(box.size.y), below(box.size.z)};
        const Vec3<int> cell{static_cast<int>(place.x), static_cast<int>(place.y), static_cast<int>(place.z)};
        if (box.solids == nullptr || !box.solids->at(cell))
            places.push_back(place);
    }
    return places;
}

/// g from r on, over all bins' pairs.
double distribution_beyond(const std::vector<PairBin>& bins, double r) {
    double pairs = 0.0;
    double expected = 0.0;
    for (const PairBin& bin : bins)
        if (bin.distance > r) {
            pairs += static_cast<double>(bin.pairs);
            expected += static_cast<double>(bin.pairs) / bin.distribution;
        }
    return pairs / expected;
}

} // namespace

TEST_CASE("points anywhere have a pair distribution of one, between walls and in a tube too") {
    SolidVoxels tube({40, 40, 40});
    for (int z = 0; z < 40; ++z)
        for (int y = 0; y < 40; ++y)
            for (int x = 0; x < 40; ++x)
                if (std::hypot(y + 0.5 - 20.0, z + 0.5 - 20.0) > 17.0)
                    tube.set({x, y, z});
    PairBox box{{40, 40, 40}, {true, true, true}, {}, nullptr};
    SECTION("periodic") {}
    SECTION("walls") {
        box.periodic.z = false;
    }
    SECTION("tube") {
        box.solids = &tube;
        box.periodic = {true, false, false};
    }
    SECTION("sliding") {
        box.sliding = SlidingImages{2, 0, 13.7, 0.0};
    }
    const std::vector<PairBin> bins = pair_statistics(random_places(box, 1500, 3), box, 2.0, 0, 2);
    REQUIRE(bins.size() == 10);
    CHECK(bins[4].distance == 9.0);
    // About 10^5 pairs and more: three standard deviations are 1 %.
    CHECK(distribution_beyond(bins, 6.0) == Approx(1.0).margin(0.012));
    for (const PairBin& bin : bins)
        if (bin.distance > 6.0) {
            CHECK(bin.distribution == Approx(1.0).margin(4.0 / std::sqrt(static_cast<double>(bin.pairs))));
            CHECK(std::abs(bin.shear_moment) < 4.0 / std::sqrt(static_cast<double>(bin.pairs)));
        }
}

TEST_CASE("a cubic lattice has three pairs a point at its spacing and six at the diagonals' half") {
    const PairBox box{{48, 48, 48}, {true, true, true}, {}, nullptr};
    std::vector<Vec3<double>> lattice;
    for (int k = 0; k < 64; ++k)
        lattice.push_back({3.0 + 12 * (k % 4), 12.0 * (k / 4 % 4), 47.0 + 12 * (k / 16)});
    const std::vector<PairBin> bins = pair_statistics(lattice, box, 1.5, 0, 2);
    for (const PairBin& bin : bins) {
        const bool edge = bin.distance == 12.75;
        const bool diagonal = bin.distance == 17.25;
        if (edge || diagonal)
            CHECK(bin.pairs == (edge ? 3 * 64 : 6 * 64));
        else if (bin.distance < 20.0)
            CHECK(bin.pairs == 0);
    }
    CHECK(nearest_neighbour(lattice, box) == Approx(12.0));
}

TEST_CASE("a pair is as far apart as its nearest images, which slide, and lies along the flow's extension") {
    PairBox box{{40, 40, 40}, {true, true, true}, {}, nullptr};
    box.sliding = SlidingImages{2, 0, 90.0, 0.0}; // two boxes and ten cells
    // The upper one's image below has moved back by ten: three cells ahead of the lower one, and three below.
    const std::vector<Vec3<double>> pair{{20.0, 5.0, 1.0}, {33.0, 5.0, 38.0}};
    CHECK(nearest_neighbour(pair, box) == Approx(std::sqrt(18.0)));
    const std::vector<PairBin> bins = pair_statistics(pair, box, 2.0, 0, 2);
    CHECK(bins[2].pairs == 1);
    CHECK(bins[2].shear_moment == Approx(-1.0));
    CHECK(std::isnan(bins[3].shear_moment));
    CHECK(std::isnan(pair_statistics(pair, box, 2.0, 0, -1)[2].shear_moment));
    CHECK(std::isnan(nearest_neighbour({{1.0, 2.0, 3.0}}, box)));
}

TEST_CASE("walls part what periodic faces would join") {
    const PairBox box{{40, 40, 40}, {true, true, false}, {}, nullptr};
    const std::vector<Vec3<double>> pair{{20.0, 5.0, 1.0}, {20.0, 5.0, 38.0}};
    CHECK(nearest_neighbour(pair, box) == Approx(37.0));
}
