#include "core/exact_sum.hpp"
#include "measure/layer_moment.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace vesica;

TEST_CASE("the stationary profile obeys its recurrence and its contrast sums to 2/beta", "[measure]") {
    for (double beta : {0.1, 0.5, 0.67, 1.0 / std::numbers::sqrt2}) {
        for (double start : {0.0, 0.1, 0.3}) {
            ExactSum contrast;
            contrast.add(1.0 - start * start);
            for (double side : {1.0, -1.0}) { // outwards, and inwards with phi and direction reversed
                double height = 1.0 + side * start;
                for (int i = 0; i < 2000; ++i) {
                    const double next = next_height(height, beta);
                    const double phi = height - 1.0;
                    const double phi_next = next - 1.0;
                    REQUIRE(phi_next - phi ==
                            Approx(-0.5 * beta * (2.0 - phi_next * phi_next - phi * phi)).margin(1e-15));
                    contrast.add(next * (2.0 - next));
                    height = next;
                }
            }
            CHECK(contrast.value() == Approx(2.0 / beta).epsilon(1e-12));
        }
    }
}

TEST_CASE("towards beta = 0 the lattice's moments are the tanh's", "[measure]") {
    double previous = 1.0;
    for (double beta : {0.2, 0.1, 0.05, 0.025}) {
        const LayerMoments lattice = lattice_layer_moments(beta);
        const LayerMoments limit = tanh_layer_moments(beta);
        const double deviation = 1.0 - lattice.area / limit.area;
        CHECK(deviation > 0.0);
        CHECK(deviation < previous / 3.8); // second order in beta
        previous = deviation;
        CHECK(lattice.volume_fourth == Approx(limit.volume_fourth).epsilon(0.6 * beta * beta));
    }
    CHECK(previous < 2e-4);
}

TEST_CASE("at beta = 0.67 the layer is narrower than the tanh", "[measure]") {
    const LayerMoments tanh = tanh_layer_moments(0.67);
    const LayerMoments lattice = lattice_layer_moments(0.67);
    CHECK(tanh.area == Approx(std::numbers::pi * std::numbers::pi / (12.0 * 0.67 * 0.67)).epsilon(1e-14));
    CHECK(lattice.area / tanh.area == Approx(0.8829).margin(1e-4));
    CHECK(lattice.volume / tanh.volume == Approx(0.9738).margin(1e-4));
}
