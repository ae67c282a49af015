#pragma once

#include "shape/shape.hpp"

#include <memory>

namespace vesica {

/// An orthonormal frame that turns with an axis.
struct Frame {
    Vec3<double> x{1.0, 0.0, 0.0};
    Vec3<double> y{0.0, 1.0, 0.0};
    Vec3<double> z{0.0, 0.0, 1.0};

    /// The axes of space after the smallest rotation that takes e_z to `axis` (half a turn about e_x for
    /// -e_z): along e_z nothing is turned. Throws InputError for an axis without direction.
    static Frame along(const Vec3<double>& axis);

    Vec3<double> components(const Vec3<double>& v) const { return {dot(x, v), dot(y, v), dot(z, v)}; }
    Vec3<double> vector(const Vec3<double>& c) const { return c.x * x + c.y * y + c.z * z; }
};

/// A shape given in its own frame, put to its place in the box.
class PlacedShape final : public Shape {
public:
    PlacedShape(std::unique_ptr<const Shape> shape, const Vec3<double>& centre, const Frame& frame);

    double signed_distance(const Vec3<double>& position) const override {
        return shape_->signed_distance(frame_.components(position - centre_));
    }
    double bounding_radius() const override { return shape_->bounding_radius(); }
    double volume() const override { return shape_->volume(); }
    double area() const override { return shape_->area(); }
    double smallest_radius_of_curvature() const override { return shape_->smallest_radius_of_curvature(); }

private:
    std::unique_ptr<const Shape> shape_;
    Vec3<double> centre_;
    Frame frame_;
};

} // namespace vesica
