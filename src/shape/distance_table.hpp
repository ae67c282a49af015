#pragma once

#include "core/vec3.hpp"
#include "shape/shape.hpp"
#include "shape/trilinear.hpp"

#include <vector>

namespace vesica {

/// A point of a shape's own frame, on its surface or within.
struct InnerPoint {
    Vec3<double> place{};
    double depth = 0.0; ///< from the surface
};

/// A shape's signed distance tabulated about its centre, for those who ask often and are content with some
/// hundredths of a cell. Positions in the shape's own frame, cells.
class DistanceTable {
public:
    /// Up to `margin` cells beyond the shape's bounding sphere.
    DistanceTable(const Shape& shape, double margin);

    /// Beyond the table as at its edge.
    DistanceValue at(const Vec3<double>& position) const;

    /// Points on the shape's surface, about `spacing` cells apart, and one well inside, from which it is told
    /// which way out is.
    std::vector<InnerPoint> points(double spacing) const;

private:
    static constexpr int cells_per_radius = 20;

    double node(const Vec3<int>& k) const {
        return values_[static_cast<std::size_t>((k.z * nodes_ + k.y) * nodes_ + k.x)];
    }

    double half_;    ///< of the table's edge
    double spacing_; ///< of its nodes
    int nodes_;      ///< along each axis
    std::vector<double> values_;
};

} // namespace vesica
