#pragma once

#include "core/vec3.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vesica {

/// Where a point of a mesh lies on the lattice: at fraction t of the way from node a to node b of the block
/// that the mesh was extracted from.
struct EdgePoint {
    std::size_t a = 0;
    std::size_t b = 0;
    double t = 0.0;
};

/// A triangulated surface; the triangles' corners run counter-clockwise seen from outside.
struct SurfaceMesh {
    std::vector<Vec3<double>> points;
    std::vector<EdgePoint> lattice_points; ///< one per point
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// A quantity given on the nodes of the block, linearly interpolated onto the mesh's points.
std::vector<double> interpolate(const SurfaceMesh& mesh, const std::vector<double>& nodal);

/// Sum of the triangles' areas, cells^2.
double mesh_area(const SurfaceMesh& mesh);

/// Enclosed volume, cells^3, by the divergence theorem: positive when the mesh is oriented outwards.
double mesh_volume(const SurfaceMesh& mesh);

/// Points - edges + triangles: 2 (components - handles) of a closed mesh.
int euler_number(const SurfaceMesh& mesh);

/// Whether every edge has exactly one triangle on either side, oriented alike.
bool is_closed(const SurfaceMesh& mesh);

} // namespace vesica
