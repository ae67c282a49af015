#include "measure/profile.hpp"

#include "measure/diameter.hpp"
#include "measure/equivalent_ellipsoid.hpp"

#include <algorithm>
#include <cmath>

namespace vesica {

Vec3<double> symmetry_axis(const SolidBody& body) {
    const EquivalentEllipsoid ellipsoid = equivalent_ellipsoid(body);
    const auto& [longest, middle, shortest] = ellipsoid.semi_axes;
    return longest - middle > middle - shortest ? ellipsoid.directions[0] : ellipsoid.directions[2];
}

std::vector<ProfilePoint> meridian_profile(const std::vector<Vec3<double>>& points,
                                           const Vec3<double>& centre, const Vec3<double>& axis) {
    std::vector<ProfilePoint> profile;
    profile.reserve(points.size());
    for (const Vec3<double>& point : points) {
        const Vec3<double> d = point - centre;
        const double z = dot(d, axis);
        profile.push_back({norm(d - z * axis), z});
    }
    std::sort(profile.begin(), profile.end(), [](const ProfilePoint& a, const ProfilePoint& b) {
        const double angle_a = std::atan2(a.r, a.z);
        const double angle_b = std::atan2(b.r, b.z);
        return angle_a != angle_b ? angle_a < angle_b : a.r < b.r;
    });
    return profile;
}

std::vector<ProfilePoint> meridian_profile(const VesicleSnapshot& vesicle) {
    const SolidBody body = solid_body(vesicle);
    return meridian_profile(surface_points(vesicle), body.centre, symmetry_axis(body));
}

} // namespace vesica
