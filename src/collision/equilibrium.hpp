#pragma once

#include "collision/moments.hpp"

namespace vesica {

/// Second-order equilibrium: Pi = rho/3 + rho u u, every ghost moment zero (Spendlove et al. 2021, Eq 3).
/// `density` is rho itself, `reference_density` the rho0 of the stored deviations.
template <class V>
[[gnu::always_inline]] constexpr Moments<V> equilibrium_moments(const V& density, const V& reference_density,
                                                                const Vec3<V>& u) {
    const Vec3<V> j{density * u.x, density * u.y, density * u.z};
    return {
        density - reference_density, j, {j.x * u.x, j.y * u.y, j.z * u.z, j.x * u.y, j.x * u.z, j.y * u.z}};
}

} // namespace vesica
