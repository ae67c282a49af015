#include "shape/axisymmetric_shape.hpp"
#include "shape/directions.hpp"
#include "shape/evans_fung.hpp"

#include <catch2/catch.hpp>

#include <numbers>

using namespace vesica;
using std::numbers::pi;

TEST_CASE("The resting red cell of radius 3.91 um has the published volume, area and thickness") {
    const Meridian unit = evans_fung_meridian();
    const double R = 3.91;
    CHECK(unit.volume() * R * R * R == Approx(94.09).margin(0.02));
    CHECK(unit.area() * R * R == Approx(134.09).margin(0.02));
    CHECK(6.0 * std::sqrt(pi) * unit.volume() / std::pow(unit.area(), 1.5) == Approx(0.6444).margin(1e-4));
    CHECK(2.0 * R * unit.at(0.0).z == Approx(0.81).margin(1e-4));
    double thickest = 0.0, where = 0.0;
    for (const MeridianSample& s : unit.samples())
        if (2.0 * R * s.point.z > thickest) {
            thickest = 2.0 * R * s.point.z;
            where = s.point.r;
        }
    CHECK(thickest == Approx(2.566).margin(1e-3));
    CHECK(where == Approx(0.700).margin(2e-3));
}

TEST_CASE("The red cell's distance vanishes on the published formula and has gradient one") {
    const AxisymmetricShape shape(evans_fung_meridian().normalised(15.0));
    double R = 0.0;
    for (const MeridianSample& s : shape.meridian().samples())
        R = std::max(R, s.point.r);
    for (double q = 0.0; q < 1.0; q += 0.0437) {
        const double z = 0.5 * std::sqrt(1.0 - q * q) * (0.20716 + 2.00256 * q * q - 1.12276 * q * q * q * q);
        const Vec3<double> x{0.0, R * q, -R * z};
        CHECK(shape.signed_distance(x) == Approx(0.0).margin(1e-6)); // R itself is known to the sampling
        CHECK(norm(distance_gradient(shape, x)) == Approx(1.0).margin(1e-7));
    }
}

TEST_CASE("The red cell's meridian has the derivatives of its points") {
    const Meridian m = evans_fung_meridian();
    for (double t = 0.05; t < 3.1; t += 0.1) {
        const double h = 1e-5;
        const MeridianPoint a = m.at(t - h), b = m.at(t), c = m.at(t + h);
        CHECK(b.dz == Approx((c.z - a.z) / (2.0 * h)).margin(1e-8));
        CHECK(b.ddz == Approx((c.dz - a.dz) / (2.0 * h)).margin(1e-7));
        CHECK(b.ddr == Approx((c.dr - a.dr) / (2.0 * h)).margin(1e-7));
    }
}
