#pragma once

#include "colour/phase.hpp"
#include "core/vec3.hpp"
#include "lattice/velocity_set.hpp"

namespace vesica {

/// What a cell contributes to the separation of colours: w = beta (rho_R rho_B/rho) n, n the outward unit
/// normal, so that after collision (d'Ortona et al. 1995, with the sign that keeps red inside)
///   R_i** = (rho_R/rho) f_i* - t_i c_i.w      B_i** = (rho_B/rho) f_i* + t_i c_i.w.
template <class V>
[[gnu::always_inline]] constexpr Vec3<V> segregation_flux(const V& chi, const V& density, const Vec3<V>& n,
                                                          double beta) {
    const V strength = V(0.25 * beta) * density * layer_density(chi);
    return {strength * n.x, strength * n.y, strength * n.z};
}

/// Outward from the first of two vesicles whose own outward normals are `n` and `other`: antisymmetric, -n of
/// the other where they lie face to face. Between nearly parallel normals, of which one colour is a vanishing
/// tail, it fades.
template <class V>
[[gnu::always_inline]] constexpr Vec3<V> direction_between(const Vec3<V>& n, const Vec3<V>& other) {
    const Vec3<V> apart = n - other;
    const V inverse = V(1) / square_root(dot(apart, apart) + V(1e-6));
    return {inverse * apart.x, inverse * apart.y, inverse * apart.z};
}

/// Colour that arrived in a cell.
template <class V>
struct ColourDensities {
    V red{};
    V blue{};
};

/// sum_i t_i c_i.w(x - c_i): what the neighbours' separation brings of blue, and takes of red. `w` gives the
/// components' values at x + c_i for Direction<i>.
template <class V, class Around>
[[gnu::always_inline]] constexpr V separation_of(const Vec3<Around>& w) {
    V axial = V(-0.0);
    V diagonal = V(-0.0);
    const auto add = [&](auto i, auto along, const Around& component) VESICA_INLINE_LAMBDA {
        constexpr int head = decltype(i)::value;
        constexpr int c = velocity(head, decltype(along)::value);
        V& sum = detail::squared_speed(head) == 1 ? axial : diagonal;
        if constexpr (c == 1)
            sum += component(Direction<opposite(head)>{});
        if constexpr (c == -1)
            sum -= component(Direction<opposite(head)>{});
    };
    for_each_direction([&](auto i) VESICA_INLINE_LAMBDA {
        add(i, std::integral_constant<int, 0>{}, w.x);
        add(i, std::integral_constant<int, 1>{}, w.y);
        add(i, std::integral_constant<int, 2>{}, w.z);
    });
    return fma(V(1.0 / 18.0), axial, V(1.0 / 36.0) * diagonal);
}

/// The colours' densities after streaming. R_i** is a function of f_i*, rho_R and n of the cell it comes
/// from, and f_i* has just arrived here as f_i: so no populations per colour are ever stored,
///   rho_R(x, t + 1) = sum_i [ (rho_R/rho)(x - c_i, t) f_i(x, t + 1) - t_i c_i.w(x - c_i, t) ].
/// Only the colour that is in the minority here is summed: the other is the rest. `g` are the arrived
/// deviations f_i - t_i rho0, `density` their sum with rho0; `fraction` gives that colour's mass fraction,
/// and `w` the components of the flux, at x + c_i for Direction<i>.
template <class V, class Mask, class FractionAround, class FluxAround>
[[gnu::always_inline]] constexpr ColourDensities<V>
gather_colours(const V (&g)[direction_count], const V& reference_density, const V& density,
               const Mask& blue_is_minor, const FractionAround& fraction, const Vec3<FluxAround>& w) {
    V carried = V(0);
    for_each_direction([&](auto i) VESICA_INLINE_LAMBDA {
        const V f = fma(V(weight(i)), reference_density, g[i]);
        carried = fma(fraction(Direction<opposite(decltype(i)::value)>{}), f, carried);
    });
    const V separation = separation_of<V>(w);
    const V minority = carried + select(blue_is_minor, separation, -separation);
    const V majority = density - minority;
    return {select(blue_is_minor, majority, minority), select(blue_is_minor, minority, majority)};
}

} // namespace vesica
