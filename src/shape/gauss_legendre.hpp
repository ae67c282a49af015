#pragma once

#include <array>

namespace vesica {

struct QuadraturePoint {
    double position = 0.0; ///< in [0, 1]
    double weight = 0.0;   ///< the weights sum to one
};

/// The eight-point Gauss-Legendre rule on [0, 1] (Abramowitz & Stegun, Table 25.4): exact up to degree 15.
constexpr std::array<QuadraturePoint, 8> gauss_legendre_8() {
    constexpr double x[4] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363};
    constexpr double w[4] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763};
    std::array<QuadraturePoint, 8> points{};
    for (std::size_t i = 0; i < 4; ++i) {
        points[3 - i] = {0.5 * (1.0 - x[i]), 0.5 * w[i]};
        points[4 + i] = {0.5 * (1.0 + x[i]), 0.5 * w[i]};
    }
    return points;
}

} // namespace vesica
