#include "core/exact_sum.hpp"
#include "lattice/velocity_set.hpp"
#include "measured.hpp"
#include "simulation/engine.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <string>

using namespace vesica;

namespace {

/// A drop: a vesicle without bending or constraint.
Parameters drop(int edge, double radius, double sigma, Precision precision) {
    Parameters parameters;
    parameters.size = {edge, edge, edge};
    VesicleType type;
    type.area.constraint = NoConstraint{};
    type.sigma = sigma;
    parameters.types.push_back(type);
    VesicleParameters vesicle;
    vesicle.radius = radius;
    vesicle.centre = {0.5 * edge, 0.5 * edge, 0.5 * edge};
    parameters.vesicles.push_back(vesicle);
    parameters.numerics.precision = precision;
    return parameters;
}

/// Gives the whole box a velocity, colours and all.
void set_in_motion(Engine& engine, const Vec3<double>& u) {
    EngineState state = engine.save();
    for (int i = 0; i < direction_count; ++i) {
        const double cu = u.x * velocity(i, 0) + u.y * velocity(i, 1) + u.z * velocity(i, 2);
        const double g = weight(i) * (3.0 * cu + 4.5 * cu * cu - 1.5 * dot(u, u));
        for (double& value : state.populations[static_cast<std::size_t>(i)])
            value = g;
    }
    engine.load(state);
}

/// Where the red is, by the phase of its first harmonic along each axis of the periodic box.
Vec3<double> centre_of_red(const Engine& engine) {
    const DenseField phase = engine.field("phase");
    const double turn = 2.0 * std::acos(-1.0);
    Vec3<double> sine;
    Vec3<double> cosine;
    std::size_t at = 0;
    for (int z = 0; z < phase.size.z; ++z)
        for (int y = 0; y < phase.size.y; ++y)
            for (int x = 0; x < phase.size.x; ++x) {
                const double red = 0.5 * (1.0 + phase.values[at++]);
                const Vec3<double> angle{turn * (x + 0.5) / phase.size.x, turn * (y + 0.5) / phase.size.y,
                                         turn * (z + 0.5) / phase.size.z};
                for (int a = 0; a < 3; ++a) {
                    sine[a] += red * std::sin(angle[a]);
                    cosine[a] += red * std::cos(angle[a]);
                }
            }
    Vec3<double> centre;
    for (int a = 0; a < 3; ++a)
        centre[a] = std::atan2(sine[a], cosine[a]) / turn * phase.size[a];
    return centre;
}

double distance_on_circle(double a, double b, double length) {
    return std::abs(std::remainder(a - b, length));
}

struct Masses {
    double red = 0.0;
    double blue = 0.0;
};

Masses masses(const Engine& engine) {
    ExactSum all;
    for (const double density : engine.field("density").values)
        all.add(density);
    const double red = engine.snapshot().vesicles.front().colour_mass;
    return {red, all.value() - red};
}

void check_masses_stay(Precision precision, int edge, double radius, std::int64_t steps, double tolerance) {
    const auto engine = make_engine(drop(edge, radius, 0.002, precision), 1);
    const Masses before = masses(*engine);
    for (std::int64_t step = 0; step < steps; ++step)
        engine->step();
    const Masses after = masses(*engine);
    CHECK(std::abs(after.red / before.red - 1.0) < tolerance);
    CHECK(std::abs(after.blue / before.blue - 1.0) < tolerance);
    CHECK(!engine->trouble());
    const std::string conditions =
        std::string(precision == Precision::double_precision ? "double" : "single") + ", " +
        std::to_string(steps) + " steps";
    test::measured("red mass, relative change", conditions, after.red / before.red - 1.0);
    test::measured("blue mass, relative change", conditions, after.blue / before.blue - 1.0);
}

} // namespace

TEST_CASE("a drop in uniform flow moves with it, along an axis and askew: no cell holds it back",
          "[colour]") {
    const int edge = 24;
    const int steps = 300;
    for (const Vec3<double>& u : {Vec3<double>{0.02, 0.0, 0.0}, Vec3<double>{0.011, -0.017, 0.005}}) {
        const auto engine = make_engine(drop(edge, 8.0, 0.002, Precision::double_precision), 1);
        set_in_motion(*engine, u);
        const Vec3<double> start = centre_of_red(*engine);
        for (int step = 0; step < steps; ++step)
            engine->step();
        const Vec3<double> end = centre_of_red(*engine);
        for (int a = 0; a < 3; ++a)
            CHECK(distance_on_circle(end[a], start[a] + steps * u[a], edge) < 0.1);
    }
}

TEST_CASE("a drop keeps its mass while the band follows it through the box", "[colour]") {
    // Large enough for pure cells on both sides of the band, fast enough for the band to be laid out anew
    // many times.
    for (const Precision precision : {Precision::double_precision, Precision::single_precision}) {
        const double tolerance = precision == Precision::double_precision ? 1e-14 : 1e-6;
        const auto engine = make_engine(drop(44, 14.5, 0.001, precision), 1);
        set_in_motion(*engine, {0.05, 0.03, 0.01});
        const Masses before = masses(*engine);
        for (int step = 0; step < 100; ++step)
            engine->step();
        const Masses after = masses(*engine);
        CHECK(std::abs(after.red / before.red - 1.0) < tolerance);
        CHECK(std::abs(after.blue / before.blue - 1.0) < tolerance);
    }
}

TEST_CASE("a vesicle's run is the same bit by bit wherever it lies in the periodic box", "[colour]") {
    // A box that is no whole number of tiles, fluids of different viscosity, a vesicle across the faces.
    const int edge = 44;
    const auto run = [](const Vec3<double>& shift) {
        Parameters parameters = drop(edge, 18.0, 0.05, Precision::double_precision);
        parameters.types.front().viscosity_ratio = 5.0;
        parameters.types.front().bending.modulus = 0.1;
        parameters.vesicles.front().shape = SpheroidShape{0.9};
        parameters.vesicles.front().centre = parameters.vesicles.front().centre + shift;
        const auto engine = make_engine(parameters, 1);
        for (int step = 0; step < 30; ++step)
            engine->step();
        return engine->field("velocity");
    };
    const DenseField here = run({});
    const Vec3<int> by{18, 5, 9};
    const DenseField there = run({double(by.x), double(by.y), double(by.z)});
    const auto at = [](int x, int y, int z) {
        return static_cast<std::size_t>(3 * (x % edge + edge * (y % edge + edge * (z % edge))));
    };
    int different = 0;
    for (int z = 0; z < edge; ++z)
        for (int y = 0; y < edge; ++y)
            for (int x = 0; x < edge; ++x)
                for (std::size_t a = 0; a < 3; ++a)
                    different +=
                        here.values[at(x, y, z) + a] != there.values[at(x + by.x, y + by.y, z + by.z) + a];
    CHECK(different == 0);
}

TEST_CASE("each colour's mass stays over thousands of steps", "[colour]") {
    check_masses_stay(Precision::double_precision, 12, 3.5, 4000, 1e-12);
    check_masses_stay(Precision::single_precision, 12, 3.5, 4000, 1e-5);
}

TEST_CASE("each colour's mass stays over a hundred thousand steps in double precision", "[.slow]") {
    check_masses_stay(Precision::double_precision, 16, 5.0, 100000, 1e-11);
}

TEST_CASE("each colour's mass stays over a hundred thousand steps in single precision", "[.slow]") {
    check_masses_stay(Precision::single_precision, 16, 5.0, 100000, 1e-5);
}
