#pragma once

#include "core/vec3.hpp"
#include "lattice/block.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace vesica {

/// Unwraps positions: each is moved by whole boxes to lie within half a box of a reference point along every
/// axis. Along an axis of size 0, which is not periodic, it stays. Where the box slides, a box upwards is
/// also the images' displacement along.
class Unwrap {
public:
    Unwrap(const Vec3<int>& size, const Vec3<double>& reference, const std::optional<Slide>& slide = {},
           double displacement = 0.0)
        : size_(size), reference_(reference), slide_(slide), displacement_(displacement) {}

    /// Boxes upwards, across the sliding faces.
    double boxes_slid(const Vec3<int>& cell) const { return boxes(slide_->gradient, cell, 0.0); }

    /// What to add to the place of a cell, in cells.
    Vec3<double> shift(const Vec3<int>& cell) const {
        Vec3<double> shift{};
        if (slide_)
            shift[slide_->velocity] = boxes(slide_->gradient, cell, 0.0) * whole_if_nearly(displacement_);
        for (int a = 0; a < 3; ++a)
            shift[a] += boxes(a, cell, shift[a]) * size_[a];
        return shift;
    }

private:
    /// What is whole but for rounding would else be the cell below and nearly one more.
    static double whole_if_nearly(double cells) {
        return std::abs(cells - std::round(cells)) < 1e-9 * std::max(1.0, std::abs(cells)) ? std::round(cells)
                                                                                           : cells;
    }
    double boxes(int axis, const Vec3<int>& cell, double shifted) const {
        if (size_[axis] == 0)
            return 0.0;
        return -std::round((cell[axis] + 0.5 + shifted - reference_[axis]) / size_[axis]);
    }

    Vec3<int> size_;
    Vec3<double> reference_;
    std::optional<Slide> slide_;
    double displacement_;
};

} // namespace vesica
