#include "collision/equilibrium.hpp"
#include "colour/phase.hpp"
#include "simulation/engine_cases.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace vesica;
using namespace vesica::test;

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double beta = 0.67;

/// Two fluids in flat layers of equal thickness 2a, sheared along themselves: d_t u = d_z(nu d_z u), with u
/// and nu d_z u continuous. The slowest mode is even about the middle of either layer, from which zeta
/// counts,
///   u = cos(k zeta)/cos(k a), k = k_in or k_out, and decays at the rate nu_in k_in^2 = nu_out k_out^2 with
///   nu_in k_in tan(k_in a) + nu_out k_out tan(k_out a) = 0.
struct LayeredShear {
    double a;
    double nu_in;
    double nu_out;
    double rate = 0.0;

    LayeredShear(double half_thickness, double inner, double outer)
        : a(half_thickness), nu_in(inner), nu_out(outer) {
        // The softer fluid's tangent has its pole at `low` and its next zero at `soft_end`: in between, and
        // short of the stiffer one's pole, the sum of the stresses rises from -infinity past zero.
        const double quarter = 0.25 * pi * pi / (a * a);
        double low = std::min(nu_in, nu_out) * quarter;
        double high = std::min(std::max(nu_in, nu_out) * quarter, 4.0 * low);
        for (int halving = 0; halving < 100; ++halving) {
            rate = 0.5 * (low + high);
            (stress(nu_in) + stress(nu_out) < 0.0 ? low : high) = rate;
        }
    }

    double wave_number(double nu) const { return std::sqrt(rate / nu); }
    /// -nu du/dzeta at the interface, where u = 1.
    double stress(double nu) const { return nu * wave_number(nu) * std::tan(wave_number(nu) * a); }
    double in_layer(double nu, double zeta) const {
        return std::cos(wave_number(nu) * zeta) / std::cos(wave_number(nu) * a);
    }
    /// At signed distance s from the nearer interface, positive outside.
    double sharp(double s) const { return s < 0.0 ? in_layer(nu_in, a + s) : in_layer(nu_out, a - s); }

    /// The same with the kink rounded off: where 1/nu goes from one fluid to the other with (1 - tanh(beta
    /// s))/2 and the stress is that of the interface, u differs from the sharp one by the integral of the
    /// difference.
    double rounded(double s) const {
        const double tail = std::log1p(std::exp(-2.0 * beta * std::abs(s))) / (2.0 * beta);
        return sharp(s) + stress(nu_in) * (1.0 / nu_in - 1.0 / nu_out) * tail;
    }
};

/// A slab of the inner fluid in the middle of a long box, away from the cells' faces.
struct Slab {
    int height;

    double distance(int z) const {
        const double from_middle = z + 0.5 - 0.5 * height - 0.3;
        return std::abs(std::remainder(from_middle, height)) - 0.25 * height;
    }
};

Parameters two_fluids(int height, double inner, double outer) {
    Parameters parameters = deforming_spheroid(16, 4.0);
    parameters.size = {4, 1, height};
    parameters.fluid.kinematic_viscosity = outer;
    parameters.fluid.segregation = beta;
    VesicleType& type = parameters.types[0];
    type.viscosity_ratio = inner / outer;
    type.sigma = 0.0;
    type.bending.modulus = 0.0;
    type.area.constraint = NoConstraint{};
    parameters.vesicles[0].shape = SphereShape{}; // the slab takes its place
    parameters.vesicles[0].centre = {2.0, 0.5, 0.5 * height};
    return parameters;
}

void fill(Engine& engine, const Slab& slab, const LayeredShear& mode, double cutoff) {
    EngineState state = engine.save();
    for (std::size_t at = 0; at < state.minority.size(); ++at) {
        const double s = slab.distance(static_cast<int>(at) / 4);
        state.minority[at] = with_sign_bit(s < 0.0, 1.0 / (1.0 + std::exp(2.0 * beta * std::abs(s))));
        const bool core = 1.0 - std::pow(std::tanh(beta * s), 2) > cutoff;
        state.band[at] = static_cast<std::uint8_t>((core ? 1 : 0) | (s < 0.0 ? 2 : 0));
        double g[direction_count];
        populations_of(equilibrium_moments(1.0, 1.0, Vec3<double>{1e-3 * mode.rounded(s), 0.0, 0.0}), g);
        for (std::size_t i = 0; i < direction_count; ++i)
            state.populations[i][at] = g[i];
    }
    engine.load(state);
}

struct Decay {
    double rate_error;  ///< relative to theory
    double shape_error; ///< largest difference from the mode with its rounded kink, over its largest value
};

Decay decay_between(double inner, double outer, int height) {
    const LayeredShear mode(0.25 * height, inner, outer);
    const Slab slab{height};
    const Parameters parameters = two_fluids(height, inner, outer);
    const auto engine = make_engine(parameters, 1);
    fill(*engine, slab, mode, parameters.numerics.cutoff);

    const auto velocity_at = [&](const DenseField& velocity, int z) {
        return velocity.values[static_cast<std::size_t>(3 * 4 * z)];
    };
    const auto amplitude = [&] {
        const DenseField velocity = engine->field("velocity");
        double overlap = 0.0;
        double norm = 0.0;
        for (int z = 0; z < height; ++z) {
            const double expected = mode.rounded(slab.distance(z));
            overlap += expected * velocity_at(velocity, z);
            norm += expected * expected;
        }
        return overlap / norm;
    };
    run(*engine, static_cast<int>(0.3 / mode.rate)); // whatever else was in the initial state dies away
    const double before = amplitude();
    const int steps = static_cast<int>(0.7 / mode.rate);
    run(*engine, steps);
    const double after = amplitude();

    const DenseField velocity = engine->field("velocity");
    double largest = 0.0;
    double difference = 0.0;
    for (int z = 0; z < height; ++z) {
        const double expected = mode.rounded(slab.distance(z));
        largest = std::max(largest, std::abs(expected));
        difference = std::max(difference, std::abs(velocity_at(velocity, z) / after - expected));
    }
    return {std::log(before / after) / steps / mode.rate - 1.0, difference / largest};
}

} // namespace

TEST_CASE("two fluids sheared along their interface: 1 % in decay and profile at 64 cells, second order") {
    struct Viscosities {
        double inner;
        double outer;
    };
    const Viscosities nu = GENERATE(Viscosities{0.05, 0.5}, Viscosities{0.5, 0.1}, Viscosities{1.0, 0.02});
    const Decay coarse = decay_between(nu.inner, nu.outer, 64);
    const Decay fine = decay_between(nu.inner, nu.outer, 96);
    INFO("ratio " << nu.inner / nu.outer << ": decay " << coarse.rate_error << ", " << fine.rate_error
                  << ", profile " << coarse.shape_error << ", " << fine.shape_error);
    CHECK(std::abs(coarse.rate_error) < 0.01);
    CHECK(coarse.shape_error < 0.01);
    CHECK(std::log(coarse.rate_error / fine.rate_error) / std::log(1.5) == Approx(2.0).margin(0.3));
    CHECK(fine.shape_error < 0.6 * coarse.shape_error);
}
