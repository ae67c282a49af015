#pragma once

#include "core/vec3.hpp"

#include <cmath>

namespace vesica {

/// Unwraps positions; along an axis of size 0, which is not periodic, they stay. Each coordinate is moved by
/// whole boxes to lie within half a box of a reference point.
class Unwrap {
public:
    Unwrap(const Vec3<int>& size, const Vec3<double>& reference) : size_(size), reference_(reference) {}

    /// Whole boxes to add to cell x of an axis, in cells.
    int shift(int axis, int cell) const {
        if (size_[axis] == 0)
            return 0;
        const double away = (cell + 0.5 - reference_[axis]) / size_[axis];
        return -static_cast<int>(std::lround(away)) * size_[axis];
    }

private:
    Vec3<int> size_;
    Vec3<double> reference_;
};

} // namespace vesica
