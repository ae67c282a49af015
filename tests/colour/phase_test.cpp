#include "colour/phase.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using namespace vesica;

TEST_CASE("a small fraction of either colour keeps its digits, in single precision as well", "[colour]") {
    for (const float fraction : {1e-12f, 3e-7f, 0.01f, 0.4f}) {
        const float in_blue = fraction; // little red outside
        const float in_red = -fraction; // little blue inside
        CHECK(red_fraction(in_blue) == fraction);
        CHECK(blue_fraction(in_red) == fraction);
        CHECK(blue_fraction(in_blue) == 1.0f - fraction);
        CHECK(red_fraction(in_red) == 1.0f - fraction);
        // 1 - phi^2 = 4 r (1 - r), where 1 - phi * phi would give nothing below 6e-8.
        const double exact = 4.0 * static_cast<double>(fraction) * (1.0 - static_cast<double>(fraction));
        CHECK(static_cast<double>(layer_density(in_blue)) == Approx(exact).epsilon(3e-7));
        CHECK(layer_density(in_red) == layer_density(in_blue));
    }
}

TEST_CASE("phi is +1 in pure red, -1 in pure blue, and leads back to the same fraction", "[colour]") {
    CHECK(phase_of(0.0) == -1.0);
    CHECK(phase_of(-0.0) == 1.0);
    CHECK(red_fraction(-0.0) == 1.0);
    CHECK(blue_fraction(0.0) == 1.0);
    CHECK(std::signbit(chi_of_phase(1.0)));
    CHECK(!std::signbit(chi_of_phase(-1.0)));
    for (int k = -1000; k <= 1000; ++k) {
        const double phi = k / 1000.0;
        const double chi = chi_of_phase(phi);
        CHECK(phase_of(chi) == Approx(phi).margin(1e-16));
        CHECK(red_fraction(chi) + blue_fraction(chi) == Approx(1.0).epsilon(1e-15));
        CHECK(red_fraction(chi) - blue_fraction(chi) == Approx(phi).margin(1e-15));
        CHECK(layer_density(chi) == Approx(1.0 - phi * phi).margin(1e-15));
    }
}

TEST_CASE("a fraction above one half is as good as its complement on the other side", "[colour]") {
    // The minority may grow past one half between two steps; nothing jumps.
    for (const double past : {0.5, 0.500001, 0.6}) {
        CHECK(red_fraction(past) == Approx(red_fraction(-(1.0 - past))).epsilon(1e-15));
        CHECK(phase_of(past) == Approx(phase_of(-(1.0 - past))).margin(1e-15));
        CHECK(signed_distance_of(past, 1e-8, 0.67) ==
              Approx(signed_distance_of(-(1.0 - past), 1e-8, 0.67)).margin(1e-15));
    }
}

TEST_CASE("the signed distance of a tanh profile is the distance, far into the tails", "[colour]") {
    const double beta = 0.67;
    for (int k = -120; k <= 120; ++k) {
        const double s = 0.1 * k;
        // (1 - tanh(beta |s|))/2
        const double chi = with_sign_bit(s < 0.0, 1.0 / (1.0 + std::exp(2.0 * beta * std::abs(s))));
        CHECK(signed_distance_of(chi, 1e-30, beta) == Approx(s).margin(1e-14).epsilon(1e-14));
        const float single = signed_distance_of(static_cast<float>(chi), 1e-30f, beta);
        CHECK(static_cast<double>(single) == Approx(s).margin(3e-7).epsilon(3e-7));
    }
    // Pure cells are read as the floor: at the same distance on either side.
    const double farthest = std::log(1e8) / (2.0 * beta);
    CHECK(signed_distance_of(0.0, 1e-8, beta) == Approx(farthest).epsilon(1e-7));
    CHECK(signed_distance_of(-0.0, 1e-8, beta) == Approx(-farthest).epsilon(1e-7));
}
