#include "measure/surface_mesh.hpp"

#include "core/exact_sum.hpp"

#include <algorithm>
#include <cassert>

namespace vesica {
namespace {

/// Directed edges, from -> to, packed into one number each and sorted.
std::vector<std::uint64_t> directed_edges(const SurfaceMesh& mesh, bool reversed) {
    std::vector<std::uint64_t> edges;
    edges.reserve(3 * mesh.triangles.size());
    for (const auto& triangle : mesh.triangles)
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint64_t from = triangle[corner];
            const std::uint64_t to = triangle[(corner + 1) % 3];
            edges.push_back(reversed ? to << 32 | from : from << 32 | to);
        }
    std::sort(edges.begin(), edges.end());
    return edges;
}

} // namespace

std::vector<double> interpolate(const SurfaceMesh& mesh, const std::vector<double>& nodal) {
    std::vector<double> values;
    values.reserve(mesh.lattice_points.size());
    for (const EdgePoint& point : mesh.lattice_points) {
        assert(point.a < nodal.size() && point.b < nodal.size());
        values.push_back((1.0 - point.t) * nodal[point.a] + point.t * nodal[point.b]);
    }
    return values;
}

double mesh_area(const SurfaceMesh& mesh) {
    ExactSum sum;
    for (const auto& [a, b, c] : mesh.triangles)
        sum.add(0.5 * norm(cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a])));
    return sum.value();
}

double mesh_volume(const SurfaceMesh& mesh) {
    if (mesh.points.empty())
        return 0.0;
    const Vec3<double> origin = mesh.points.front();
    ExactSum sum;
    for (const auto& [a, b, c] : mesh.triangles)
        sum.add(dot(mesh.points[a] - origin, cross(mesh.points[b] - origin, mesh.points[c] - origin)) / 6.0);
    return sum.value();
}

int euler_number(const SurfaceMesh& mesh) {
    std::vector<std::uint64_t> edges = directed_edges(mesh, false);
    for (std::uint64_t& edge : edges) {
        const std::uint64_t from = edge >> 32;
        const std::uint64_t to = edge & 0xffffffffu;
        edge = std::min(from, to) << 32 | std::max(from, to);
    }
    std::sort(edges.begin(), edges.end());
    const auto distinct = std::unique(edges.begin(), edges.end()) - edges.begin();
    return static_cast<int>(static_cast<std::ptrdiff_t>(mesh.points.size()) - distinct +
                            static_cast<std::ptrdiff_t>(mesh.triangles.size()));
}

bool is_closed(const SurfaceMesh& mesh) {
    const std::vector<std::uint64_t> edges = directed_edges(mesh, false);
    return std::adjacent_find(edges.begin(), edges.end()) == edges.end() &&
           edges == directed_edges(mesh, true);
}

} // namespace vesica
