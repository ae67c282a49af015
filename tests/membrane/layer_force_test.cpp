#include "membrane/layer_force.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace vesica;

namespace {

/// int F.n ds across a flat layer phi = -tanh(beta s), by a sum fine enough for the taper's corners.
double integral_across(const LayerForce& spread, double normal_force, double beta) {
    const Vec3<double> n{0.6, 0.0, 0.8};
    const double step = 1e-3;
    double sum = 0.0;
    for (int k = -20000; k < 20000; ++k) {
        const double phi = -std::tanh(beta * (k + 0.5) * step);
        const double layer = 1.0 - phi * phi;
        const Vec3<double> F = spread(layer, -beta * layer * n, normal_force);
        CHECK(std::abs(F.y) == 0.0);
        sum += dot(F, n) * step;
    }
    return sum;
}

} // namespace

TEST_CASE("across the layer the force adds up to the membrane's, along the outward normal, for any cutoff",
          "[membrane]") {
    for (const double cutoff : {1e-4, 1e-3, 1e-2, 0.1, 0.3}) {
        INFO("cutoff " << cutoff);
        CHECK(integral_across(LayerForce(cutoff), 0.3, 0.67) == Approx(0.3).epsilon(1e-5));
        CHECK(integral_across(LayerForce(cutoff), -2.0, 0.4) == Approx(-2.0).epsilon(1e-5));
    }
}

TEST_CASE("the taper goes smoothly from nothing at the cutoff to one at four times the cutoff",
          "[membrane]") {
    const double cutoff = 1e-2;
    const LayerForce spread(cutoff);
    CHECK(spread.taper(0.0) == 0.0);
    CHECK(spread.taper(cutoff) == 0.0);
    CHECK(spread.taper(2.5 * cutoff) == Approx(0.5));
    CHECK(spread.taper(4.0 * cutoff) == Approx(1.0).epsilon(1e-14));
    CHECK(spread.taper(1.0) == 1.0);
    double before = 0.0;
    for (double layer = 0.0; layer < 0.06; layer += 1e-4) {
        CHECK(spread.taper(layer) >= before);
        before = spread.taper(layer);
    }
    // No corner at either end: the slope there vanishes with the distance from it.
    const double h = 1e-3 * cutoff;
    CHECK(spread.taper(cutoff + h) / h < 0.01 * (0.5 / (1.5 * cutoff)));
    CHECK((1.0 - spread.taper(4.0 * cutoff - h)) / h < 0.01 * (0.5 / (1.5 * cutoff)));
}
