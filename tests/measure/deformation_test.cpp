#include "exact_field.hpp"
#include "measure/diameter.hpp"
#include "measure/equivalent_ellipsoid.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <random>

using namespace vesica;

namespace {

Vec3<double> in_shear_plane(double degrees) {
    const double angle = degrees * std::numbers::pi / 180.0;
    return {0.0, std::cos(angle), std::sin(angle)};
}

const ShearPlane plane{{0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};

} // namespace

TEST_CASE("the largest diameter of scattered points is the exact farthest pair", "[measure]") {
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal;
    for (int trial = 0; trial < 10; ++trial) {
        std::vector<Vec3<double>> points;
        for (int i = 0; i < 400; ++i)
            points.push_back({1.1 * normal(random), normal(random), normal(random)});
        double longest = 0.0;
        for (const auto& a : points)
            for (const auto& b : points)
                longest = std::max(longest, norm(a - b));
        CHECK(largest_diameter(points) == Approx(longest).epsilon(1e-14));
    }
    CHECK(largest_diameter(std::vector<Vec3<double>>{}) == 0.0);
}

TEST_CASE("the largest diameter of a sphere and of spheroids is found within a thousandth", "[measure]") {
    const Vec3<double> skew = (1.0 / std::sqrt(14.0)) * Vec3<double>{1.0, -2.0, 3.0};
    CHECK(largest_diameter(exact::snapshot_of(exact::Sphere{{0.2, 0.4, 0.1}, 15.0}, {0, 0, 0}, 33)) ==
          Approx(30.0).epsilon(1e-3));
    CHECK(largest_diameter(exact::snapshot_of(exact::Spheroid{{}, 18.0, 12.0, skew}, {0, 0, 0}, 36)) ==
          Approx(36.0).epsilon(1e-3));
    CHECK(largest_diameter(exact::snapshot_of(exact::Spheroid{{}, 10.0, 16.0, skew}, {0, 0, 0}, 34)) ==
          Approx(32.0).epsilon(1e-3));
}

TEST_CASE("surface points are the feet of the cells close to the surface, two reaches per unit area",
          "[measure]") {
    const exact::Sphere sphere{{0.2, 0.4, 0.1}, 12.0};
    const auto points = surface_points(exact::snapshot_of(sphere, {0, 0, 0}, 28), 0.5);
    CHECK(static_cast<double>(points.size()) == Approx(4.0 * std::numbers::pi * 144.0).epsilon(0.02));
    for (const Vec3<double>& point : points)
        REQUIRE(std::abs(sphere(point).s) < 1e-12);
}

TEST_CASE("the deformation index is zero at rest and one for a thread", "[measure]") {
    CHECK(deformation_index(30.0, 30.0) == 0.0);
    CHECK(deformation_index(60.0, 30.0) == Approx(0.6));
    CHECK(deformation_index(3e6, 30.0) == Approx(1.0));
}

TEST_CASE("the ellipsoid of equal inertia of an ellipsoid is itself", "[measure]") {
    const Vec3<double> axis = in_shear_plane(30.0);
    const auto body = solid_body(exact::snapshot_of(exact::Spheroid{{}, 18.0, 12.0, axis}, {0, 0, 0}, 36));
    const EquivalentEllipsoid ellipsoid = equivalent_ellipsoid(body);
    CHECK(ellipsoid.semi_axes[0] == Approx(18.0).epsilon(2e-4));
    CHECK(ellipsoid.semi_axes[1] == Approx(12.0).epsilon(2e-4));
    CHECK(ellipsoid.semi_axes[2] == Approx(12.0).epsilon(2e-4));
    CHECK(std::abs(dot(ellipsoid.directions[0], axis)) == Approx(1.0).epsilon(1e-6));
}

TEST_CASE("inclination is counted from the flow towards the gradient, in (-90, 90]", "[measure]") {
    for (double degrees : {0.0, 20.0, 75.0, -60.0, -5.0}) {
        const exact::Spheroid shape{{0.3, 0.2, 0.4}, 12.0, 8.0, in_shear_plane(degrees)};
        const auto found = plane_deformation(solid_body(exact::snapshot_of(shape, {0, 0, 0}, 28)), plane);
        CHECK(found.inclination == Approx(degrees).margin(0.01));
        CHECK(found.taylor == Approx(0.2).epsilon(1e-3));
    }
    SolidBody upright{1.0, {}, {1.0, 1.0, 2.0, 0.0, 0.0, -0.0}};
    CHECK(plane_deformation(upright, plane).inclination == 90.0);
}

TEST_CASE("without a flow the deformation is of the longest against the shortest axis", "[measure]") {
    const auto body =
        solid_body(exact::snapshot_of(exact::Spheroid{{}, 12.0, 8.0, {1.0, 0.0, 0.0}}, {0, 0, 0}, 28));
    const PlaneDeformation found = plane_deformation(body, {});
    CHECK(found.taylor == Approx(0.2).epsilon(1e-3));
    CHECK(std::isnan(found.inclination));
}
