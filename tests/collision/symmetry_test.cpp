#include "collision/sample_states.hpp"
#include "measured.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <vector>

using namespace vesica;
using namespace vesica::sample;

namespace {

/// One of the 48 symmetries of the cube: axes permuted, then reflected.
struct CubeSymmetry {
    std::array<int, 3> axis{};
    std::array<int, 3> sign{};

    template <class T>
    Vec3<T> operator()(const Vec3<T>& a) const {
        Vec3<T> b;
        for (std::size_t k = 0; k < 3; ++k)
            b[static_cast<int>(k)] = static_cast<T>(sign[k]) * a[axis[k]];
        return b;
    }

    /// The direction that direction i becomes.
    int operator()(int i) const {
        const Vec3<int> c = (*this)(Vec3<int>{velocity(i, 0), velocity(i, 1), velocity(i, 2)});
        for (int j = 0; j < direction_count; ++j)
            if (c == Vec3<int>{velocity(j, 0), velocity(j, 1), velocity(j, 2)})
                return j;
        return -1;
    }

    Populations operator()(const Populations& p) const {
        Populations turned;
        for (int i = 0; i < direction_count; ++i)
            turned[(*this)(i)] = p[i];
        return turned;
    }
};

std::vector<CubeSymmetry> symmetries_of_the_cube() {
    std::vector<CubeSymmetry> all;
    std::array<int, 3> axis{0, 1, 2};
    do {
        for (int signs = 0; signs < 8; ++signs)
            all.push_back(
                {axis, {(signs & 1) != 0 ? -1 : 1, (signs & 2) != 0 ? -1 : 1, (signs & 4) != 0 ? -1 : 1}});
    } while (std::next_permutation(axis.begin(), axis.end()));
    return all;
}

/// The largest difference between turning a cell before a collision and after it.
template <class Collision>
double asymmetry(const Collision& collision) {
    std::mt19937_64 random(1);
    double largest = 0.0;
    for (int trial = 0; trial < 5; ++trial)
        for (const CubeSymmetry& turn : symmetries_of_the_cube()) {
            const Cell cell = random_cell(random);
            Cell turned = cell;
            turned.before = turn(cell.before);
            turned.force = turn(cell.force);
            largest = std::max(
                largest, largest_difference(collided(collision, turned), turn(collided(collision, cell))));
        }
    return largest;
}

} // namespace

TEST_CASE("the 48 symmetries of the cube commute with every collision in the symmetric basis",
          "[collision]") {
    REQUIRE(symmetries_of_the_cube().size() == 48);
    const double regularised = asymmetry(RegularisedCollision{});
    CHECK(regularised < 1e-14);
    test::measured("48 symmetries of the cube", "regularised collision", regularised);
    CHECK(asymmetry(SymmetricMrt<SingleRelaxationTime>{}) < 1e-14);
    CHECK(asymmetry(SymmetricMrt<TwoRelaxationTimes>{}) < 1e-14);
    const double free_rates = asymmetry(SymmetricMrt<FreeGhostRates>{{1.1, 1.3, 0.9, 1.7}});
    CHECK(free_rates < 1e-14);
    test::measured("48 symmetries of the cube", "free ghost rates, symmetric basis", free_rates);
}

TEST_CASE("the paper's basis treats x, y and z alike with two rates, and with free rates it does not",
          "[collision]") {
    // Two rates: lambda_11 = lambda_14, lambda_10 = lambda_17 = lambda_4; so with cells that share one rate.
    struct TwoRates {
        void operator()(double (&g)[direction_count], const Vec3<double>& F, const double& rate,
                        const double& rho0) const {
            PaperMrt{rate, 1.6, 1.6, rate}(g, F, rate, rho0);
        }
    };
    CHECK(asymmetry(TwoRates{}) < 1e-14);
    CHECK(asymmetry(PaperMrt{1.0, 1.0, 1.0, 1.0}) > 1e-4);
    const double free_rates = asymmetry(PaperMrt{1.2, 0.7, 1.5, 1.9});
    CHECK(free_rates > 1e-4);
    test::measured("48 symmetries of the cube", "free ghost rates, paper's basis", free_rates);
}
