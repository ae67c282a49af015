#pragma once

#include "shape/shape.hpp"
#include "shape/triangle_tree.hpp"

namespace vesica {

/// The mesh moved to its centre of volume, and scaled to volume (4 pi/3) radius^3 unless radius is 0.
TriangleMesh normalised(TriangleMesh mesh, double radius);

/// The region inside a closed mesh. The distance is that to the closest point of the triangles; its sign
/// comes from the pseudo-normal of the face, edge or vertex it lies on (Baerentzen & Aanaes 2005). It has the
/// creases of the mesh: choose triangles of the size of a cell or less.
class MeshSurface final : public Shape {
public:
    /// `mesh` must have passed `closed_mesh`; it is `normalised` to the radius.
    MeshSurface(TriangleMesh mesh, double radius);
    MeshSurface(MeshSurface&&) = delete;

    double signed_distance(const Vec3<double>& position) const override;
    double bounding_radius() const override { return bounding_radius_; }
    double volume() const override { return volume_; }
    double area() const override { return area_; }

    /// An estimate: the largest principal curvature over the vertices, |H| + sqrt(H^2 - K) with H from the
    /// cotangent formula and K from the angle deficit over the vertex's share of the area (Meyer et al.
    /// 2003).
    double smallest_radius_of_curvature() const override { return smallest_radius_; }

private:
    void gather_normals();
    void estimate_curvature();

    TriangleMesh mesh_;
    TriangleTree tree_;
    std::vector<Vec3<double>> face_normals_;
    std::vector<std::array<Vec3<double>, 3>> edge_normals_; ///< per triangle, of its edges 01, 12, 20
    std::vector<Vec3<double>> vertex_normals_;
    double bounding_radius_ = 0.0;
    double volume_ = 0.0;
    double area_ = 0.0;
    double smallest_radius_ = 0.0;
};

} // namespace vesica
