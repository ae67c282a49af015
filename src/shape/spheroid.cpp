#include "shape/spheroid.hpp"

#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

namespace vesica {
namespace {

Meridian ellipse(double width, double height) {
    return Meridian(
        [=](double t) {
            const double c = std::cos(t), s = std::sin(t);
            return MeridianPoint{width * s, height * c, width * c, -height * s, -width * s, -height * c};
        },
        std::numbers::pi);
}

/// The closest point (x, y) of the ellipse with semi-axes a >= b to (p, q) in the first quadrant.
/// Eberly 2013, "Distance from a point to an ellipse": x = a^2 p/(t + a^2), y = b^2 q/(t + b^2) with t the
/// largest root of F(t) = (a p/(t + a^2))^2 + (b q/(t + b^2))^2 - 1. F falls and is convex there, so Newton's
/// method from the left climbs to the root without leaving the interval, whatever the point.
std::pair<double, double> closest_on_ellipse(double a, double b, double p, double q) {
    if (q == 0.0) {
        const double numerator = a * p, denominator = a * a - b * b;
        if (numerator >= denominator)
            return {a, 0.0};
        const double fraction = numerator / denominator;
        return {a * fraction, b * std::sqrt(1.0 - fraction * fraction)};
    }
    // tau = t + b^2 keeps its digits where t is next to -b^2 (points near the focal segment).
    const double excess = a * a - b * b;
    double tau = b * q;
    for (int iteration = 0; iteration < 500; ++iteration) {
        const double x = a * p / (tau + excess), y = b * q / tau;
        const double f = x * x + y * y - 1.0;
        const double slope = -2.0 * (x * x / (tau + excess) + y * y / tau);
        const double next = tau - f / slope;
        if (!(next > tau))
            break;
        tau = next;
    }
    return {a * a * p / (tau + excess), b * b * q / tau};
}

} // namespace

Spheroid::Spheroid(double radius, double aspect)
    : AxisymmetricShape(ellipse(radius / std::cbrt(aspect), radius * std::cbrt(aspect * aspect))),
      width_(radius / std::cbrt(aspect)),
      height_(radius * std::cbrt(aspect * aspect)) {}

MeridianFoot Spheroid::closest(double r, double z) const {
    const double up = std::abs(z);
    double x = 0.0, y = 0.0;
    if (width_ >= height_)
        std::tie(x, y) = closest_on_ellipse(width_, height_, r, up);
    else
        std::tie(y, x) = closest_on_ellipse(height_, width_, up, r);
    const double nr = x / (width_ * width_), nz = y / (height_ * height_);
    const double length = std::hypot(nr, nz);
    const double distance = std::hypot(r - x, up - y);
    const double outward = (r - x) * nr + (up - y) * nz;
    return {std::copysign(distance, outward), nr / length, std::copysign(nz / length, z)};
}

} // namespace vesica
