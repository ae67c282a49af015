#include "lattice/velocity_set.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <set>
#include <tuple>

using namespace vesica;

namespace {

double power(int base, int exponent) {
    return std::pow(static_cast<double>(base), exponent);
}

double moment(int px, int py, int pz) {
    double sum = 0.0;
    for (int i = 0; i < direction_count; ++i)
        sum += weight(i) * power(velocity(i, 0), px) * power(velocity(i, 1), py) * power(velocity(i, 2), pz);
    return sum;
}

/// int x^px y^py z^pz of a Gaussian with variance 1/3: what fluid dynamics wants of the weights.
double gaussian_moment(int px, int py, int pz) {
    const double variance = 1.0 / 3.0;
    double product = 1.0;
    for (const int p : {px, py, pz}) {
        if (p % 2 != 0)
            product = 0.0;
        if (p == 2)
            product *= variance;
        if (p == 4)
            product *= 3.0 * variance * variance;
    }
    return product;
}

} // namespace

TEST_CASE("the weights have a Gaussian's moments up to the fourth order", "[lattice]") {
    for (int px = 0; px <= 4; ++px)
        for (int py = 0; px + py <= 4; ++py)
            for (int pz = 0; px + py + pz <= 4; ++pz) {
                INFO("moment x^" << px << " y^" << py << " z^" << pz);
                CHECK(moment(px, py, pz) == Approx(gaussian_moment(px, py, pz)).margin(1e-15));
            }
}

TEST_CASE("the nineteen velocities are all cells no farther than a face's diagonal, each once", "[lattice]") {
    std::set<std::tuple<int, int, int>> found;
    for (int i = 0; i < direction_count; ++i) {
        CHECK(detail::squared_speed(i) <= 2);
        found.insert({velocity(i, 0), velocity(i, 1), velocity(i, 2)});
    }
    CHECK(found.size() == direction_count);
}

TEST_CASE("the opposite of a velocity is its negative, and opposites come in pairs", "[lattice]") {
    for (int i = 0; i < direction_count; ++i) {
        for (int axis = 0; axis < 3; ++axis)
            CHECK(velocity(opposite(i), axis) == -velocity(i, axis));
        CHECK(opposite(opposite(i)) == i);
        CHECK(weight(opposite(i)) == weight(i));
    }
}

TEST_CASE("nine pairs and the rest are all directions, in any loop over pairs", "[lattice]") {
    std::multiset<int> visited{0};
    for_each_pair([&](auto i) {
        visited.insert(decltype(i)::value);
        visited.insert(opposite(decltype(i)::value));
    });
    for (int i = 0; i < direction_count; ++i)
        CHECK(visited.count(i) == 1);
    int next = 0;
    for_each_direction([&](auto i) { CHECK(decltype(i)::value == next++); });
    CHECK(next == direction_count);
}
