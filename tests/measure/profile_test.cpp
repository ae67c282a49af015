#include "exact_field.hpp"
#include "measure/profile.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace vesica;

namespace {

const Vec3<double> skew = (1.0 / std::sqrt(14.0)) * Vec3<double>{1.0, -2.0, 3.0};

} // namespace

TEST_CASE("the profile of a spheroid is its ellipse, however it lies", "[measure]") {
    const auto [polar, equatorial] = GENERATE(std::pair{16.0, 10.0}, std::pair{9.0, 14.0});
    const exact::Spheroid shape{{3.3, -0.2, 8.1}, polar, equatorial, skew};
    const auto vesicle = exact::snapshot_of(shape, {3, 0, 8}, 32);
    CHECK(std::abs(dot(symmetry_axis(solid_body(vesicle)), skew)) == Approx(1.0).epsilon(1e-6));
    const auto profile = meridian_profile(vesicle);
    REQUIRE(profile.size() > 1000);
    CHECK(profile.front().z > 0.95 * polar);
    CHECK(profile.back().z < -0.95 * polar);
    double previous = 0.0;
    for (const auto& [r, z] : profile) {
        const double angle = std::atan2(r, z);
        REQUIRE(angle >= previous);
        previous = angle;
        REQUIRE(std::hypot(r / equatorial, z / polar) == Approx(1.0).margin(1e-4));
    }
}
