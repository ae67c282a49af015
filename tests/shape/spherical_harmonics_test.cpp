#include "shape/directions.hpp"
#include "shape/spherical_harmonics.hpp"

#include <catch2/catch.hpp>

#include <cstdlib>
#include <numbers>

using namespace vesica;
using std::numbers::pi;

namespace {

HarmonicSeries harmonic(int l, int m) {
    HarmonicSeries series;
    series.add(l, m, 1.0);
    return series;
}

/// Exact for products of two harmonics of degree up to 6: midpoints in the azimuth, Simpson's rule is not
/// enough in z, so a fine midpoint rule there.
double inner_product(const HarmonicSeries& a, const HarmonicSeries& b) {
    double sum = 0.0;
    constexpr int rows = 4000, columns = 16;
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j) {
            const double z = -1.0 + (2.0 * i + 1.0) / rows, azimuth = 2.0 * pi * (j + 0.3) / columns;
            const double r = std::sqrt(1.0 - z * z);
            const Vec3<double> u{r * std::cos(azimuth), r * std::sin(azimuth), z};
            sum += a(u).value * b(u).value * 4.0 * pi / (rows * columns);
        }
    return sum;
}

} // namespace

TEST_CASE("Low harmonics are the textbook's in Schmidt's normalisation") {
    for (const Vec3<double>& u : directions(30)) {
        const auto [x, y, z] = u;
        CHECK(harmonic(1, 0)(u).value == Approx(z).margin(1e-14));
        CHECK(harmonic(1, 1)(u).value == Approx(x).margin(1e-14));
        CHECK(harmonic(1, -1)(u).value == Approx(y).margin(1e-14));
        CHECK(harmonic(2, 0)(u).value == Approx(1.5 * z * z - 0.5).margin(1e-14));
        CHECK(harmonic(2, 2)(u).value == Approx(std::sqrt(3.0) / 2.0 * (x * x - y * y)).margin(1e-14));
        CHECK(harmonic(2, -2)(u).value == Approx(std::sqrt(3.0) * x * y).margin(1e-14));
        CHECK(harmonic(2, -1)(u).value == Approx(std::sqrt(3.0) * y * z).margin(1e-14));
        CHECK(harmonic(4, 0)(u).value ==
              Approx((35.0 * z * z * z * z - 30.0 * z * z + 3.0) / 8.0).margin(1e-14));
    }
}

TEST_CASE("Harmonics are orthogonal and their squares integrate to 4 pi over 2 l + 1") {
    for (const auto& [l, m] :
         {std::pair{2, 0}, std::pair{2, -1}, std::pair{3, 2}, std::pair{5, -4}, std::pair{6, 6}}) {
        CHECK(inner_product(harmonic(l, m), harmonic(l, m)) == Approx(4.0 * pi / (2 * l + 1)).epsilon(1e-5));
        CHECK(inner_product(harmonic(l, m), harmonic(4, 1)) == Approx(0.0).margin(1e-5));
        CHECK(harmonic(l, m).root_mean_square() == Approx(std::sqrt(1.0 / (2 * l + 1))).epsilon(1e-14));
    }
}

TEST_CASE("The harmonics of one degree add up to one: Unsoeld's theorem, for the highest degree too") {
    for (const int l : {1, 7, 32})
        for (const Vec3<double>& u : directions(20)) {
            double sum = 0.0;
            for (int m = -l; m <= l; ++m)
                sum += std::pow(harmonic(l, m)(u).value, 2);
            CHECK(sum == Approx(1.0).epsilon(1e-11));
        }
}

TEST_CASE("A harmonic's gradient is its derivative along the sphere, at the poles too") {
    std::vector<Vec3<double>> points = directions(20);
    points.push_back({0.0, 0.0, 1.0});
    points.push_back({0.0, 0.0, -1.0});
    for (const auto& [l, m] :
         {std::pair{1, 1}, std::pair{2, -1}, std::pair{4, 3}, std::pair{6, -6}, std::pair{5, 0}})
        for (const Vec3<double>& u : points) {
            const HarmonicSeries y = harmonic(l, m);
            const Vec3<double> gradient = y(u).gradient;
            CHECK(dot(gradient, u) == Approx(0.0).margin(1e-13));
            for (int i = 0; i < 3; ++i) {
                Vec3<double> e{};
                e[i] = 1e-5;
                const Vec3<double> a = u + e, b = u - e;
                const double slope = (y((1.0 / norm(a)) * a).value - y((1.0 / norm(b)) * b).value) / 2e-5;
                CHECK(gradient[i] == Approx(slope).margin(1e-7));
            }
        }
}
