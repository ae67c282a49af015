#pragma once

#include "core/vec3.hpp"

#include <vector>

namespace vesica {

/// A sum of real spherical harmonics of a direction. Y_lm = N_lm P_l^|m|(cos theta) times cos(m azimuth) for
/// m >= 0, sin(|m| azimuth) for m < 0, without the Condon-Shortley sign, N_lm^2 = (2 - delta_m0)
/// (l - |m|)!/(l + |m|)! (Schmidt): int Y_lm^2 dOmega = 4 pi/(2l + 1). theta is the angle from z; the azimuth
/// counts from x.
class HarmonicSeries {
public:
    void add(int l, int m, double coefficient);
    bool empty() const { return highest_ < 0; }
    int highest() const { return highest_; }

    /// Root of the mean square over the sphere.
    double root_mean_square() const;

    struct Value {
        double value = 0.0;
        Vec3<double> gradient{}; ///< on the unit sphere, tangential
    };
    /// `direction` must have length one.
    Value operator()(const Vec3<double>& direction) const;

private:
    double coefficient(int l, int m) const {
        const int index = l * (l + 1) + m;
        return coefficients_[static_cast<std::size_t>(index)];
    }

    int highest_ = -1;
    std::vector<double> coefficients_;            ///< (l, m) at l (l + 1) + m
    std::vector<double> polynomial_coefficients_; ///< times N_lm
};

} // namespace vesica
