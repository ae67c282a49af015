#pragma once

#include "measure/snapshot.hpp"

#include <cmath>
#include <optional>

namespace vesica {

/// Follows a vesicle's centre from sample to sample without jumps at periodic boundaries: of all the centre's
/// periodic images it picks the one nearest to the last. Right as long as the vesicle moves less than half a
/// box between samples. Images of a box that slides lie where they have slid to.
class CentreTracker {
public:
    /// `period`: box length per axis, cells; 0 along an axis that is not periodic.
    explicit CentreTracker(const Vec3<double>& period) : period_(period) {}

    /// The image of `centre` that continues the path.
    Vec3<double> follow(const Vec3<double>& centre, const std::optional<SlidingImages>& sliding = {}) {
        Vec3<double> continued = centre;
        const auto boxes_to_last = [&](int axis) {
            return std::round(((*last_)[axis] - continued[axis]) / period_[axis]);
        };
        if (last_) {
            if (sliding) {
                boxes_slid_ = boxes_to_last(sliding->gradient);
                continued[sliding->velocity] += boxes_slid_ * sliding->displacement;
            }
            for (int a = 0; a < 3; ++a)
                if (period_[a] > 0.0)
                    continued[a] += period_[a] * boxes_to_last(a);
        }
        last_ = continued;
        return continued;
    }

    /// Boxes upwards from the centre as it was given to the image that continues the path.
    double boxes_slid() const { return boxes_slid_; }

    const std::optional<Vec3<double>>& last() const { return last_; }

    /// Continues a path from an earlier run's last point.
    void restore(const std::optional<Vec3<double>>& last) { last_ = last; }

private:
    Vec3<double> period_;
    std::optional<Vec3<double>> last_;
    double boxes_slid_ = 0.0;
};

} // namespace vesica
