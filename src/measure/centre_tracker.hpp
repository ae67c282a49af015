#pragma once

#include "core/vec3.hpp"

#include <cmath>
#include <optional>

namespace vesica {

/// Follows a vesicle's centre from sample to sample without jumps at periodic boundaries: of all the centre's
/// periodic images it picks the one nearest to the last. Right as long as the vesicle moves less than half a
/// box between samples.
class CentreTracker {
public:
    /// `period`: box length per axis, cells; 0 along an axis that is not periodic.
    explicit CentreTracker(const Vec3<double>& period) : period_(period) {}

    /// The image of `centre` that continues the path.
    Vec3<double> follow(const Vec3<double>& centre) {
        Vec3<double> continued = centre;
        if (last_)
            for (int a = 0; a < 3; ++a)
                if (period_[a] > 0.0)
                    continued[a] += period_[a] * std::round(((*last_)[a] - centre[a]) / period_[a]);
        last_ = continued;
        return continued;
    }

    const std::optional<Vec3<double>>& last() const { return last_; }

    /// Continues a path from an earlier run's last point.
    void restore(const std::optional<Vec3<double>>& last) { last_ = last; }

private:
    Vec3<double> period_;
    std::optional<Vec3<double>> last_;
};

} // namespace vesica
