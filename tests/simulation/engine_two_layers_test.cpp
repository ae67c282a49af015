#include "colour/phase.hpp"
#include "simulation/engine_cases.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace vesica;
using namespace vesica::test;

namespace {

constexpr double beta = 0.67;
constexpr int height = 40;
constexpr double lower = 12.3; // where the inner fluid begins and ends, away from the cells' faces
constexpr double upper = 27.3;

/// A channel with a layer of another fluid in its middle.
struct Layers {
    double inner;
    double outer;

    static double distance(double z) { return std::max(lower - z, z - upper); }

    /// 1/nu, as it goes over from one fluid to the other.
    double fluidity(double z) const {
        const double red = 0.5 * (1.0 - std::tanh(beta * distance(z)));
        return red / inner + (1.0 - red) / outer;
    }
    double sharp_fluidity(double z) const { return distance(z) < 0.0 ? 1.0 / inner : 1.0 / outer; }
};

/// int from 0 to the middle of each cell and to the far wall, by the midpoint rule.
template <class Function>
std::vector<double> integral(const Function& f) {
    constexpr int parts = 400;
    std::vector<double> sums;
    double sum = 0.0;
    for (int k = 0; k < height * parts; ++k) {
        if (k % parts == parts / 2)
            sums.push_back(sum);
        sum += f((k + 0.5) / parts) / parts;
    }
    sums.push_back(sum);
    return sums;
}

std::unique_ptr<Engine> layered(const Layers& layers, const FlowParameters& flow) {
    Parameters parameters = deforming_spheroid(16, 4.0);
    parameters.size = {4, 1, height};
    parameters.ends[2] = WallEnds{};
    parameters.flow = flow;
    parameters.fluid.kinematic_viscosity = layers.outer;
    parameters.fluid.segregation = beta;
    parameters.fluid.ghosts = TrtGhosts{3.0 / 16.0};
    VesicleType& type = parameters.types[0];
    type.viscosity_ratio = layers.inner / layers.outer;
    type.sigma = 0.0;
    type.bending.modulus = 0.0;
    type.area.constraint = NoConstraint{};
    parameters.vesicles[0].shape = SphereShape{}; // the layer takes its place
    parameters.vesicles[0].centre = {2.0, 0.5, 20.0};
    auto engine = make_engine(parameters, 1);
    EngineState state = engine->save();
    for (std::size_t at = 0; at < state.minority.size(); ++at) {
        const int z = static_cast<int>(at) / 4;
        const double s = Layers::distance(z + 0.5);
        const bool fluid = z < height;
        state.minority[at] =
            fluid ? with_sign_bit(s < 0.0, 1.0 / (1.0 + std::exp(2.0 * beta * std::abs(s)))) : 0.0;
        const bool core = fluid && 1.0 - std::pow(std::tanh(beta * s), 2) > parameters.numerics.cutoff;
        state.band[at] = static_cast<std::uint8_t>((core ? 1 : 0) | (fluid && s < 0.0 ? 2 : 0));
        for (std::vector<double>& population : state.populations)
            population[at] = 0.0;
    }
    engine->load(state);
    return engine;
}

/// Some times the slower fluid's own time, until nothing changes any more.
void settle(Engine& engine, const Layers& layers, double times) {
    run(engine, static_cast<int>(times * height * height / std::min(layers.inner, layers.outer)));
}

double largest_difference(const Engine& engine, const std::vector<double>& expected) {
    const DenseField u = engine.field("velocity");
    double difference = 0.0;
    for (int z = 0; z < height; ++z)
        difference = std::max(difference, std::abs(u.values[static_cast<std::size_t>(3 * 4 * z)] -
                                                   expected[static_cast<std::size_t>(z)]));
    return difference;
}

} // namespace

TEST_CASE("layers of two fluids between walls: Couette and Poiseuille flow within 1 %") {
    const Layers layers = GENERATE(Layers{0.05, 0.5}, Layers{0.5, 0.1}, Layers{1.0, 0.02});
    INFO("viscosities " << layers.inner << " inside, " << layers.outer << " outside");

    SECTION("Couette: one stress everywhere") {
        FlowParameters flow;
        const double rate = 1e-4;
        flow.shear = ShearFlow{rate, 0, 2, {}};
        const auto engine = layered(layers, flow);
        settle(*engine, layers, 0.3);
        const double slip = rate * height;
        const std::vector<double> sharp = integral([&](double z) { return layers.sharp_fluidity(z); });
        const double stress = slip / sharp.back();
        const auto force = engine->snapshot().wall_force[2];
        CHECK(force[1].x == Approx(4.0 * stress).epsilon(0.01));
        CHECK(force[0].x == Approx(-4.0 * stress).epsilon(0.01));
        std::vector<double> u = integral([&](double z) { return layers.fluidity(z); });
        const double by = slip / u.back();
        for (double& value : u)
            value = by * value - 0.5 * slip;
        CHECK(largest_difference(*engine, u) < 0.01 * 0.5 * slip);
    }

    SECTION("Poiseuille: a stress that falls from wall to wall") {
        FlowParameters flow;
        const double push = 1e-7;
        flow.poiseuille = PoiseuilleFlow{push, {}, 0, {}};
        const auto engine = layered(layers, flow);
        settle(*engine, layers, 0.7);
        // tau = tau_0 - push z, with u = 0 at both walls.
        const auto moment = integral([&](double z) { return z * layers.fluidity(z); });
        std::vector<double> u = integral([&](double z) { return layers.fluidity(z); });
        const double at_wall = push * moment.back() / u.back();
        double fastest = 0.0;
        for (std::size_t k = 0; k < u.size(); ++k) {
            u[k] = at_wall * u[k] - push * moment[k];
            fastest = std::max(fastest, u[k]);
        }
        CHECK(largest_difference(*engine, u) < 0.01 * fastest);
    }
}
