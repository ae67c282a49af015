#include "geometry/stencil.hpp"
#include "membrane/layer_force.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace vesica;

namespace {

/// psi around a place at distance s from a flat layer with normal n.
template <class Phase>
struct FlatLayer {
    const LayerForce& spread;
    const Phase& phase_at;
    double s;
    Vec3<double> n;

    template <int i>
    double operator()(Direction<i>) const {
        const Vec3<double> c{double(velocity(i, 0)), double(velocity(i, 1)), double(velocity(i, 2))};
        return spread.profile(phase_at(s + dot(n, c)));
    }
};

/// int F.n ds across a flat layer, by a fine sum: the mean over all places of the layer between lattice
/// planes.
template <class Phase>
double integral_across(const LayerForce& spread, double normal_force, const Phase& phase_at,
                       const Vec3<double>& direction) {
    const Vec3<double> n = (1.0 / norm(direction)) * direction;
    const double step = 2e-3;
    double sum = 0.0;
    for (int k = -10000; k < 10000; ++k) {
        const FlatLayer<Phase> psi{spread, phase_at, (k + 0.5) * step, n};
        sum += dot(spread(gradient<double>(psi), normal_force), n) * step;
    }
    return sum;
}

} // namespace

TEST_CASE(
    "across the layer the force adds up to the membrane's, whatever the layer's direction, width and profile",
    "[membrane]") {
    const auto thin = [](double s) {
        return -std::tanh(0.67 * s);
    };
    const auto wide = [](double s) {
        return -std::tanh(0.3 * s);
    };
    const auto other = [](double s) {
        return -std::erf(0.5 * s);
    };
    for (const double cutoff : {1e-3, 1e-2, 0.1, 0.5})
        for (const Vec3<double>& n : {Vec3<double>{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 2, 3}}) {
            INFO("cutoff " << cutoff << ", normal " << n.x << " " << n.y << " " << n.z);
            const LayerForce spread(cutoff);
            CHECK(integral_across(spread, 0.3, thin, n) == Approx(0.3).epsilon(1e-6));
            CHECK(integral_across(spread, -2.0, wide, n) == Approx(-2.0).epsilon(1e-6));
            CHECK(integral_across(spread, 1.0, other, n) == Approx(1.0).epsilon(1e-6));
        }
}

TEST_CASE("the force points outwards, along the phase's descent, when the membrane pushes outwards",
          "[membrane]") {
    const LayerForce spread(1e-2);
    const Vec3<double> inwards{0.3, -0.1, 0.2}; // where phi grows
    const Vec3<double> F = spread(inwards, 2.0);
    CHECK(F.x == -0.3);
    CHECK(F.y == 0.1);
    CHECK(F.z == -0.2);
}

TEST_CASE("the profile is odd, rises from the cutoff on one side to that on the other, and has no corner",
          "[membrane]") {
    const double cutoff = 1e-2;
    const LayerForce spread(cutoff);
    const double edge = std::sqrt(1.0 - cutoff);
    CHECK(spread.profile(edge) == Approx(1.0).epsilon(1e-14));
    CHECK(spread.profile(1.0) == 1.0);
    CHECK(spread.profile(-1.0) == -1.0);
    CHECK(spread.profile(0.0) == 0.0);
    double before = -1.0;
    double steepest = 0.0;
    const double h = 1e-3;
    for (int k = -999; k <= 999; ++k) {
        const double phi = k * h;
        CHECK(spread.profile(phi) == -spread.profile(-phi));
        CHECK(spread.profile(phi) >= before);
        before = spread.profile(phi);
        steepest = std::max(steepest, (spread.profile(phi + h) - spread.profile(phi - h)) / (2 * h));
    }
    CHECK(steepest == Approx((spread.profile(h) - spread.profile(-h)) / (2 * h)));
    // The slope vanishes with the distance from the edge.
    CHECK(1.0 - spread.profile(edge - h) < 2.0 * h * h);
}
