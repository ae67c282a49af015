#include "shape/mesh_surface.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace vesica {
namespace {

using std::numbers::pi;

std::size_t index(int i) {
    return static_cast<std::size_t>(i);
}

std::array<Vec3<double>, 3> corners(const TriangleMesh& mesh, const std::array<int, 3>& t) {
    return {mesh.vertices[index(t[0])], mesh.vertices[index(t[1])], mesh.vertices[index(t[2])]};
}

double angle_between(const Vec3<double>& a, const Vec3<double>& b) {
    return std::atan2(norm(cross(a, b)), dot(a, b));
}

/// The part of a triangle that belongs to each corner: what is closest to it, or fixed parts where the
/// circumcentre is outside (Meyer et al. 2003, "mixed area").
std::array<double, 3> vertex_shares(const std::array<Vec3<double>, 3>& p) {
    const double area = 0.5 * norm(cross(p[1] - p[0], p[2] - p[0]));
    std::array<double, 3> cotangent{}, opposite{}, shares{};
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3<double>&a = p[(k + 1) % 3], &b = p[(k + 2) % 3];
        cotangent[k] = dot(a - p[k], b - p[k]) / (2.0 * area);
        opposite[k] = dot(a - b, a - b);
    }
    for (std::size_t k = 0; k < 3; ++k)
        if (cotangent[k] < 0.0) {
            shares.fill(area / 4.0);
            shares[k] = area / 2.0;
            return shares;
        }
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
        shares[k] = (cotangent[i] * opposite[i] + cotangent[j] * opposite[j]) / 8.0;
    }
    return shares;
}

double volume_of(const TriangleMesh& mesh) {
    double sum = 0.0;
    for (const auto& t : mesh.triangles) {
        const auto [a, b, c] = corners(mesh, t);
        sum += dot(a, cross(b, c)) / 6.0;
    }
    return sum;
}

} // namespace

TriangleMesh normalised(TriangleMesh mesh, double radius) {
    // First to a point nearby, lest the volume lose its digits far from the origin.
    const Vec3<double> origin = mesh.vertices[0];
    for (Vec3<double>& v : mesh.vertices)
        v = v - origin;
    Vec3<double> moment{};
    for (const auto& t : mesh.triangles) {
        const auto [a, b, c] = corners(mesh, t);
        moment = moment + (dot(a, cross(b, c)) / 24.0) * (a + b + c);
    }
    const double volume = volume_of(mesh);
    const Vec3<double> centre = (1.0 / volume) * moment;
    const double factor = radius > 0.0 ? radius / std::cbrt(3.0 * volume / (4.0 * pi)) : 1.0;
    for (Vec3<double>& v : mesh.vertices)
        v = factor * (v - centre);
    return mesh;
}

MeshSurface::MeshSurface(TriangleMesh mesh, double radius)
    : mesh_(normalised(std::move(mesh), radius)), tree_(mesh_), volume_(volume_of(mesh_)) {
    for (const Vec3<double>& v : mesh_.vertices)
        bounding_radius_ = std::max(bounding_radius_, norm(v));
    gather_normals();
    estimate_curvature();
}

void MeshSurface::gather_normals() {
    vertex_normals_.resize(mesh_.vertices.size());
    std::map<std::pair<int, int>, Vec3<double>> edges;
    const auto key = [](int a, int b) {
        return std::pair(std::min(a, b), std::max(a, b));
    };
    for (const auto& t : mesh_.triangles) {
        const auto p = corners(mesh_, t);
        const Vec3<double> n = cross(p[1] - p[0], p[2] - p[0]);
        const double twice_area = norm(n);
        area_ += 0.5 * twice_area;
        face_normals_.push_back((1.0 / twice_area) * n);
        for (std::size_t k = 0; k < 3; ++k) {
            const double angle = angle_between(p[(k + 1) % 3] - p[k], p[(k + 2) % 3] - p[k]);
            Vec3<double>& at_vertex = vertex_normals_[index(t[k])];
            at_vertex = at_vertex + angle * face_normals_.back();
            Vec3<double>& at_edge = edges[key(t[k], t[(k + 1) % 3])];
            at_edge = at_edge + face_normals_.back();
        }
    }
    for (const auto& t : mesh_.triangles)
        edge_normals_.push_back({edges[key(t[0], t[1])], edges[key(t[1], t[2])], edges[key(t[2], t[0])]});
}

void MeshSurface::estimate_curvature() {
    std::vector<Vec3<double>> laplacian(mesh_.vertices.size());
    std::vector<double> deficit(mesh_.vertices.size(), 2.0 * pi);
    std::vector<double> share(mesh_.vertices.size(), 0.0);
    for (const auto& t : mesh_.triangles) {
        const auto p = corners(mesh_, t);
        const double twice_area = norm(cross(p[1] - p[0], p[2] - p[0]));
        const auto shares = vertex_shares(p);
        for (std::size_t k = 0; k < 3; ++k) {
            share[index(t[k])] += shares[k];
            const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
            const double cotangent = dot(p[i] - p[k], p[j] - p[k]) / twice_area;
            const Vec3<double> pull = (0.5 * cotangent) * (p[j] - p[i]);
            laplacian[index(t[i])] = laplacian[index(t[i])] + pull;
            laplacian[index(t[j])] = laplacian[index(t[j])] - pull;
            deficit[index(t[k])] -= angle_between(p[i] - p[k], p[j] - p[k]);
        }
    }
    double largest = 0.0;
    for (std::size_t v = 0; v < share.size(); ++v) {
        if (share[v] == 0.0)
            continue;
        const double mean = 0.5 * norm(laplacian[v]) / share[v]; // the Laplacian of position is -2 H n
        const double gaussian = deficit[v] / share[v];
        largest = std::max(largest, mean + std::sqrt(std::max(0.0, mean * mean - gaussian)));
    }
    smallest_radius_ = 1.0 / largest;
}

double MeshSurface::signed_distance(const Vec3<double>& position) const {
    const double beyond = norm(position) - bounding_radius_;
    if (beyond > reach)
        return beyond;
    const ClosestPoint closest = tree_.closest(position);
    const auto triangle = index(closest.triangle);
    const Vec3<double>* normal = &face_normals_[triangle];
    if (closest.feature >= 4)
        normal = &edge_normals_[triangle][index(closest.feature - 4)];
    else if (closest.feature >= 1)
        normal = &vertex_normals_[index(mesh_.triangles[triangle][index(closest.feature - 1)])];
    return std::copysign(std::sqrt(closest.squared_distance), dot(position - closest.position, *normal));
}

} // namespace vesica
