#include "shape/mesh_pieces.hpp"

#include "core/input_error.hpp"
#include "shape/closed_mesh.hpp"
#include "shape/triangle_intersection.hpp"
#include "shape/triangle_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace vesica {
namespace {

std::size_t index(int i) {
    return static_cast<std::size_t>(i);
}

Triangle corners(const TriangleMesh& mesh, int triangle) {
    const auto& t = mesh.triangles[index(triangle)];
    return {mesh.vertices[index(t[0])], mesh.vertices[index(t[1])], mesh.vertices[index(t[2])]};
}

/// For each triangle the first one that edges connect it to.
std::vector<int> first_of_piece(const TriangleMesh& mesh) {
    struct Edge {
        int low;
        int high;
        int triangle;
    };
    std::vector<Edge> edges;
    edges.reserve(3 * mesh.triangles.size());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            const int a = mesh.triangles[i][k], b = mesh.triangles[i][(k + 1) % 3];
            edges.push_back({std::min(a, b), std::max(a, b), static_cast<int>(i)});
        }
    std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
        return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
    });
    std::vector<int> first(mesh.triangles.size());
    std::iota(first.begin(), first.end(), 0);
    const auto find = [&](int i) {
        while (first[index(i)] != i)
            i = first[index(i)] = first[index(first[index(i)])];
        return i;
    };
    for (std::size_t i = 0; i + 1 < edges.size(); ++i)
        if (edges[i].low == edges[i + 1].low && edges[i].high == edges[i + 1].high) {
            const auto [low, high] = std::minmax({find(edges[i].triangle), find(edges[i + 1].triangle)});
            first[index(high)] = low;
        }
    for (std::size_t i = 0; i < first.size(); ++i)
        first[i] = find(static_cast<int>(i));
    return first;
}

bool indices_are_good(const TriangleMesh& mesh) {
    return std::all_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const std::array<int, 3>& t) {
        return std::all_of(t.begin(), t.end(),
                           [&](int i) { return i >= 0 && index(i) < mesh.vertices.size(); });
    });
}

TriangleMesh piece_of(const TriangleMesh& mesh, const std::vector<int>& triangles) {
    TriangleMesh piece;
    std::map<int, int> known;
    for (const int triangle : triangles) {
        auto corners = mesh.triangles[index(triangle)];
        for (int& corner : corners) {
            const auto [place, added] = known.try_emplace(corner, static_cast<int>(piece.vertices.size()));
            if (added)
                piece.vertices.push_back(mesh.vertices[index(corner)]);
            corner = place->second;
        }
        piece.triangles.push_back(corners);
    }
    return piece;
}

/// Where two pieces overlap, neither inside nor outside would be a good answer.
void check_apart(const TriangleMesh& mesh, const std::vector<int>& first) {
    const TriangleTree tree(mesh);
    for (int i = 0; i < static_cast<int>(first.size()); ++i) {
        std::vector<int> near = tree.overlapping(tree.box_of(i));
        std::sort(near.begin(), near.end());
        for (const int j : near)
            if (j > i && first[index(i)] != first[index(j)] &&
                triangles_meet(corners(mesh, i), corners(mesh, j))) {
                const Vec3<double> p = corners(mesh, i)[0];
                throw InputError(
                    SourcePlace{mesh.source, 0, 0},
                    fmt::format("the pieces with the triangles {} and {} meet near ({:.6g}, {:.6g}, {:.6g}); "
                                "expected pieces apart from each other; unite them in a mesh editor or give "
                                "each a file",
                                i, j, p.x, p.y, p.z));
            }
    }
}

} // namespace

void check_closed_pieces(const TriangleMesh& mesh) {
    const std::vector<int> first = first_of_piece(mesh);
    std::map<int, std::vector<int>> pieces;
    for (std::size_t i = 0; i < first.size(); ++i)
        pieces[first[i]].push_back(static_cast<int>(i));
    if (pieces.size() < 2 || !indices_are_good(mesh)) { // it tells of a bad index best
        closed_mesh(mesh);
        return;
    }
    std::size_t number = 0;
    for (const auto& [triangle, triangles] : pieces) {
        TriangleMesh piece = piece_of(mesh, triangles);
        piece.source = fmt::format("{}: piece {} of {}, which begins with triangle {}", mesh.source, ++number,
                                   pieces.size(), triangle);
        closed_mesh(std::move(piece));
    }
    check_apart(mesh, first);
}

} // namespace vesica
