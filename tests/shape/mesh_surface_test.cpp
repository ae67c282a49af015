#include "shape/directions.hpp"
#include "shape/mesh_surface.hpp"
#include "shape/sample_meshes.hpp"

#include <catch2/catch.hpp>

#include <numbers>

using namespace vesica;
using std::numbers::pi;

namespace {

/// Two cones of the given half height on one ring, most of whose points crowd around one azimuth.
TriangleMesh crowded_double_cone(double half_height) {
    TriangleMesh mesh;
    mesh.vertices = {{0.0, 0.0, half_height}, {0.0, 0.0, -half_height}};
    constexpr int count = 20;
    for (int i = 0; i < count; ++i) {
        const double azimuth = i < count - 3 ? 0.02 * i : pi / 2.0 * (i - count + 4);
        mesh.vertices.push_back({std::cos(azimuth), std::sin(azimuth), 0.0});
    }
    for (int i = 0; i < count; ++i) {
        const int here = 2 + i, next = 2 + (i + 1) % count;
        mesh.triangles.push_back({0, here, next});
        mesh.triangles.push_back({1, next, here});
    }
    return mesh;
}

/// How often the mesh winds around a point: the solid angles of its triangles over 4 pi (Van Oosterom &
/// Strackee 1983). One inside, zero outside.
double winding_number(const TriangleMesh& mesh, const Vec3<double>& p) {
    double sum = 0.0;
    for (const auto& t : mesh.triangles) {
        const Vec3<double> a = mesh.vertices[static_cast<std::size_t>(t[0])] - p;
        const Vec3<double> b = mesh.vertices[static_cast<std::size_t>(t[1])] - p;
        const Vec3<double> c = mesh.vertices[static_cast<std::size_t>(t[2])] - p;
        const double la = norm(a), lb = norm(b), lc = norm(c);
        sum += 2.0 * std::atan2(dot(a, cross(b, c)),
                                la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
    }
    return sum / (4.0 * pi);
}

} // namespace

TEST_CASE("A cube's distance is exact at faces, edges and corners, inside and outside") {
    const MeshSurface shape(cube(), 0.0);
    const auto exact = [](const Vec3<double>& p) {
        const double x = std::abs(p.x) - 1.0, y = std::abs(p.y) - 1.0, z = std::abs(p.z) - 1.0;
        const double outside = std::hypot(std::max(x, 0.0), std::max(y, 0.0), std::max(z, 0.0));
        return outside + std::min(std::max({x, y, z}), 0.0);
    };
    for (const Vec3<double>& u : directions(500))
        for (const double r : {0.1, 0.8, 1.1, 1.7, 4.0}) {
            CHECK(shape.signed_distance(r * u) == Approx(exact(r * u)).margin(1e-13));
        }
    CHECK(shape.signed_distance({2.0, 2.0, 2.0}) == Approx(std::sqrt(3.0)));
    CHECK(shape.signed_distance({0.0, 0.0, 0.0}) == Approx(-1.0));
    CHECK(shape.volume() == Approx(8.0));
    CHECK(shape.area() == Approx(24.0));
}

TEST_CASE("An icosphere approaches the sphere with the square of its edges") {
    double last = 0.0;
    for (const int levels : {2, 3, 4}) {
        const MeshSurface shape(icosphere(levels), 15.0);
        CHECK(shape.volume() == Approx(4.0 * pi / 3.0 * 3375.0).epsilon(1e-12));
        double worst = 0.0;
        for (const Vec3<double>& u : directions(300))
            for (const double r : {11.0, 15.0, 19.0})
                worst = std::max(worst, std::abs(shape.signed_distance(r * u) - (r - 15.0)));
        if (last > 0.0) {
            CHECK(last / worst > 3.5);
            CHECK(last / worst < 4.5);
        }
        last = worst;
        CHECK(shape.area() == Approx(4.0 * pi * 225.0).epsilon(0.2 * worst));
    }
    CHECK(MeshSurface(icosphere(4), 15.0).smallest_radius_of_curvature() == Approx(15.0).epsilon(0.02));
}

TEST_CASE("A mesh is scaled to its radius and moved to its centre of volume, wherever it stood") {
    TriangleMesh mesh = icosphere(3);
    for (Vec3<double>& v : mesh.vertices)
        v = 1e-3 * v + Vec3<double>{5.0, -7.0, 11.0};
    const MeshSurface far_away(mesh, 15.0), here(icosphere(3), 15.0);
    for (const Vec3<double>& u : directions(50))
        CHECK(far_away.signed_distance(16.0 * u) == Approx(here.signed_distance(16.0 * u)).margin(1e-9));
}

TEST_CASE("The distance to a mesh has gradient one and the side's sign in a dent") {
    TriangleMesh mesh = icosphere(4);
    for (Vec3<double>& v : mesh.vertices)
        v.z *= 0.3 + 0.5 * (v.x * v.x + v.y * v.y); // biconcave
    const MeshSurface shape(mesh, 10.0);
    for (const Vec3<double>& u : directions(200)) {
        const Vec3<double> x = (8.0 + 5.0 * u.x) * u;
        const double gradient = norm(distance_gradient(shape, x, 1e-6));
        CHECK(gradient < 1.0 + 1e-8);
        CHECK(gradient > 0.8); // less than one only where a step straddles two closest points
    }
    CHECK(shape.signed_distance({0.0, 0.0, 0.0}) < 0.0);
    CHECK(shape.signed_distance({0.0, 0.0, 6.0}) > 0.0);
    CHECK(shape.signed_distance({100.0, 0.0, 0.0}) > Shape::reach);
}

TEST_CASE("The sign is right around sharp corners and rims, whatever the shapes of their triangles") {
    for (const double half_height : {0.02, 0.3, 3.0}) {
        const TriangleMesh mesh = normalised(crowded_double_cone(half_height), 0.0);
        const MeshSurface shape(mesh, 0.0);
        REQUIRE(shape.volume() > 0.0);
        int inside = 0;
        for (const Vec3<double>& corner : mesh.vertices)
            for (const Vec3<double>& u : directions(200)) {
                const Vec3<double> x = corner + 0.05 * u;
                const bool expected = winding_number(mesh, x) > 0.5;
                inside += expected;
                CHECK((shape.signed_distance(x) < 0.0) == expected);
            }
        CHECK(inside > 10);
    }
}
