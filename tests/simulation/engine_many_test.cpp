#include "core/input_error.hpp"
#include "lattice/velocity_set.hpp"
#include "measure/surface.hpp"
#include "measure/whole_cells.hpp"
#include "simulation/engine_cases.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace vesica;
using namespace vesica::test;

namespace {

/// Two vesicles above each other, of different types, that tumble and deform while they are pressed together.
Parameters pressed_pair(double gap = 6.0) {
    Parameters parameters;
    parameters.size = {30, 28, 44};
    parameters.fluid.kinematic_viscosity = 1.0 / 3.0;
    VesicleType stiff;
    stiff.name = "stiff";
    stiff.bending.modulus = 0.1;
    stiff.buoyancy = {0.0, 0.0, 2e-4};
    VesicleType soft = stiff;
    soft.name = "soft";
    soft.bending.modulus = 0.05;
    soft.viscosity_ratio = 3.0;
    soft.buoyancy = {0.0, 0.0, -2e-4};
    parameters.types = {stiff, soft};
    VesicleParameters vesicle;
    vesicle.shape = SpheroidShape{0.75};
    vesicle.radius = 7.0;
    vesicle.axis = {0.2, 0.1, 1.0};
    const double apart = 7.0 * std::cbrt(0.75 * 0.75) + 0.5 * gap;
    vesicle.centre = {15.0, 14.0, 22.0 - apart};
    parameters.vesicles.push_back(vesicle);
    vesicle.type = 1;
    vesicle.centre = {16.0, 14.5, 22.0 + apart};
    vesicle.axis = {0.0, 0.3, 1.0};
    parameters.vesicles.push_back(vesicle);
    return parameters;
}

/// The sum of all vesicles' shares in each cell.
std::vector<double> shares_of(const EngineState& state) {
    const auto cells = static_cast<std::size_t>(state.part.volume());
    std::vector<double> shares(cells, 0.0);
    for (std::size_t at = 0; at < state.minority.size(); ++at) {
        const double chi = state.minority[at];
        shares[at % cells] += std::signbit(chi) ? 1.0 - std::abs(chi) : chi;
    }
    return shares;
}

double euler_number(const VesicleSnapshot& vesicle) {
    const SurfaceMesh surface = extract_surface(on_whole_cells(vesicle));
    return static_cast<double>(surface.points.size()) - 0.5 * static_cast<double>(surface.triangles.size());
}

MetricsRow row_of(const Engine& engine, std::size_t vesicle) {
    const Snapshot snapshot = engine.snapshot();
    return measure(snapshot.vesicles[vesicle], snapshot,
                   baseline_of(snapshot.vesicles[vesicle], static_cast<int>(vesicle)));
}

} // namespace

TEST_CASE("vesicles that do not meet are what they are with one colour for all") {
    Parameters parameters = deforming_spheroid();
    parameters.size = {32, 32, 96};
    parameters.types.front().area.constraint = NoConstraint{};
    parameters.vesicles.front().centre = {16.0, 16.0, 24.0};
    parameters.vesicles.push_back(parameters.vesicles.front());
    parameters.vesicles.back().centre = {17.0, 14.0, 72.0};
    const auto several = make_engine(parameters, 2);
    parameters.vesicles.back().joins_previous = true;
    const auto one = make_engine(parameters, 2);
    run(*several, 100);
    run(*one, 100);
    REQUIRE(several->snapshot().vesicles.size() == 2);
    REQUIRE(one->snapshot().vesicles.size() == 1);
    const DenseField a = several->field("phase");
    const DenseField b = one->field("phase");
    const DenseField u = several->field("velocity");
    const DenseField v = one->field("velocity");
    double worst = 0.0;
    for (std::size_t k = 0; k < a.values.size(); ++k)
        worst = std::max(worst, std::abs(a.values[k] - b.values[k]));
    for (std::size_t k = 0; k < u.values.size(); ++k)
        worst = std::max(worst, std::abs(u.values[k] - v.values[k]));
    CHECK(worst < 1e-12);
    CHECK(several->interface_fraction() == one->interface_fraction());
}

TEST_CASE("vesicles that are pressed together keep their masses, and a film of fluid between them") {
    const auto engine = make_engine(pressed_pair(), 2);
    const Snapshot before = engine->snapshot();
    double closest = 1e9;
    double fullest = 0.0;
    for (int k = 0; k < 4; ++k) {
        run(*engine, 250);
        closest = std::min(closest, row_of(*engine, 0).gap);
        for (const double share : shares_of(engine->save()))
            fullest = std::max(fullest, share);
    }
    const Snapshot after = engine->snapshot();
    REQUIRE(after.vesicles.size() == 2);
    for (std::size_t k = 0; k < 2; ++k) {
        CHECK(after.vesicles[k].colour_mass == Approx(before.vesicles[k].colour_mass).epsilon(1e-12));
        CHECK(euler_number(after.vesicles[k]) == 2.0);
        CHECK(row_of(*engine, k).area_ratio == Approx(1.0).epsilon(0.01));
    }
    CHECK(row_of(*engine, 0).gap == Approx(row_of(*engine, 1).gap).margin(0.3));
    CHECK(closest < 4.0); // their layers overlap
    CHECK(closest > 0.0);
    CHECK(fullest < 1.0 + 1e-9); // what they leave is the fluid outside
    CHECK_FALSE(engine->trouble());
}

TEST_CASE("a pair passes on both sides alike") {
    // Turned by half a turn about y through the middle, one is the other, and up is down.
    Parameters parameters = pressed_pair();
    parameters.types[1] = parameters.types[0];
    parameters.types[1].buoyancy = {0.0, 0.0, -2e-4};
    for (VesicleParameters& vesicle : parameters.vesicles)
        vesicle.axis = {0.3, 0.0, 1.0};
    parameters.vesicles[0].centre = {13.0, 14.0, 14.0};
    parameters.vesicles[1].centre = {17.0, 14.0, 30.0};
    const auto engine = make_engine(parameters, 2);
    run(*engine, 1000);
    const MetricsRow a = row_of(*engine, 0);
    const MetricsRow b = row_of(*engine, 1);
    CHECK(a.gap < 4.0);
    CHECK(std::abs(a.x - 13.0) > 0.02);
    CHECK(a.x + b.x == Approx(30.0).epsilon(1e-10));
    CHECK(a.y == Approx(b.y).epsilon(1e-10));
    CHECK(a.z + b.z == Approx(44.0).epsilon(1e-10));
    CHECK(a.area == Approx(b.area).epsilon(1e-10));
    CHECK(a.tension == Approx(b.tension).epsilon(1e-7));
}

/// A pair on both sides of a thin wall, of which a row's last tile has fluid cells of one and solid cells
/// that the other's band reaches.
Parameters pair_about_a_wall(int length) {
    Parameters parameters = pressed_pair(6.0);
    parameters.size = {length, 26, 26};
    parameters.ends[0] = WallEnds{};
    parameters.types[0].buoyancy = {2e-4, 0.0, 0.0};
    parameters.types[1].buoyancy = {-2e-4, 0.0, 0.0};
    for (VesicleParameters& vesicle : parameters.vesicles) {
        vesicle.axis = {0.0, 0.0, 1.0};
        vesicle.radius = 6.0;
    }
    parameters.vesicles[0].centre = {length - 9.0, 13.0, 13.0};
    parameters.vesicles[1].centre = {9.0, 13.0, 13.0};
    return parameters;
}

TEST_CASE("the order in which vesicles are listed does not matter, near each other or about a wall") {
    Parameters parameters = GENERATE(pressed_pair(3.0), pair_about_a_wall(36), pair_about_a_wall(40));
    const auto first = make_engine(parameters, 2);
    std::swap(parameters.vesicles[0], parameters.vesicles[1]);
    const auto second = make_engine(parameters, 1);
    run(*first, 100);
    run(*second, 100);
    // Only the order of sums differs.
    const EngineState one = first->save();
    const EngineState other = second->save();
    double worst = 0.0;
    for (std::size_t i = 0; i < one.populations.size(); ++i)
        for (std::size_t at = 0; at < one.populations[i].size(); ++at)
            worst = std::max(worst, std::abs(one.populations[i][at] - other.populations[i][at]));
    CHECK(worst < 1e-14);
    const Snapshot a = first->snapshot();
    const Snapshot b = second->snapshot();
    for (std::size_t k = 0; k < 2; ++k) {
        CHECK(a.vesicles[k].colour_mass == Approx(b.vesicles[1 - k].colour_mass).epsilon(1e-13));
        CHECK(a.vesicles[k].tension == Approx(b.vesicles[1 - k].tension).epsilon(1e-9));
    }
    // Every membrane's force is counted once.
    Vec3<double> whole{};
    for (const VesicleSnapshot& vesicle : a.vesicles)
        for (const InterfaceCell& cell : vesicle.cells)
            whole = whole + cell.force;
    const DenseField force = first->field("force");
    double scale = 0.0;
    Vec3<double> field{};
    for (std::size_t k = 0; k < force.values.size(); ++k) {
        field[static_cast<int>(k % 3)] += force.values[k];
        scale += std::abs(force.values[k]);
    }
    CHECK(norm(whole - field) < 1e-12 * scale);
}

TEST_CASE("many vesicles have the same bits with any number of threads, and after a pause") {
    const Precision precision = GENERATE(Precision::double_precision, Precision::single_precision);
    Parameters parameters = pressed_pair(4.0);
    parameters.numerics.precision = precision;
    parameters.vesicles.push_back(parameters.vesicles.front()); // across the box's faces
    parameters.vesicles.back().centre = {1.0, 27.0, 43.0};
    const auto one = make_engine(parameters, 1);
    const auto three = make_engine(parameters, 3);
    run(*one, 81);
    run(*three, 81);
    const EngineState state = one->save();
    CHECK(state.slots() > 1);
    CHECK(same_state(state, three->save()));
    const auto resumed = make_engine(parameters, 2);
    resumed->load(state);
    CHECK(same_state(resumed->save(), state));
    run(*one, 70);
    run(*resumed, 70);
    CHECK(same_state(one->save(), resumed->save()));
}

TEST_CASE("a state of another number of vesicles is refused") {
    const Parameters parameters = pressed_pair();
    Parameters fewer = parameters;
    fewer.vesicles.pop_back();
    const auto two = make_engine(parameters, 1);
    const auto one = make_engine(fewer, 1);
    CHECK_THROWS_AS(one->load(two->save()), RunError);
    CHECK_THROWS_AS(two->load(one->save()), RunError);
}

TEST_CASE("each vesicle is as viscous and as buoyant as its type") {
    Parameters parameters = pressed_pair(14.0);
    const auto engine = make_engine(parameters, 2);
    run(*engine, 300);
    // One sinks, the other rises, and the box as a whole stays where it is.
    CHECK(row_of(*engine, 0).vz > 1e-4);
    CHECK(row_of(*engine, 1).vz < -1e-4);
    double momentum = 0.0;
    const EngineState state = engine->save();
    for (std::size_t at = 0; at < state.populations[0].size(); ++at)
        for (int i = 0; i < direction_count; ++i)
            momentum += velocity(i, 2) * state.populations[static_cast<std::size_t>(i)][at];
    const double pushed = 300 * 2e-4 * 4.0 / 3.0 * 3.14159 * 343.0;
    CHECK(std::abs(momentum) < 2e-4 * pushed);
    // The more viscous one is the slower for it.
    parameters.types[1].viscosity_ratio = 1.0;
    const auto alike = make_engine(parameters, 2);
    run(*alike, 300);
    CHECK(row_of(*alike, 1).vz / row_of(*engine, 1).vz > 1.03);
    CHECK(row_of(*alike, 0).vz / row_of(*engine, 0).vz == Approx(1.0).epsilon(0.02));
}

TEST_CASE("what lies deep inside of one of several vesicles is its own") {
    // So large that there are tiles beyond their bands, and runs of cells that a state tells of one by one.
    Parameters parameters = pressed_pair(6.0);
    parameters.size = {58, 56, 112};
    for (VesicleParameters& vesicle : parameters.vesicles) {
        vesicle.shape = SphereShape{};
        vesicle.radius = 23.0;
    }
    parameters.vesicles[0].centre = {30.0, 28.0, 29.0};
    parameters.vesicles[1].centre = {3.0, 27.0, 81.0}; // across a face
    const auto engine = make_engine(parameters, 2);
    const Snapshot before = engine->snapshot();
    const double volume = 4.0 / 3.0 * 3.14159265 * 23.0 * 23.0 * 23.0;
    for (const VesicleSnapshot& vesicle : before.vesicles) {
        CHECK(vesicle.inside.size() > 20);
        CHECK(vesicle.colour_mass == Approx(volume).epsilon(0.02));
    }
    run(*engine, 30);
    const EngineState state = engine->save();
    const auto resumed = make_engine(parameters, 1);
    resumed->load(state);
    CHECK(same_state(resumed->save(), state));
    run(*engine, 10);
    run(*resumed, 10);
    CHECK(same_state(engine->save(), resumed->save()));
    const Snapshot after = resumed->snapshot();
    for (std::size_t k = 0; k < 2; ++k)
        CHECK(after.vesicles[k].colour_mass == Approx(before.vesicles[k].colour_mass).epsilon(1e-12));
}
