#pragma once

#include "core/real.hpp"

namespace vesica {

/// Two colours in one number. `chi` is the mass fraction of the colour that is in the minority, rho_R/rho or
/// rho_B/rho, with the sign bit set where blue is the minority (inside, red's side). A small fraction keeps
/// all its digits on both sides of the interface, which 2 rho_R/rho - 1 would lose: in single precision the
/// tails, and the normals taken from them, depend on it. Pure blue is +0, pure red is -0.
template <class V>
[[gnu::always_inline]] constexpr V red_fraction(const V& chi) {
    const V minority = magnitude(chi);
    return select(sign_bit(chi), V(1) - minority, minority);
}

template <class V>
[[gnu::always_inline]] constexpr V blue_fraction(const V& chi) {
    const V minority = magnitude(chi);
    return select(sign_bit(chi), minority, V(1) - minority);
}

/// phi = (rho_R - rho_B)/rho: +1 inside, -1 outside.
template <class V>
[[gnu::always_inline]] constexpr V phase_of(const V& chi) {
    const V from_one = V(1) - V(2) * magnitude(chi);
    return select(sign_bit(chi), from_one, -from_one);
}

/// 1 - phi^2 = 4 (rho_R/rho)(rho_B/rho), without cancellation.
template <class V>
[[gnu::always_inline]] constexpr V layer_density(const V& chi) {
    const V minority = magnitude(chi);
    return V(4) * minority * (V(1) - minority);
}

/// s = -artanh(phi)/beta = ln(rho_B/rho_R)/(2 beta), the signed distance of a tanh profile, positive outside.
/// Fractions below `floor` (pure cells) are read as `floor`.
template <class V>
[[gnu::always_inline]] constexpr V signed_distance_of(const V& chi, const V& floor, double beta) {
    const V minority = larger(magnitude(chi), floor);
    const V distance = V(0.5 / beta) * logarithm((V(1) - minority) / minority);
    return select(sign_bit(chi), -distance, distance);
}

/// The chi of a phase field value.
template <class V>
[[gnu::always_inline]] constexpr V chi_of_phase(const V& phi) {
    return with_sign_bit(phi > V(0), V(0.5) * (V(1) - magnitude(phi)));
}

} // namespace vesica
