#include "measured.hpp"
#include "simulation/engine_cases.hpp"
#include "simulation/reference_step.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace vesica;
using namespace vesica::test;

namespace {

/// The same vesicle, the fluid in uniform motion.
EngineState set_in_motion(EngineState state, const Vec3<double>& u) {
    for (std::size_t c = 0; c < state.minority.size(); ++c)
        for (int i = 0; i < direction_count; ++i) {
            const double along = velocity(i, 0) * u.x + velocity(i, 1) * u.y + velocity(i, 2) * u.z;
            state.populations[static_cast<std::size_t>(i)][c] +=
                weight(i) * (3.0 * along + 4.5 * along * along - 1.5 * dot(u, u));
        }
    return state;
}

/// The largest ones between an engine's state and the reference's; NaN is the largest of all.
struct Difference {
    double population = 0.0;
    double phase = 0.0;

    static double phase_of(double chi) {
        return (std::signbit(chi) ? 1.0 : -1.0) * (1.0 - 2.0 * std::abs(chi));
    }
    static void widen(double& largest, double difference) {
        if (!(std::abs(difference) <= largest))
            largest = std::abs(difference);
    }
    void take(const EngineState& state, const ReferenceStep& reference) {
        for (std::size_t c = 0; c < state.minority.size(); ++c) {
            for (int i = 0; i < direction_count; ++i)
                widen(population,
                      state.populations[static_cast<std::size_t>(i)][c] - reference.deviation(i, c));
            widen(phase, phase_of(state.minority[c]) - phase_of(reference.minority(c)));
        }
    }
};

} // namespace

TEST_CASE("a thousand steps of a moving, deforming vesicle are those of the plain reference", "[.slow]") {
    Parameters parameters = deforming_spheroid();
    parameters.size = {28, 26, 25}; // rows that end within a tile
    parameters.types.front().area.constraint = NoConstraint{};
    parameters.vesicles.front().shape = SpheroidShape{1.3};
    parameters.vesicles.front().radius = 6.0;
    parameters.vesicles.front().centre = {24.0, 12.0, 3.0};
    const auto in_double = make_engine(parameters, 1);
    parameters.numerics.precision = Precision::single_precision;
    const auto in_single = make_engine(parameters, 1);
    EngineState state = set_in_motion(in_double->save(), {0.02, -0.012, 0.016});
    in_double->load(state);
    ReferenceStep::Constants constants;
    constants.nu = parameters.fluid.kinematic_viscosity;
    constants.beta = parameters.fluid.segregation;
    constants.kappa = parameters.types.front().bending.modulus;
    constants.sigma = parameters.types.front().sigma;
    constants.cutoff = parameters.numerics.cutoff;
    ReferenceStep reference(state, constants);
    state.precision = Precision::single_precision;
    in_single->load(state);
    const double deformation = metrics_of(*in_double).taylor_deformation;

    Difference of_double;
    Difference of_single;
    for (int step = 1; step <= 1000; ++step) {
        in_double->step();
        in_single->step();
        reference.step();
        if (step % 100 == 0) {
            of_double.take(in_double->save(), reference);
            of_single.take(in_single->save(), reference);
        }
    }
    measured("agreement with the plain reference", "populations, double", of_double.population);
    measured("agreement with the plain reference", "phase, double", of_double.phase);
    measured("agreement with the plain reference", "populations, single", of_single.population);
    measured("agreement with the plain reference", "phase, single", of_single.phase);
    CHECK(of_double.population < 1e-10);
    CHECK(of_double.phase < 1e-10);
    CHECK(of_single.population < 1e-4);
    CHECK(of_single.phase < 1e-4);
    // It has been through all of a step: the band followed, across faces, and the shape changed.
    CHECK(reference.layouts() > 10);
    CHECK(std::abs(metrics_of(*in_double).taylor_deformation - deformation) > 0.02);
}
