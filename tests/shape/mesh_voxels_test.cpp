#include "core/input_error.hpp"
#include "shape/mesh_voxels.hpp"
#include "shape/sample_meshes.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <numbers>

using namespace vesica;
using std::numbers::pi;

namespace {

std::size_t cells(const Vec3<int>& size) {
    return static_cast<std::size_t>(size.x * size.y * size.z);
}

TriangleMesh joined(TriangleMesh a, const TriangleMesh& b, double scale, const Vec3<double>& shift) {
    const int offset = static_cast<int>(a.vertices.size());
    for (const Vec3<double>& v : b.vertices)
        a.vertices.push_back(scale * v + shift);
    for (const auto& t : b.triangles)
        a.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
    return a;
}

/// Around z, the circle of the tube's centres has the radius 1.
TriangleMesh torus(double tube, int along, int around) {
    TriangleMesh mesh;
    mesh.source = "torus";
    for (int i = 0; i < along; ++i)
        for (int j = 0; j < around; ++j) {
            const double u = 2.0 * pi * i / along, v = 2.0 * pi * j / around;
            const double r = 1.0 + tube * std::cos(v);
            mesh.vertices.push_back({r * std::cos(u), r * std::sin(u), tube * std::sin(v)});
            const auto at = [&](int m, int n) {
                return (m % along) * around + n % around;
            };
            mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    return mesh;
}

/// The mesh turned by about 1 radian around an oblique axis.
TriangleMesh turned(TriangleMesh mesh) {
    const double c = std::cos(1.0), s = std::sin(1.0);
    for (Vec3<double>& v : mesh.vertices) {
        v = {c * v.x - s * v.y, s * v.x + c * v.y, v.z};
        v = {v.x, 0.8 * v.y - 0.6 * v.z, 0.6 * v.y + 0.8 * v.z};
    }
    return mesh;
}

} // namespace

TEST_CASE("The voxels of a sphere have its volume, wherever its centre lies") {
    const Vec3<int> size{44, 46, 48};
    const double radius = 20.0;
    for (const Vec3<double>& centre :
         {Vec3<double>{22.0, 23.0, 24.0}, {22.5, 22.5, 22.5}, {21.3, 24.1, 25.7}}) {
        const auto solid = voxelise(icosphere(5), size, radius, centre, true);
        CHECK(solid.size() == size);
        CHECK(static_cast<double>(solid.count()) ==
              Approx(4.0 / 3.0 * pi * radius * radius * radius).epsilon(0.01));
    }
}

TEST_CASE("A centre is solid just where the sphere's equation says so") {
    const Vec3<int> size{30, 30, 30};
    const Vec3<double> centre{15.1, 14.7, 15.4};
    const auto solid = voxelise(icosphere(5), size, 12.0, centre, true);
    std::size_t wrong = 0, close = 0;
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                const double distance = norm(Vec3<double>{x + 0.5, y + 0.5, z + 0.5} - centre) - 12.0;
                if (std::abs(distance) < 0.01) // the triangles are off the sphere by less
                    ++close;
                else if (solid.at({x, y, z}) != (distance < 0.0))
                    ++wrong;
            }
    CHECK(wrong == 0);
    CHECK(close < 100);
}

TEST_CASE("The voxels of a torus have its volume, and its hole is open") {
    const Vec3<int> size{64, 64, 64};
    const double radius = 20.0, tube = 0.4;
    const double volume = 2.0 * pi * pi * tube * tube * radius * radius * radius;
    const TriangleMesh mesh = torus(tube, 120, 60);
    const auto flat = voxelise(mesh, size, radius, {32.0, 32.0, 32.0}, true);
    CHECK(static_cast<double>(flat.count()) == Approx(volume).epsilon(0.01));
    for (int z = 0; z < size.z; ++z)
        CHECK(!flat.at({32, 32, z}));
    CHECK(flat.at({52, 32, 32}));
    const auto oblique = voxelise(turned(mesh), size, radius, {32.0, 32.0, 32.0}, true);
    CHECK(static_cast<double>(oblique.count()) == Approx(volume).epsilon(0.01));
    CHECK(!oblique.at({32, 32, 32}));
}

TEST_CASE("A cube whose faces run through centres keeps its volume, and so do its neighbours") {
    // Edges 10 cells long; corners, edges and the diagonals of faces all meet rows of centres.
    const Vec3<int> size{24, 24, 24};
    const auto one = voxelise(cube(), size, 5.0, {7.5, 8.5, 9.5}, true);
    CHECK(one.count() == 1000);
    for (int x = 0; x < size.x; ++x)
        CHECK(one.at({x, 8, 9}) == (x >= 2 && x < 12));
    CHECK(one.at({2, 3, 4}));
    CHECK(!one.at({12, 3, 4}));
    CHECK(!one.at({2, 13, 4}));
    CHECK(!one.at({2, 3, 14}));

    const auto next = voxelise(cube(), size, 5.0, {17.5, 8.5, 9.5}, true);
    CHECK(next.count() == 1000);
    std::size_t both = 0;
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                both += one.at({x, y, z}) && next.at({x, y, z}) ? 1u : 0u;
    CHECK(both == 0);

    CHECK(voxelise(cube(), size, 5.0, {12.0, 12.0, 12.0}, true).count() == 1000);
    CHECK(voxelise(cube(), size, 5.0, {11.77, 12.31, 12.49}, true).count() == 1000);
}

TEST_CASE("An octahedron with every vertex and edge on rows of centres has all its cells") {
    TriangleMesh mesh;
    mesh.source = "octahedron";
    mesh.vertices = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    const Vec3<int> size{21, 21, 21};
    const auto solid = voxelise(mesh, size, 8.0, {10.5, 10.5, 10.5}, true);
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                const int beyond = std::abs(x - 10) + std::abs(y - 10) + std::abs(z - 10) - 8;
                if (beyond != 0) // the centres on the surface belong to either side
                    REQUIRE(solid.at({x, y, z}) == (beyond < 0));
            }
}

TEST_CASE("Outside is the complement of inside, also for a body that leaves the box") {
    const Vec3<int> size{17, 14, 11};
    const TriangleMesh mesh = turned(torus(0.6, 60, 40));
    for (const Vec3<double>& position : {Vec3<double>{8.0, 7.0, 5.0}, {0.0, 0.0, 0.0}, {17.0, 3.0, 12.0}}) {
        const auto inside = voxelise(mesh, size, 6.0, position, true);
        const auto outside = voxelise(mesh, size, 6.0, position, false);
        CHECK(inside.count() + outside.count() == cells(size));
        CHECK(inside.count() > 0);
        for (int z = 0; z < size.z; ++z)
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < size.x; ++x)
                    REQUIRE(inside.at({x, y, z}) != outside.at({x, y, z}));
    }
    CHECK(voxelise(mesh, size, 6.0, {100.0, 7.0, 5.0}, true).count() == 0);
    CHECK(voxelise(mesh, size, 6.0, {-100.0, 7.0, 5.0}, true).count() == 0);
    CHECK(voxelise(mesh, size, 6.0, {8.0, 7.0, 1e30}, true).count() == 0);
    CHECK(voxelise(cube(), size, 1e6, {8.0, 7.0, 5.0}, true).count() == cells(size));
}

TEST_CASE("The order of triangles, the sense of their corners and the names of vertices do not matter") {
    const Vec3<int> size{40, 40, 40};
    TriangleMesh mesh = turned(torus(0.5, 40, 20));
    const auto expected = voxelise(mesh, size, 12.5, {20.0, 20.0, 20.0}, true);
    for (auto& t : mesh.triangles)
        std::swap(t[0], t[2]);
    std::reverse(mesh.triangles.begin(), mesh.triangles.end());
    CHECK(voxelise(mesh, size, 12.5, {20.0, 20.0, 20.0}, true) == expected);
}

TEST_CASE("Pieces apart are all solid, and one within another is a hollow") {
    const Vec3<int> size{40, 20, 20};
    const TriangleMesh two = joined(cube(), cube(), 1.0, {4.0, 0.0, 0.0});
    CHECK(voxelise(two, size, 4.0, {10.0, 10.0, 10.0}, true).count() == 2 * 512);
    const TriangleMesh shell = joined(cube(), cube(), 0.5, {0.0, 0.0, 0.0});
    CHECK(voxelise(shell, size, 8.0, {20.0, 10.0, 10.0}, true).count() == 4096 - 512);
}

TEST_CASE("Open, inconsistent and overlapping surfaces are refused") {
    const Vec3<int> size{8, 8, 8};
    const auto complaint = [&](const TriangleMesh& mesh, double scale = 1.0) -> std::string {
        try {
            voxelise(mesh, size, scale, {4.0, 4.0, 4.0}, true);
        } catch (const InputError& error) {
            return error.what();
        }
        return "accepted";
    };
    TriangleMesh open = cube();
    open.triangles.pop_back();
    CHECK(complaint(open) ==
          "cube.stl: the edge from (1, -1, -1) to (1, -1, 1) belongs to triangle 4 alone; expected a closed "
          "surface, with two triangles at every edge; fill the holes and merge close vertices in a mesh "
          "editor");
    TriangleMesh inconsistent = cube();
    std::swap(inconsistent.triangles[3][0], inconsistent.triangles[3][1]);
    CHECK(complaint(inconsistent) ==
          "cube.stl: triangles 3 and 8 at the edge from (-1, -1, 1) to (-1, 1, 1) disagree on which side is "
          "outside; expected one orientation; re-orient all faces coherently in a mesh editor");
    CHECK(complaint(joined(cube(), open, 1.0, {4.0, 0.0, 0.0})) ==
          "cube.stl: piece 2 of 2, which begins with triangle 12: the edge from (5, -1, -1) to (5, -1, 1) "
          "belongs to triangle 4 alone; expected a closed surface, with two triangles at every edge; fill "
          "the holes and merge close vertices in a mesh editor");
    CHECK(complaint(joined(cube(), cube(), 1.0, {0.5, 0.25, 0.125})) ==
          "cube.stl: the pieces with the triangles 2 and 17 meet near (-1, -1, 1); expected pieces apart "
          "from each other; unite them in a mesh editor or give each a file");
    TriangleMesh beyond = joined(cube(), cube(), 1.0, {4.0, 0.0, 0.0});
    beyond.triangles[2][1] = 99;
    CHECK(complaint(beyond) == "cube.stl: triangle 2 has the vertex 99; expected 0 to 15");
    CHECK(complaint(TriangleMesh{{}, {}, "nothing.stl"}) ==
          "nothing.stl: the mesh has 0 triangles; expected a closed surface, which has at least 4");
    TriangleMesh far = cube();
    for (Vec3<double>& v : far.vertices)
        v = 1e30 * v;
    CHECK(complaint(far, 1e300) ==
          "cube.stl: a vertex is at (-inf, -inf, -inf) cells after scaling by 1e+300; expected finite "
          "numbers; try a smaller scale");
}
