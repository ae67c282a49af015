#include "core/input_error.hpp"
#include "shape/closed_mesh.hpp"
#include "shape/placed_shape.hpp"
#include "shape/sample_meshes.hpp"

#include <catch2/catch.hpp>

using namespace vesica;

namespace {

TriangleMesh joined(TriangleMesh a, const TriangleMesh& b, const Vec3<double>& shift) {
    const int offset = static_cast<int>(a.vertices.size());
    for (const Vec3<double>& v : b.vertices)
        a.vertices.push_back(v + shift);
    for (const auto& t : b.triangles)
        a.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
    return a;
}

} // namespace

TEST_CASE("A closed mesh passes as it is, in any direction of space") {
    CHECK(closed_mesh(icosphere(3)).triangles == icosphere(3).triangles);
    TriangleMesh turned = cube();
    const Frame frame = Frame::along({1.0, -2.0, 3.0});
    for (Vec3<double>& v : turned.vertices)
        v = frame.vector(v) + Vec3<double>{7.1, 0.3, -4.0};
    CHECK(closed_mesh(turned).triangles == cube().triangles);
}

TEST_CASE("A mesh that is inside out is turned") {
    TriangleMesh mesh = cube();
    for (auto& t : mesh.triangles)
        std::swap(t[1], t[2]);
    CHECK(closed_mesh(mesh).triangles == cube().triangles);
}

TEST_CASE("A hole is refused with its edge") {
    TriangleMesh mesh = cube();
    mesh.triangles.pop_back();
    CHECK_THROWS_WITH(
        closed_mesh(mesh),
        "cube.stl: the edge from (1, -1, -1) to (1, -1, 1) belongs to triangle 4 alone; expected a closed "
        "surface, with two triangles at every edge; fill the holes and merge close vertices in a mesh "
        "editor");
}

TEST_CASE("An inner wall is refused with its triangles") {
    TriangleMesh mesh = cube();
    mesh.triangles.push_back({0, 1, 7});
    CHECK_THROWS_WITH(closed_mesh(mesh), "cube.stl: the edge from (-1, -1, -1) to (1, -1, -1) belongs to 3 "
                                         "triangles (1, 4, 12); expected two; "
                                         "remove inner walls and doubled triangles in a mesh editor");
}

TEST_CASE("One triangle that faces the other way is refused") {
    TriangleMesh mesh = cube();
    std::swap(mesh.triangles[3][0], mesh.triangles[3][1]);
    CHECK_THROWS_WITH(
        closed_mesh(mesh),
        "cube.stl: triangles 3 and 8 at the edge from (-1, -1, 1) to (-1, 1, 1) disagree on which side is "
        "outside; expected one orientation; re-orient all faces coherently in a mesh editor");
}

TEST_CASE("Two bodies are refused") {
    CHECK_THROWS_WITH(
        closed_mesh(joined(cube(), cube(), {5.0, 0.0, 0.0})),
        "cube.stl: triangle 12 at (4, -1, -1) is not connected to triangle 0 at (-1, -1, -1); expected one "
        "piece; keep one and give the others a file and a vesicle each");
}

TEST_CASE("A triangle without area is refused") {
    TriangleMesh mesh = cube();
    mesh.vertices.push_back({0.0, 1.0, 1.0}); // on the edge between 6 and 7
    mesh.triangles.push_back({6, 7, 8});
    CHECK_THROWS_WITH(closed_mesh(mesh),
                      "cube.stl: triangle 12 at (-1, 1, 1) has no area; expected triangles with three "
                      "corners not on one line; remove degenerate triangles in a mesh editor");
}

TEST_CASE("A surface pinched in a vertex is refused") {
    // A vertex of one side of the sphere moved onto that of the other side: one piece, but two rings.
    TriangleMesh mesh = icosphere(1);
    for (auto& t : mesh.triangles)
        for (int& i : t)
            if (i == 3)
                i = 0; // vertex 3 is opposite to vertex 0
    CHECK_THROWS_WITH(closed_mesh(mesh),
                      Catch::StartsWith("icosphere: the surface touches itself in the vertex at (") &&
                          Catch::EndsWith("; expected one ring of triangles around every vertex; split "
                                          "the vertex in a mesh editor"));
}

TEST_CASE("A surface that cuts itself is refused with the triangles") {
    TriangleMesh mesh = icosphere(1);
    mesh.vertices[3] = (-1.3 / norm(mesh.vertices[3])) * mesh.vertices[3]; // pushed through the opposite side
    CHECK_THROWS_WITH(closed_mesh(mesh),
                      Catch::StartsWith("icosphere: triangles ") &&
                          Catch::EndsWith(" cut each other; expected a surface that does not meet "
                                          "itself; remove self-intersections in a mesh editor"));
}

TEST_CASE("Meshes with indices or numbers out of range are refused") {
    TriangleMesh mesh = cube();
    mesh.triangles[2][1] = 8;
    CHECK_THROWS_WITH(closed_mesh(mesh), "cube.stl: triangle 2 has the vertex 8; expected 0 to 7");
    mesh = cube();
    mesh.vertices[4].y = std::nan("");
    CHECK_THROWS_WITH(closed_mesh(mesh), "cube.stl: a vertex is not finite; expected numbers");
    mesh.triangles.resize(3);
    CHECK_THROWS_WITH(closed_mesh(mesh),
                      "cube.stl: the mesh has 3 triangles; expected a closed surface, which has at least 4");
}
