#pragma once

#include "collision/moments.hpp"

namespace vesica {

/// u = (sum f_i c_i + F/2)/rho: the velocity that is second order in time under a force (Guo et al. 2002).
template <class V>
[[gnu::always_inline]] constexpr Vec3<V> velocity_of(const Moments<V>& m, const V& reference_density,
                                                     const Vec3<V>& F) {
    const V inverse_density = V(1) / (reference_density + m.density_deviation);
    return {inverse_density * fma(V(0.5), F.x, m.momentum.x),
            inverse_density * fma(V(0.5), F.y, m.momentum.y),
            inverse_density * fma(V(0.5), F.z, m.momentum.z)};
}

/// Moments of Guo's source before the factor (1 - lambda_p/2) of each mode: 0, F, F u + u F; no ghost part.
template <class V>
[[gnu::always_inline]] constexpr SymmetricMatrix<V> source_stress(const Vec3<V>& F, const Vec3<V>& u) {
    return {V(2) * F.x * u.x,      V(2) * F.y * u.y,      V(2) * F.z * u.z,
            F.x * u.y + F.y * u.x, F.x * u.z + F.z * u.x, F.y * u.z + F.z * u.y};
}

} // namespace vesica
