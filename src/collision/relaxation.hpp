#pragma once

#include "core/real.hpp"

namespace vesica {

/// nu = (1/3)(1/lambda - 1/2).
constexpr double relaxation_rate(double kinematic_viscosity) {
    return 1.0 / (3.0 * kinematic_viscosity + 0.5);
}

constexpr double kinematic_viscosity(double rate) {
    return (1.0 / rate - 0.5) / 3.0;
}

/// The odd rate of a two-rate scheme: (1/lambda_even - 1/2)(1/lambda_odd - 1/2) = magic.
/// 3/16 puts half-way walls exactly half-way, 1/4 is the most stable (Ginzburg et al. 2008).
template <class V>
constexpr V paired_rate(const V& rate, double magic) {
    const V even = V(1) / rate - V(0.5);
    return even / fma(V(0.5), even, V(magic));
}

} // namespace vesica
