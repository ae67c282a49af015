#pragma once

#include "core/real.hpp"

namespace vesica {

/// E = sigma A: minus its variation is f_n = -2 sigma H along the outward normal (Laplace: p_in - p_out = 2
/// sigma/R).
struct TensionLaw {
    double sigma = 0.0; ///< constant tension plus the area constraint's

    template <class V>
    [[gnu::always_inline]] constexpr V force(const V& H) const {
        return V(-2 * sigma) * H;
    }
};

} // namespace vesica
