#include "shape/evans_fung.hpp"

#include <cmath>
#include <numbers>

namespace vesica {

Meridian evans_fung_meridian() {
    // The published coefficients are micrometres at R = 3.91 um; these are divided by R.
    constexpr double c0 = 0.20716, c1 = 2.00256, c2 = -1.12276;
    // r = sin t makes the square root cos t, so that the rim is as smooth as everything else.
    return Meridian(
        [](double t) {
            const double c = std::cos(t), s = std::sin(t), q = s * s;
            const double height = 0.5 * (c0 + c1 * q + c2 * q * q);
            const double slope = 0.5 * (c1 + 2.0 * c2 * q); // by q
            const double dq = 2.0 * s * c, ddq = 2.0 * (c * c - s * s);
            const double dheight = slope * dq;
            const double ddheight = c2 * dq * dq + slope * ddq;
            return MeridianPoint{s,  c * height,
                                 c,  -s * height + c * dheight,
                                 -s, -c * height - 2.0 * s * dheight + c * ddheight};
        },
        std::numbers::pi);
}

} // namespace vesica
