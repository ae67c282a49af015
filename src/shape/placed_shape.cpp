#include "shape/placed_shape.hpp"

#include "core/input_error.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace vesica {

Frame Frame::along(const Vec3<double>& axis) {
    const double length = norm(axis);
    if (!(length > 0.0) || !std::isfinite(length))
        throw InputError(
            fmt::format("axis is [{}, {}, {}]; expected a direction; try [0, 0, 1]", axis.x, axis.y, axis.z));
    const Vec3<double> a = (1.0 / length) * axis;
    const double q = a.x * a.x + a.y * a.y;
    if (q == 0.0) {
        if (a.z > 0.0)
            return {};
        return {{1.0, 0.0, 0.0}, {0.0, -1.0, 0.0}, {0.0, 0.0, -1.0}};
    }
    // Rodrigues' rotation about e_z x a; (1 - cos)/sin^2 = 1/(1 + cos), written so that it holds near -e_z.
    const double k = a.z >= 0.0 ? 1.0 / (1.0 + a.z) : (1.0 - a.z) / q;
    return {{1.0 - k * a.x * a.x, -k * a.x * a.y, -a.x}, {-k * a.x * a.y, 1.0 - k * a.y * a.y, -a.y}, a};
}

PlacedShape::PlacedShape(std::unique_ptr<const Shape> shape, const Vec3<double>& centre, const Frame& frame)
    : shape_(std::move(shape)), centre_(centre), frame_(frame) {}

} // namespace vesica
