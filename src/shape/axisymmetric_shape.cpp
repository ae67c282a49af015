#include "shape/axisymmetric_shape.hpp"

#include <cmath>
#include <utility>

namespace vesica {

AxisymmetricShape::AxisymmetricShape(Meridian meridian) : meridian_(std::move(meridian)) {}

Foot AxisymmetricShape::foot(const Vec3<double>& position) const {
    const double r = std::hypot(position.x, position.y);
    const MeridianFoot f = closest(r, position.z);
    // On the axis every azimuth is as good as the other.
    const double cosine = r > 0.0 ? position.x / r : 1.0;
    const double sine = r > 0.0 ? position.y / r : 0.0;
    return {f.distance, {f.normal_r * cosine, f.normal_r * sine, f.normal_z}};
}

double AxisymmetricShape::signed_distance(const Vec3<double>& position) const {
    return closest(std::hypot(position.x, position.y), position.z).distance;
}

} // namespace vesica
