#pragma once

#include "case/triangle_mesh.hpp"

#include <cmath>
#include <map>
#include <utility>

namespace vesica {

/// A sphere of radius one: an icosahedron whose triangles are cut into four `levels` times.
inline TriangleMesh icosphere(int levels) {
    const double g = (1.0 + std::sqrt(5.0)) / 2.0;
    TriangleMesh mesh;
    mesh.source = "icosphere";
    mesh.vertices = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                     {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    mesh.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                      {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                      {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    for (; levels > 0; --levels) {
        std::map<std::pair<int, int>, int> middles;
        const auto middle = [&](int a, int b) {
            const auto [place, added] =
                middles.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<int>(mesh.vertices.size()));
            if (added)
                mesh.vertices.push_back(mesh.vertices[static_cast<std::size_t>(a)] +
                                        mesh.vertices[static_cast<std::size_t>(b)]);
            return place->second;
        };
        std::vector<std::array<int, 3>> finer;
        for (const auto& [a, b, c] : mesh.triangles) {
            const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            for (const std::array<int, 3>& t :
                 {std::array{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
                finer.push_back(t);
        }
        mesh.triangles = finer;
        for (Vec3<double>& v : mesh.vertices)
            v = (1.0 / norm(v)) * v;
    }
    for (Vec3<double>& v : mesh.vertices)
        v = (1.0 / norm(v)) * v;
    return mesh;
}

/// The cube [-1, 1]^3, two triangles to a face.
inline TriangleMesh cube() {
    TriangleMesh mesh;
    mesh.source = "cube.stl";
    for (int i = 0; i < 8; ++i)
        mesh.vertices.push_back({i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0});
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return mesh;
}

} // namespace vesica
