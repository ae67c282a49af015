#pragma once

#include "colour/phase.hpp"
#include "core/vec3.hpp"
#include "lattice/velocity_set.hpp"

namespace vesica {

/// What a cell contributes to the separation of colours: w = beta (rho_R rho_B/rho) n, n the outward unit
/// normal, so that after collision (d'Ortona et al. 1995, with the sign that keeps red inside)
///   R_i** = (rho_R/rho) f_i* - t_i c_i.w      B_i** = (rho_B/rho) f_i* + t_i c_i.w.
template <class V>
[[gnu::always_inline]] inline Vec3<V> segregation_flux(const V& chi, const V& density, const Vec3<V>& n,
                                                       double beta) {
    const V strength = V(0.25 * beta) * density * layer_density(chi);
    return {strength * n.x, strength * n.y, strength * n.z};
}

/// Colour that arrived in a cell.
template <class V>
struct ColourDensities {
    V red{};
    V blue{};
};

/// The colours' densities after streaming. R_i** is a function of f_i*, rho_R and n of the cell it comes
/// from, and f_i* has just arrived here as f_i: so no populations per colour are ever stored,
///   rho_R(x, t + 1) = sum_i [ (rho_R/rho)(x - c_i, t) f_i(x, t + 1) - t_i c_i.w(x - c_i, t) ].
/// `g` are the arrived deviations f_i - t_i rho0; `chi`, `w` give the neighbours' values at x + c_i for
/// Direction<i>.
template <class V, class ChiAround, class FluxAround>
[[gnu::always_inline]] inline ColourDensities<V> gather_colours(const V (&g)[direction_count],
                                                                const V& reference_density,
                                                                const ChiAround& chi, const FluxAround& w) {
    // Only the colour that is in the minority here is summed: the other is the rest. With its sign flipped to
    // this cell's, a neighbour's chi >= 0 is that colour's fraction there, and 1 + chi where it is in the
    // majority.
    const auto blue_is_minor = sign_bit(chi(Direction<0>{}));
    const V flip = select(blue_is_minor, V(-1), V(1));
    V fraction_sum = V(0);
    V separation = V(0);
    V density = reference_density;
    for_each_direction([&](auto i) VESICA_INLINE_LAMBDA {
        constexpr int from = opposite(decltype(i)::value);
        const V signed_fraction = flip * chi(Direction<from>{});
        const V fraction = signed_fraction + one_where_sign_bit(signed_fraction);
        const V f = fma(V(weight(i)), reference_density, g[i]);
        fraction_sum = fma(fraction, f, fraction_sum);
        density += g[i];
        if constexpr (decltype(i)::value != 0)
            separation = fma(V(weight(i)), w(Direction<from>{}), separation);
    });
    const V minority = fma(-flip, separation, fraction_sum);
    const V majority = density - minority;
    const ColourDensities<V> arrived{select(blue_is_minor, majority, minority),
                                     select(blue_is_minor, minority, majority)};
    return arrived;
}

} // namespace vesica
