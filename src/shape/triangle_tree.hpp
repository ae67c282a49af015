#pragma once

#include "case/triangle_mesh.hpp"

#include <limits>
#include <vector>

namespace vesica {

struct BoundingBox {
    Vec3<double> low{};
    Vec3<double> high{};

    void include(const Vec3<double>& p);
    double squared_distance(const Vec3<double>& p) const;
    bool overlaps(const BoundingBox& other) const;
};

/// The closest point of a set of triangles.
struct ClosestPoint {
    Vec3<double> position{};
    double squared_distance = 0.0;
    int triangle = -1;
    int feature = 0; ///< 0: inside the face; 1, 2, 3: corner 0, 1, 2; 4, 5, 6: edge 01, 12, 20
};

/// A binary tree of boxes over the triangles of a mesh, which must outlive it.
class TriangleTree {
public:
    explicit TriangleTree(const TriangleMesh& mesh);

    /// The closest point if it is nearer than the square root of `within`, a squared distance; otherwise the
    /// triangle is -1.
    ClosestPoint closest(const Vec3<double>& position,
                         double within = std::numeric_limits<double>::max()) const;

    /// Triangles whose boxes overlap `box`, in a fixed order.
    std::vector<int> overlapping(const BoundingBox& box) const;

    const BoundingBox& box_of(int triangle) const { return boxes_[static_cast<std::size_t>(triangle)]; }

private:
    struct Node {
        BoundingBox box;
        int begin = 0; ///< leaf: first of its triangles; else the left child, the right one follows
        int count = 0; ///< leaf: how many; else 0
    };

    void build(int node, int begin, int end);

    const TriangleMesh& mesh_;
    std::vector<BoundingBox> boxes_;
    std::vector<int> order_;
    std::vector<Node> nodes_;
};

} // namespace vesica
