#include "exact_field.hpp"
#include "measure/layer_sum.hpp"
#include "measure/surface.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <random>

using namespace vesica;
using std::numbers::pi;

namespace {

const Vec3<double> skew = (1.0 / std::sqrt(14.0)) * Vec3<double>{1.0, -2.0, 3.0};

DenseBlock block_of(int edge) {
    return {{0, 0, 0},
            {edge, edge, edge},
            std::vector<double>(static_cast<std::size_t>(edge * edge * edge), 1.0)};
}

} // namespace

TEST_CASE("the surface of a sphere is closed, has Euler number 2, and faces outwards", "[measure]") {
    const exact::Sphere sphere{{30.3, 29.8, 30.1}, 12.0};
    const auto vesicle = exact::snapshot_of(sphere, {30, 30, 30}, 28);
    const SurfaceMesh mesh = extract_surface(vesicle);
    CHECK(is_closed(mesh));
    CHECK(euler_number(mesh) == 2);
    CHECK(mesh_volume(mesh) == Approx(4.0 / 3.0 * pi * 1728.0).epsilon(5e-3));
    CHECK(mesh_volume(mesh) < 4.0 / 3.0 * pi * 1728.0); // facets cut corners
    CHECK(mesh_area(mesh) == Approx(4.0 * pi * 144.0).epsilon(5e-3));
    for (const Vec3<double>& point : mesh.points)
        CHECK(std::abs(sphere(point).s) < 0.04);
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vec3<double> normal = cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]);
        CHECK(norm(normal) > 0.0);
        if (norm(normal) > 1e-2)
            CHECK(dot(normal, mesh.points[a] - sphere.centre) > 0.0);
    }
}

TEST_CASE("the surface of a torus has Euler number 0", "[measure]") {
    const auto vesicle = exact::snapshot_of(exact::Torus{{0.1, 0.2, 0.3}, 16.0, 8.0, skew}, {0, 0, 0}, 42);
    const SurfaceMesh mesh = extract_surface(vesicle);
    CHECK(is_closed(mesh));
    CHECK(euler_number(mesh) == 0);
    CHECK(mesh_area(mesh) == Approx(4.0 * pi * pi * 16.0 * 8.0).epsilon(1e-2));
    CHECK(mesh_volume(mesh) == Approx(2.0 * pi * pi * 16.0 * 64.0).epsilon(1e-2));
}

TEST_CASE("the surface's area and volume converge with second order", "[measure]") {
    const auto errors = [](double radius) {
        const auto mesh =
            extract_surface(exact::snapshot_of(exact::Sphere{{0.3, 0.1, 0.2}, radius}, {0, 0, 0}, 38));
        return std::array{1.0 - mesh_area(mesh) / (4.0 * pi * radius * radius),
                          1.0 - mesh_volume(mesh) / (4.0 / 3.0 * pi * radius * radius * radius)};
    };
    const auto coarse = errors(10.0);
    const auto fine = errors(20.0);
    CHECK(coarse[0] / fine[0] > 3.6);
    CHECK(coarse[1] / fine[1] > 3.6);
}

TEST_CASE("any signs on the nodes give a closed surface, zeros included", "[measure]") {
    std::mt19937_64 random(3);
    std::uniform_int_distribution<int> value(-1, 1);
    for (int trial = 0; trial < 20; ++trial) {
        DenseBlock block = block_of(8);
        for (int k = 1; k < 7; ++k)
            for (int j = 1; j < 7; ++j)
                for (int i = 1; i < 7; ++i)
                    block.values[block.index(i, j, k)] = value(random);
        const SurfaceMesh mesh = extract_surface(block);
        CHECK(is_closed(mesh));
        CHECK(mesh_volume(mesh) > 0.0);
        for (const auto& [a, b, c] : mesh.triangles) {
            const Vec3<double> normal =
                cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]);
            REQUIRE(norm(normal) >
                    1e-9); // degenerate to a point where several nodes are zero, if not kept apart
        }
    }
}

TEST_CASE("one node inside, at depth, is wrapped into a small closed surface around it", "[measure]") {
    DenseBlock block = block_of(3);
    block.origin = {100, -50, 7};
    block.values[block.index(1, 1, 1)] = -1.0;
    const SurfaceMesh mesh = extract_surface(block);
    CHECK(is_closed(mesh));
    CHECK(euler_number(mesh) == 2);
    CHECK(mesh.points.size() == 14); // a node of the Kuhn subdivision has 14 neighbours
    Vec3<double> mean;
    for (const Vec3<double>& point : mesh.points)
        mean = mean + (1.0 / 14.0) * point;
    CHECK(norm(mean - Vec3<double>{101.5, -48.5, 8.5}) < 1e-12);
    CHECK(mesh_volume(mesh) == Approx(0.5));
}

TEST_CASE("a surface that runs into the block's rim is not closed", "[measure]") {
    DenseBlock block = block_of(4);
    block.values[block.index(0, 1, 1)] = -1.0;
    CHECK_FALSE(is_closed(extract_surface(block)));
}

TEST_CASE("quantities of the cells arrive on the surface's points", "[measure]") {
    const exact::Spheroid shape{{0.2, 0.1, -0.3}, 14.0, 10.0, skew};
    const auto vesicle = exact::snapshot_of(shape, {0, 0, 0}, 30);
    const SurfaceMesh mesh = extract_surface(vesicle);
    const DenseBlock frame = phase_block(vesicle);
    const auto H = interpolate(mesh, nodal_values(vesicle, frame, [](const auto& cell) { return cell.H0; }));
    const auto x =
        interpolate(mesh, nodal_values(vesicle, frame, [](const auto& cell) { return cell.position.x; }));
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
        REQUIRE(H[i] == Approx(shape(mesh.points[i]).H0).epsilon(1e-2));
        REQUIRE(x[i] == Approx(mesh.points[i].x).margin(1e-12));
    }
}
