#include "simulation/engine_cases.hpp"
#include "simulation/flow_drive.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace vesica;
using namespace vesica::test;

namespace {

template <class IsSolid>
ObstacleParameters voxels(const Vec3<int>& size, const IsSolid& is_solid) {
    SolidVoxels solids(size);
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                if (is_solid(Vec3<int>{x, y, z}))
                    solids.set({x, y, z});
    ObstacleParameters obstacles;
    obstacles.file = "made here";
    obstacles.voxels = std::make_shared<const SolidVoxels>(std::move(solids));
    return obstacles;
}

double at(const DenseField& u, const Vec3<int>& cell, int component) {
    return u
        .values[static_cast<std::size_t>(3 * (cell.x + u.size.x * (cell.y + u.size.y * cell.z)) + component)];
}

} // namespace

TEST_CASE("slabs of solid voxels bound a channel as walls do") {
    Parameters parameters;
    parameters.size = {5, 15, 7};
    parameters.fluid.ghosts = TrtGhosts{3.0 / 16.0};
    parameters.obstacles =
        voxels(parameters.size, [](const Vec3<int>& cell) { return cell.y < 3 || cell.y >= 13; });
    parameters.flow.poiseuille = PoiseuilleFlow{1e-6, {}, 2, {}};
    const auto engine = make_engine(parameters, 1);
    run(*engine, 3000);
    const DenseField u = engine->field("velocity");
    for (int y = 0; y < 15; ++y) {
        const double height = y + 0.5 - 3.0;
        const double expected = height > 0.0 && height < 10.0 ? 3e-6 * height * (10.0 - height) : 0.0;
        CHECK(at(u, {2, y, 3}, 2) == Approx(expected).epsilon(1e-6).margin(1e-15));
    }
}

TEST_CASE("an array of spheres resists a flow as Hasimoto found") {
    Parameters parameters;
    parameters.size = {24, 24, 24};
    parameters.fluid.ghosts = TrtGhosts{3.0 / 16.0};
    const double radius = 5.2;
    const auto is_solid = [&](const Vec3<int>& cell) {
        return norm(Vec3<double>{cell.x - 11.5, cell.y - 11.5, cell.z - 11.5}) < radius;
    };
    parameters.obstacles = voxels(parameters.size, is_solid);
    const double push = 1e-6;
    parameters.flow.body_force = BodyForce{{push, 0.0, 0.0}, {}};
    const auto engine = make_engine(parameters, 2);
    run(*engine, 3000);
    const DenseField u = engine->field("velocity");
    double flow = 0.0;
    for (std::size_t k = 0; k < u.values.size(); k += 3)
        flow += u.values[k];
    const double cells = 24.0 * 24.0 * 24.0;
    const double solid = static_cast<double>(parameters.obstacles->voxels->count());
    const double a = std::cbrt(3.0 * solid / (4.0 * std::numbers::pi));
    const double c = solid / cells;
    // With the mean pressure gradient upon the spheres the drag is push times the whole volume, u the
    // superficial velocity (Hasimoto 1959).
    const double drag = push * cells;
    const double open = 1.0 - 1.7601 * std::cbrt(c) + c - 1.5593 * c * c;
    const double expected = drag * open / (6.0 * std::numbers::pi * (1.0 / 6.0) * a);
    CHECK(flow / cells == Approx(expected).epsilon(0.06));
    CHECK_FALSE(engine->trouble());
}

TEST_CASE("a vesicle is driven round a post, touches it and keeps its mass") {
    Parameters parameters;
    parameters.size = {40, 20, 26};
    parameters.obstacles = voxels(parameters.size, [](const Vec3<int>& cell) {
        return std::hypot(cell.x + 0.5 - 30.0, cell.z + 0.5 - 13.0) < 4.0;
    });
    VesicleType type;
    type.bending.modulus = 0.1;
    parameters.types = {type};
    VesicleParameters vesicle;
    vesicle.radius = 7.0;
    vesicle.centre = {15.0, 10.0, 15.0};
    parameters.vesicles = {vesicle};
    parameters.flow.body_force = BodyForce{{2e-5, 0.0, 0.0}, {}};
    const auto engine = make_engine(parameters, 1);
    const auto mass = [&] {
        return engine->snapshot().vesicles.front().colour_mass;
    };
    const double before = mass();
    run(*engine, 2000);
    REQUIRE_FALSE(engine->trouble());
    CHECK(std::abs(mass() / before - 1.0) < 1e-12);
    CHECK(metrics_of(*engine).x > 18.0);
}

TEST_CASE("the gap of a vesicle is that to the nearest obstacle, too") {
    Parameters parameters;
    parameters.size = {26, 26, 34};
    VesicleType type;
    type.bending.modulus = 0.2;
    parameters.types = {type};
    VesicleParameters vesicle;
    vesicle.radius = 7.0;
    vesicle.centre = {13.0, 13.0, 15.7};
    parameters.vesicles = {vesicle};
    parameters.obstacles = voxels(parameters.size, [](const Vec3<int>& cell) { return cell.z < 5; });
    CHECK(metrics_of(*make_engine(parameters, 1)).gap == Approx(15.7 - 7.0 - 5.0).margin(0.1));
    parameters.vesicles.front().centre.z = 15.2;
    CHECK(metrics_of(*make_engine(parameters, 1)).gap == Approx(15.2 - 7.0 - 5.0).margin(0.1));
}
