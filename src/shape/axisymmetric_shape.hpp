#pragma once

#include "shape/meridian.hpp"
#include "shape/shape.hpp"

namespace vesica {

/// Signed distance to a surface and the outward unit normal at its closest point.
struct Foot {
    double distance = 0.0;
    Vec3<double> normal{};
};

/// A surface of revolution in its own frame: axis z, centre of volume at the origin. The closest point is
/// that of the meridian, exact to round-off everywhere.
class AxisymmetricShape : public Shape {
public:
    explicit AxisymmetricShape(Meridian meridian);

    /// The meridian's closest point; a shape with a closed form may do better.
    virtual MeridianFoot closest(double r, double z) const { return meridian_.closest(r, z); }

    Foot foot(const Vec3<double>& position) const;
    const Meridian& meridian() const { return meridian_; }

    double signed_distance(const Vec3<double>& position) const override;
    double bounding_radius() const override { return meridian_.bounding_radius(); }
    double volume() const override { return meridian_.volume(); }
    double area() const override { return meridian_.area(); }
    double smallest_radius_of_curvature() const override { return 1.0 / meridian_.largest_curvature(); }

private:
    Meridian meridian_;
};

} // namespace vesica
