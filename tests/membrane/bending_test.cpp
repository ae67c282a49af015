#include "membrane/bending.hpp"
#include "membrane/tension.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <random>

using namespace vesica;

namespace {

constexpr double pi = 3.14159265358979323846;

/// Minus the derivative of an energy E(R), per area at R: the normal force that a surface which can only
/// change its radius must feel.
template <class Energy, class Area>
double force_from(const Energy& energy, const Area& area, double R) {
    const double h = 1e-4 * R;
    return -(energy(R + h) - energy(R - h)) / (2.0 * h) / area(R);
}

double sphere(double R) {
    return 4.0 * pi * R * R;
}

/// Per unit length.
double cylinder(double R) {
    return 2.0 * pi * R;
}

} // namespace

TEST_CASE("on a sphere and on a cylinder Helfrich's force is minus the derivative of his energy",
          "[membrane]") {
    for (const double c0 : {0.0, 0.3, -0.2})
        for (const double R : {2.0, 5.0, 20.0}) {
            const HelfrichLaw law{0.7, c0};
            INFO("C0 " << c0 << " R " << R);
            const auto of_sphere = [&](double r) {
                return law.energy(1.0 / r) * sphere(r);
            };
            const auto of_cylinder = [&](double r) {
                return law.energy(0.5 / r) * cylinder(r);
            };
            const double scale = 0.7 / (R * R * R);
            CHECK(law.force(1.0 / R, 1.0 / (R * R), 0.0) ==
                  Approx(force_from(of_sphere, sphere, R)).margin(1e-6 * scale).epsilon(1e-6));
            CHECK(law.force(0.5 / R, 0.0, 0.0) ==
                  Approx(force_from(of_cylinder, cylinder, R)).margin(1e-6 * scale).epsilon(1e-6));
        }
}

TEST_CASE("a sphere's bending energy is 8 pi kappa whatever its size, and drives nothing", "[membrane]") {
    const HelfrichLaw law{0.3, 0.0};
    for (const double R : {1.0, 7.0, 30.0}) {
        CHECK(law.energy(1.0 / R) * sphere(R) == Approx(8.0 * pi * 0.3));
        CHECK(std::abs(law.force(1.0 / R, 1.0 / (R * R), 0.0)) < 1e-16);
    }
}

TEST_CASE("a wave h = cos(q x) on a flat membrane is pushed back by kappa q^4 h", "[membrane]") {
    // To first order in h: 2 H = -h'' with the normal along z, so H = q^2 h/2 and Lap_s H = -q^4 h/2.
    const double q = 0.2;
    const double h = 1e-6;
    const HelfrichLaw law{2.0, 0.0};
    CHECK(law.force(0.5 * q * q * h, 0.0, -0.5 * q * q * q * q * h) ==
          Approx(-2.0 * std::pow(q, 4) * h).epsilon(1e-6));
}

TEST_CASE(
    "the paper's force with c = 1/2 is Helfrich's for kappa_B = 4 kappa; with 3/2 it has 4 kappa Lap_s H "
    "more",
    "[membrane]") {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    for (int trial = 0; trial < 50; ++trial) {
        const double H = any(random);
        const double K = any(random);
        const double laplacian = any(random);
        const double helfrich = HelfrichLaw{0.7, 0.0}.force(H, K, laplacian);
        CHECK(PaperBendingLaw{0.7, 0.5}.force(H, K, laplacian) == Approx(helfrich).margin(1e-14));
        CHECK(PaperBendingLaw{0.7, 1.5}.force(H, K, laplacian) ==
              Approx(helfrich + 4.0 * 0.7 * laplacian).margin(1e-14));
        CHECK(PaperBendingLaw{0.7, 0.5}.energy(H) == Approx(HelfrichLaw{0.7, 0.0}.energy(H)));
    }
}

TEST_CASE("tension pulls a sphere and a cylinder inwards by minus the derivative of sigma A", "[membrane]") {
    const TensionLaw law{0.4};
    for (const double R : {2.0, 15.0}) {
        CHECK(law.force(1.0 / R) ==
              Approx(force_from([&](double r) { return 0.4 * sphere(r); }, sphere, R)).epsilon(1e-7));
        CHECK(law.force(0.5 / R) ==
              Approx(force_from([&](double r) { return 0.4 * cylinder(r); }, cylinder, R)).epsilon(1e-7));
        CHECK(law.force(1.0 / R) < 0.0);
    }
}
