#include "shape/closed_mesh.hpp"

#include "core/input_error.hpp"
#include "shape/triangle_intersection.hpp"
#include "shape/triangle_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <string>
#include <utility>

namespace vesica {
namespace {

/// Thinner triangles have no usable normal: height over longest edge.
constexpr double thinnest = 1e-9;

[[noreturn]] void refuse(const TriangleMesh& mesh, const std::string& message) {
    throw InputError(SourcePlace{mesh.source, 0, 0}, message);
}

std::string text(const Vec3<double>& p) {
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", p.x, p.y, p.z);
}

const Vec3<double>& vertex(const TriangleMesh& mesh, int index) {
    return mesh.vertices[static_cast<std::size_t>(index)];
}

Triangle corners(const TriangleMesh& mesh, const std::array<int, 3>& t) {
    return {vertex(mesh, t[0]), vertex(mesh, t[1]), vertex(mesh, t[2])};
}

void check_triangles(const TriangleMesh& mesh) {
    if (mesh.triangles.size() < 4)
        refuse(mesh, fmt::format("the mesh has {} triangles; expected a closed surface, which has at least 4",
                                 mesh.triangles.size()));
    for (const Vec3<double>& v : mesh.vertices)
        if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z))
            refuse(mesh, "a vertex is not finite; expected numbers");
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        for (const int index : mesh.triangles[i])
            if (index < 0 || static_cast<std::size_t>(index) >= mesh.vertices.size())
                refuse(mesh, fmt::format("triangle {} has the vertex {}; expected 0 to {}", i, index,
                                         mesh.vertices.size() - 1));
        const auto [a, b, c] = corners(mesh, mesh.triangles[i]);
        const double longest = std::max({norm(b - a), norm(c - b), norm(a - c)});
        if (!(norm(cross(b - a, c - a)) > thinnest * longest * longest))
            refuse(
                mesh,
                fmt::format("triangle {} at {} has no area; expected triangles with three corners not on one "
                            "line; remove degenerate triangles in a mesh editor",
                            i, text(a)));
    }
}

/// An edge as one triangle has it, ordered by its ends so that equal edges stand together.
struct HalfEdge {
    int low;
    int high;
    int triangle;
    bool forward; ///< the triangle runs from low to high
};

std::vector<HalfEdge> sorted_half_edges(const TriangleMesh& mesh) {
    std::vector<HalfEdge> edges;
    edges.reserve(3 * mesh.triangles.size());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            const int from = mesh.triangles[i][k], to = mesh.triangles[i][(k + 1) % 3];
            edges.push_back({std::min(from, to), std::max(from, to), static_cast<int>(i), from < to});
        }
    std::sort(edges.begin(), edges.end(), [](const HalfEdge& a, const HalfEdge& b) {
        return std::pair(a.low, a.high) != std::pair(b.low, b.high)
                   ? std::pair(a.low, a.high) < std::pair(b.low, b.high)
                   : a.triangle < b.triangle;
    });
    return edges;
}

void check_edges(const TriangleMesh& mesh, const std::vector<HalfEdge>& edges) {
    for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
        const HalfEdge& e = edges[begin];
        while (end < edges.size() && edges[end].low == e.low && edges[end].high == e.high)
            ++end;
        const std::string place =
            fmt::format("the edge from {} to {}", text(vertex(mesh, e.low)), text(vertex(mesh, e.high)));
        if (end - begin == 1)
            refuse(mesh,
                   fmt::format(
                       "{} belongs to triangle {} alone; expected a closed surface, with two triangles at "
                       "every edge; fill the holes and merge close vertices in a mesh editor",
                       place, e.triangle));
        if (end - begin > 2)
            refuse(
                mesh,
                fmt::format("{} belongs to {} triangles ({}, {}, {}{}); expected two; remove inner walls and "
                            "doubled triangles in a mesh editor",
                            place, end - begin, edges[begin].triangle, edges[begin + 1].triangle,
                            edges[begin + 2].triangle, end - begin > 3 ? ", ..." : ""));
        if (e.forward == edges[begin + 1].forward)
            refuse(mesh,
                   fmt::format("triangles {} and {} at {} disagree on which side is outside; expected one "
                               "orientation; re-orient all faces coherently in a mesh editor",
                               e.triangle, edges[begin + 1].triangle, place));
    }
}

class DisjointSets {
public:
    explicit DisjointSets(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), 0);
    }
    int find(int i) {
        while (parent(i) != i)
            i = parent(i) = parent(parent(i));
        return i;
    }
    void unite(int a, int b) { parent(find(a)) = find(b); }

private:
    int& parent(int i) { return parent_[static_cast<std::size_t>(i)]; }
    std::vector<int> parent_;
};

void check_pieces(const TriangleMesh& mesh, const std::vector<HalfEdge>& edges) {
    DisjointSets pieces(mesh.triangles.size());
    for (std::size_t i = 0; i + 1 < edges.size(); i += 2)
        pieces.unite(edges[i].triangle, edges[i + 1].triangle);
    for (std::size_t i = 1; i < mesh.triangles.size(); ++i)
        if (pieces.find(static_cast<int>(i)) != pieces.find(0))
            refuse(mesh,
                   fmt::format(
                       "triangle {} at {} is not connected to triangle 0 at {}; expected one piece; keep "
                       "one and give the others a file and a vesicle each",
                       i, text(vertex(mesh, mesh.triangles[i][0])),
                       text(vertex(mesh, mesh.triangles[0][0]))));
}

/// Around a vertex of a surface the triangles form one ring. The corner k of triangle t has the number 3 t +
/// k; triangles with a common edge have the corners at both its ends in common.
void check_rings(const TriangleMesh& mesh, const std::vector<HalfEdge>& edges) {
    DisjointSets rings(3 * mesh.triangles.size());
    const auto corner = [&](int triangle, int at) {
        const auto& t = mesh.triangles[static_cast<std::size_t>(triangle)];
        return 3 * triangle + (t[0] == at ? 0 : t[1] == at ? 1 : 2);
    };
    for (std::size_t i = 0; i + 1 < edges.size(); i += 2)
        for (const int end : {edges[i].low, edges[i].high})
            rings.unite(corner(edges[i].triangle, end), corner(edges[i + 1].triangle, end));
    std::vector<int> ring(mesh.vertices.size(), -1);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            const int at = mesh.triangles[i][k];
            const int here = rings.find(static_cast<int>(3 * i + k));
            int& known = ring[static_cast<std::size_t>(at)];
            if (known < 0)
                known = here;
            if (known != here)
                refuse(mesh,
                       fmt::format(
                           "the surface touches itself in the vertex at {} (triangle {}); expected one ring "
                           "of triangles around every vertex; split the vertex in a mesh editor",
                           text(vertex(mesh, at)), i));
        }
}

double signed_volume(const TriangleMesh& mesh) {
    const Vec3<double> origin = vertex(mesh, mesh.triangles[0][0]);
    double sum = 0.0;
    for (const auto& t : mesh.triangles) {
        const auto [a, b, c] = corners(mesh, t);
        sum += dot(a - origin, cross(b - origin, c - origin)) / 6.0;
    }
    return sum;
}

bool pair_meets(const TriangleMesh& mesh, std::array<int, 3> a, std::array<int, 3> b) {
    int shared = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = shared; j < 3; ++j)
            if (i >= shared && a[static_cast<std::size_t>(i)] == b[static_cast<std::size_t>(j)]) {
                std::swap(a[static_cast<std::size_t>(i)], a[static_cast<std::size_t>(shared)]);
                std::swap(b[static_cast<std::size_t>(j)], b[static_cast<std::size_t>(shared)]);
                ++shared;
                break;
            }
    const Triangle p = corners(mesh, a), q = corners(mesh, b);
    if (shared == 0)
        return triangles_meet(p, q);
    if (shared == 1)
        return triangles_meet_beyond_corner(p, q);
    return shared == 3 || triangles_fold(p, q);
}

void check_intersections(const TriangleMesh& mesh) {
    const TriangleTree tree(mesh);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        std::vector<int> near = tree.overlapping(tree.box_of(static_cast<int>(i)));
        std::sort(near.begin(), near.end());
        for (const int j : near) {
            if (j <= static_cast<int>(i))
                continue;
            const auto& other = mesh.triangles[static_cast<std::size_t>(j)];
            if (pair_meets(mesh, mesh.triangles[i], other))
                refuse(mesh,
                       fmt::format(
                           "triangles {} at {} and {} at {} cut each other; expected a surface that does "
                           "not meet itself; remove self-intersections in a mesh editor",
                           i, text(vertex(mesh, mesh.triangles[i][0])), j, text(vertex(mesh, other[0]))));
        }
    }
}

} // namespace

TriangleMesh closed_mesh(TriangleMesh mesh) {
    check_triangles(mesh);
    const std::vector<HalfEdge> edges = sorted_half_edges(mesh);
    check_edges(mesh, edges);
    check_pieces(mesh, edges);
    check_rings(mesh, edges);
    check_intersections(mesh);
    if (signed_volume(mesh) < 0.0)
        for (auto& t : mesh.triangles)
            std::swap(t[1], t[2]);
    return mesh;
}

} // namespace vesica
