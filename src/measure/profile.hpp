#pragma once

#include "measure/solid_body.hpp"

#include <vector>

namespace vesica {

/// A point of a shape folded onto a half plane through its axis: distance from the axis and height, cells.
struct ProfilePoint {
    double r = 0.0;
    double z = 0.0;
};

/// The direction about which a body's inertia is most nearly symmetric: that of the semi-axis which differs
/// from the other two. Its sign, like that of any axis, means nothing.
Vec3<double> symmetry_axis(const SolidBody& body);

/// Points folded about an axis through `centre`, ordered from the upper pole (z > 0) to the lower by their
/// angle as seen from the centre. For comparison with axisymmetric theory.
std::vector<ProfilePoint> meridian_profile(const std::vector<Vec3<double>>& points,
                                           const Vec3<double>& centre, const Vec3<double>& axis);

/// The same of the points of phi = 0, about the vesicle's own centre and axis.
std::vector<ProfilePoint> meridian_profile(const VesicleSnapshot& vesicle);

} // namespace vesica
