#include "measure/equivalent_ellipsoid.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace vesica {
namespace {

double component(const SymmetricTensor& m, const Vec3<double>& a, const Vec3<double>& b) {
    return m.xx * a.x * b.x + m.yy * a.y * b.y + m.zz * a.z * b.z + m.xy * (a.x * b.y + a.y * b.x) +
           m.xz * (a.x * b.z + a.z * b.x) + m.yz * (a.y * b.z + a.z * b.y);
}

double taylor(double longest, double shortest) {
    return (longest - shortest) / (longest + shortest);
}

} // namespace

EquivalentEllipsoid equivalent_ellipsoid(const SolidBody& body) {
    const SymmetricTensor& m = body.second;
    Eigen::Matrix3d second;
    second << m.xx, m.xy, m.xz, m.xy, m.yy, m.yz, m.xz, m.yz, m.zz;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(second);
    EquivalentEllipsoid ellipsoid;
    for (int i = 0; i < 3; ++i) {
        const int ascending = 2 - i;
        const Eigen::Vector3d v = solver.eigenvectors().col(ascending);
        const auto place = static_cast<std::size_t>(i);
        ellipsoid.semi_axes[place] =
            std::sqrt(std::max(5.0 * solver.eigenvalues()[ascending] / body.volume, 0.0));
        ellipsoid.directions[place] = {v[0], v[1], v[2]};
    }
    return ellipsoid;
}

PlaneDeformation plane_deformation(const SolidBody& body, const std::optional<ShearPlane>& plane) {
    if (!plane) {
        const EquivalentEllipsoid ellipsoid = equivalent_ellipsoid(body);
        return {taylor(ellipsoid.semi_axes[0], ellipsoid.semi_axes[2]),
                std::numeric_limits<double>::quiet_NaN()};
    }
    const double along = component(body.second, plane->flow, plane->flow);
    const double across = component(body.second, plane->gradient, plane->gradient);
    const double mixed = component(body.second, plane->flow, plane->gradient);
    const double mean = 0.5 * (along + across);
    const double radius = std::hypot(0.5 * (along - across), mixed);
    double degrees = 0.5 * std::atan2(2.0 * mixed, along - across) * 180.0 / std::numbers::pi;
    if (degrees <= -90.0)
        degrees = 90.0; // atan2 may return -pi
    return {taylor(std::sqrt(mean + radius), std::sqrt(std::max(mean - radius, 0.0))), degrees};
}

} // namespace vesica
