#include "lattice/velocity_set.hpp"
#include "simulation/engine_cases.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace vesica;
using namespace vesica::test;

namespace {

/// A channel of one fluid with walls across `axis`.
Parameters channel(const Vec3<int>& size, int axis, double nu) {
    Parameters parameters;
    parameters.size = size;
    parameters.ends[static_cast<std::size_t>(axis)] = WallEnds{};
    parameters.fluid.kinematic_viscosity = nu;
    parameters.fluid.ghosts = TrtGhosts{3.0 / 16.0};
    return parameters;
}

/// Of a component of the velocity in the middle of the box, along an axis.
std::vector<double> profile(const Engine& engine, int axis, int component) {
    const DenseField u = engine.field("velocity");
    Vec3<int> cell{u.size.x / 2, u.size.y / 2, u.size.z / 2};
    std::vector<double> values;
    for (cell[axis] = 0; cell[axis] < u.size[axis]; ++cell[axis])
        values.push_back(u.values[static_cast<std::size_t>(
            3 * (cell.x + u.size.x * (cell.y + u.size.y * cell.z)) + component)]);
    return values;
}

/// The largest phi in the cells that lie on the lower wall across z.
double phase_at_wall(const Engine& engine) {
    const DenseField phase = engine.field("phase");
    const auto layer = static_cast<std::ptrdiff_t>(phase.size.x) * phase.size.y;
    return *std::max_element(phase.values.begin(), phase.values.begin() + layer);
}

double colour_mass(const Engine& engine) {
    return engine.snapshot().vesicles.front().colour_mass;
}

} // namespace

TEST_CASE("Couette flow between moving walls is exact, along any pair of axes") {
    const int gradient = GENERATE(0, 1, 2);
    const int velocity = (gradient + GENERATE(1, 2)) % 3;
    Vec3<int> size{9, 9, 9};
    size[gradient] = 12;
    Parameters parameters = channel(size, gradient, 1.0 / 3.0);
    parameters.flow.shear = ShearFlow{1e-3, velocity, gradient, {}};
    const auto engine = make_engine(parameters, 1);
    run(*engine, 2500);
    const std::vector<double> u = profile(*engine, gradient, velocity);
    REQUIRE(u.size() == 12);
    for (std::size_t k = 0; k < u.size(); ++k)
        CHECK(u[k] == Approx(1e-3 * (static_cast<double>(k) + 0.5 - 6.0)).margin(1e-12));
    // The walls hold the stress eta gamma per area.
    const Snapshot snapshot = engine->snapshot();
    const auto& force = snapshot.wall_force[static_cast<std::size_t>(gradient)];
    CHECK(force[1][velocity] == Approx(1e-3 / 3.0 * 81.0).epsilon(1e-9));
    CHECK(force[0][velocity] == Approx(-1e-3 / 3.0 * 81.0).epsilon(1e-9));
}

TEST_CASE("Poiseuille flow is exact at the magic number 3/16, and its walls bear what drives it") {
    const int axis = GENERATE(0, 1, 2);
    const double nu = GENERATE(0.05, 1.0 / 6.0, 0.5);
    const int flow = (axis + 1) % 3;
    Vec3<int> size{7, 7, 7};
    size[axis] = 10;
    Parameters parameters = channel(size, axis, nu);
    const double push = 1e-6;
    parameters.flow.poiseuille = PoiseuilleFlow{push, {}, flow, {}};
    const auto engine = make_engine(parameters, 1);
    run(*engine, static_cast<int>(400.0 / nu));
    const std::vector<double> u = profile(*engine, axis, flow);
    for (std::size_t k = 0; k < u.size(); ++k) {
        const double height = static_cast<double>(k) + 0.5;
        CHECK(u[k] == Approx(push / (2.0 * nu) * height * (10.0 - height)).epsilon(1e-6));
    }
    const auto force = engine->snapshot().wall_force[static_cast<std::size_t>(axis)];
    CHECK(force[0][flow] + force[1][flow] == Approx(-push * 490.0).epsilon(1e-6));
}

TEST_CASE("with other ghost rates Poiseuille flow is second order") {
    const auto error = [](int width) {
        Parameters parameters = channel({5, 5, width}, 2, 0.5);
        parameters.fluid.ghosts = RegularisedGhosts{};
        const double push = 1e-3 * 0.5 / (width * width);
        parameters.flow.poiseuille = PoiseuilleFlow{push, {}, 0, {}};
        const auto engine = make_engine(parameters, 1);
        run(*engine, 3 * width * width);
        const std::vector<double> u = profile(*engine, 2, 0);
        double largest = 0.0;
        for (int k = 0; k < width; ++k) {
            const double height = k + 0.5;
            largest = std::max(largest,
                               std::abs(u[static_cast<std::size_t>(k)] - push * height * (width - height)));
        }
        return largest / (1e-3 * 0.125);
    };
    const double coarse = error(8);
    const double fine = error(16);
    CHECK(coarse > 1e-3); // or there is no order to speak of
    CHECK(std::log2(coarse / fine) > 1.9);
}

TEST_CASE("a duct of moving and resting walls neither gains nor loses fluid") {
    Parameters parameters = channel({11, 9, 10}, 2, 1.0 / 6.0);
    parameters.ends[0] = WallEnds{};
    std::get<WallEnds>(parameters.ends[2]).upper_velocity = {0.02, 0.01, 0.0};
    const auto engine = make_engine(parameters, 1);
    run(*engine, 1000);
    const DenseField density = engine->field("density");
    REQUIRE(density.size == Vec3<int>{11, 9, 10});
    double mass = 0.0;
    for (const double rho : density.values)
        mass += rho;
    CHECK(mass == Approx(990.0).epsilon(1e-12));
    CHECK_FALSE(engine->trouble());
}

TEST_CASE("a wall moves when its times say so") {
    Parameters parameters = channel({5, 5, 8}, 2, 1.0 / 3.0);
    auto& walls = std::get<WallEnds>(parameters.ends[2]);
    walls.lower_velocity = {-0.01, 0.0, 0.0};
    walls.upper_velocity = {0.01, 0.0, 0.0};
    walls.lower_times = {0, 500, 20};
    walls.upper_times = {500, FlowTimes::never, 20};
    const auto engine = make_engine(parameters, 1);
    run(*engine, 480);
    CHECK(profile(*engine, 2, 0).front() == Approx(-0.01 * 7.5 / 8.0).epsilon(1e-3));
    run(*engine, 520);
    CHECK(profile(*engine, 2, 0).front() == Approx(0.01 * 0.5 / 8.0).epsilon(1e-3));
}

TEST_CASE("a vesicle pressed against a wall by its buoyancy keeps its mass and does not stick") {
    const Precision precision = GENERATE(Precision::double_precision, Precision::single_precision);
    Parameters parameters;
    parameters.size = {24, 24, 24};
    parameters.ends[2] = WallEnds{};
    parameters.numerics.precision = precision;
    VesicleType type;
    type.bending.modulus = 0.2;
    type.buoyancy = {0.0, 0.0, -8e-5};
    parameters.types = {type};
    VesicleParameters vesicle;
    vesicle.radius = 7.0;
    vesicle.centre = {12.3, 11.8, 9.0};
    parameters.vesicles = {vesicle};
    const auto engine = make_engine(parameters, 1);
    const double mass = colour_mass(*engine);
    run(*engine, precision == Precision::double_precision ? 1500 : 300);
    REQUIRE_FALSE(engine->trouble());
    const double drift = precision == Precision::double_precision ? 1e-12 : 1e-5;
    CHECK(std::abs(colour_mass(*engine) / mass - 1.0) < drift);
    if (precision == Precision::single_precision)
        return;
    // It has come down, and a film of the outer fluid stays between it and the wall.
    const double lowest = metrics_of(*engine).z;
    CHECK(lowest < 8.0);
    INFO("phi next to the wall " << phase_at_wall(*engine));
    CHECK(phase_at_wall(*engine) > -0.9); // it does touch the wall's force
    CHECK(phase_at_wall(*engine) < 0.0);

    // Pulled the other way it leaves, and leaves nothing behind.
    parameters.types.front().buoyancy.z = 8e-5;
    const auto lifted = make_engine(parameters, 1);
    lifted->load(engine->save());
    run(*lifted, 2000);
    CHECK(metrics_of(*lifted).z > lowest + 1.0);
    CHECK(phase_at_wall(*lifted) < -0.9);
    CHECK(std::abs(colour_mass(*lifted) / mass - 1.0) < drift);
}

TEST_CASE("walls that attract hold on to a drop, and others let it go") {
    const auto pressed = [](double wetting) {
        Parameters parameters;
        parameters.size = {24, 24, 24};
        parameters.ends[2] = WallEnds{};
        parameters.wetting = wetting;
        VesicleType type;
        type.area.constraint = NoConstraint{};
        type.sigma = 2e-3;
        parameters.types = {type};
        VesicleParameters drop;
        drop.radius = 7.0;
        drop.centre = {12.0, 12.0, 6.5}; // it touches the wall from the start
        parameters.vesicles = {drop};
        const auto engine = make_engine(parameters, 1);
        run(*engine, 1000);
        REQUIRE_FALSE(engine->trouble());
        return phase_at_wall(*engine);
    };
    CHECK(pressed(0.02) > 0.3);
    CHECK(pressed(-0.02) < 0.1);
}

TEST_CASE("what comes in at an inlet leaves at the outlet, with the channel's own profile") {
    Parameters parameters = channel({40, 4, 12}, 2, 1.0 / 6.0);
    const bool below = GENERATE(true, false);
    parameters.ends[0] = OpenEnds{below, 0.01, true, 0.0, {0, FlowTimes::never, 200}};
    const auto engine = make_engine(parameters, 1);
    run(*engine, 6000);
    REQUIRE_FALSE(engine->trouble());
    const std::vector<double> u = profile(*engine, 2, 0);
    const double sign = below ? 1.0 : -1.0;
    for (int k = 0; k < 12; ++k) {
        const double height = (k + 0.5) / 12.0;
        CHECK(sign * u[static_cast<std::size_t>(k)] == Approx(0.06 * height * (1.0 - height)).epsilon(0.02));
    }
    // The pressure falls by 12 eta U/H^2 per cell, down to that of the outlet.
    const DenseField p = engine->field("pressure");
    const auto pressure = [&](int x) {
        return p.values[static_cast<std::size_t>(x + 40 * (2 + 4 * 6))];
    };
    const double slope = 12.0 / 6.0 * 0.01 / 144.0;
    CHECK(sign * (pressure(10) - pressure(30)) == Approx(20.0 * slope).epsilon(0.03));
    CHECK(std::abs(pressure(below ? 39 : 0)) < 2.0 * 0.015 * 0.015); // within some rho u^2 of the outlet's
}

TEST_CASE("a box whose ends move with an extension has its flow, exactly") {
    Parameters parameters;
    parameters.size = {16, 4, 20};
    parameters.fluid.kinematic_viscosity = 0.5;
    // Begun at once, it would leave an alternating error behind that nothing damps.
    parameters.flow.extension = ExtensionFlow{1e-4, 0, 2, {0, FlowTimes::never, 500}};
    parameters.ends[0] = parameters.ends[2] = WallEnds{};
    const auto engine = make_engine(parameters, 1);
    run(*engine, 4000);
    const DenseField u = engine->field("velocity");
    double worst = 0.0;
    for (int z = 0; z < 20; ++z)
        for (int x = 0; x < 16; ++x) {
            const auto at = static_cast<std::size_t>(3 * (x + 16 * (1 + 4 * z)));
            worst = std::max({worst, std::abs(u.values[at] - 1e-4 * (x + 0.5 - 8.0)),
                              std::abs(u.values[at + 2] + 1e-4 * (z + 0.5 - 10.0))});
        }
    INFO("largest error " << worst << " of speeds up to 1e-3");
    CHECK(worst < 1e-6);
}

TEST_CASE("what walls gave the fluid is known again when a state has been loaded") {
    const int steps = GENERATE(0, 30, 31);
    Parameters parameters = channel({10, 6, 12}, 2, 1.0 / 3.0);
    parameters.flow.shear = ShearFlow{1e-3, 0, 2, {0, FlowTimes::never, 50}};
    parameters.ends[1] = WallEnds{};
    const auto engine = make_engine(parameters, 1);
    run(*engine, steps);
    const auto again = make_engine(parameters, 1);
    again->load(engine->save());
    CHECK(again->snapshot().wall_force == engine->snapshot().wall_force);
    if (steps == 0)
        CHECK(engine->snapshot().wall_force[2][1].x == 0.0);
    else
        CHECK(engine->snapshot().wall_force[2][1].x > 0.0);
}

TEST_CASE("walls across the third axis of an extension stay as they are") {
    Parameters parameters;
    parameters.size = {12, 10, 12};
    parameters.ends = {WallEnds{}, WallEnds{}, WallEnds{}};
    parameters.flow.extension = ExtensionFlow{1e-3, 0, 2, {1000, FlowTimes::never, 10}};
    const auto engine = make_engine(parameters, 1);
    run(*engine, 50);
    CHECK(engine->snapshot().max_speed == 0.0); // it has not begun yet
}

TEST_CASE("buoyancy is answered by as much, whatever pressure compresses the inside") {
    Parameters parameters;
    parameters.size = {24, 24, 24};
    VesicleType type;
    type.area.constraint = NoConstraint{};
    type.sigma = 0.01;
    type.buoyancy = {0.0, 0.0, 1e-5};
    parameters.types = {type};
    VesicleParameters drop;
    drop.radius = 7.0;
    drop.centre = {12.0, 12.0, 12.0};
    parameters.vesicles = {drop};
    const auto engine = make_engine(parameters, 1);
    run(*engine, 400);
    const EngineState state = engine->save();
    double momentum = 0.0;
    for (int i = 0; i < direction_count; ++i)
        for (const double g : state.populations[static_cast<std::size_t>(i)])
            momentum += velocity(i, 2) * g;
    const double pushed = 400.0 * 1e-5 * 4.0 / 3.0 * 3.14159 * 343.0;
    CHECK(metrics_of(*engine).vz > 1e-5);
    CHECK(std::abs(momentum) < 1e-3 * pushed); // the membrane's own forces add up to no less
}
