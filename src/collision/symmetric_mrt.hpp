#pragma once

#include "collision/ghost_modes.hpp"
#include "collision/regularised.hpp"
#include "collision/relaxation.hpp"

namespace vesica {

/// How the ghost rates follow from the stress' rate.
struct FreeGhostRates {
    double odd_vector = 1.0;
    double odd_twist = 1.0;
    double even_scalar = 1.0;
    double even_tensor = 1.0;

    /// The part of a family of ghost modes that survives a collision: 1 - its rate.
    template <GhostFamily family, class V>
    [[gnu::always_inline]] constexpr V kept(const V&) const {
        if constexpr (family == GhostFamily::odd_vector)
            return V(1.0 - odd_vector);
        if constexpr (family == GhostFamily::odd_twist)
            return V(1.0 - odd_twist);
        if constexpr (family == GhostFamily::even_scalar)
            return V(1.0 - even_scalar);
        if constexpr (family == GhostFamily::even_tensor)
            return V(1.0 - even_tensor);
    }
};

/// Even ghosts relax like the stress, odd ones by the magic number.
struct TwoRelaxationTimes {
    double magic = 3.0 / 16.0;

    template <GhostFamily family, class V>
    [[gnu::always_inline]] constexpr V kept(const V& rate) const {
        if constexpr (family == GhostFamily::odd_vector || family == GhostFamily::odd_twist)
            return V(1) - paired_rate(rate, magic);
        else
            return V(1) - rate;
    }
};

/// Every mode relaxes like the stress: BGK.
struct SingleRelaxationTime {
    template <GhostFamily, class V>
    [[gnu::always_inline]] constexpr V kept(const V& rate) const {
        return V(1) - rate;
    }
};

/// MRT in the t-orthogonal basis: the regularised collision plus what each ghost mode keeps,
/// f_i* += t_i sum_h (1 - lambda_h) h_i (sum_j h_j f_j)/(sum_j t_j h_j^2).
template <class Ghosts>
struct SymmetricMrt {
    Ghosts ghosts;

    template <class V>
    [[gnu::always_inline]] constexpr void operator()(V (&g)[direction_count], const Vec3<V>& F, const V& rate,
                                                     const V& reference_density) const {
        V kept[ghost_mode_count];
        project(g, rate, kept, std::make_integer_sequence<int, ghost_mode_count>{});
        const HydrodynamicStep<V> step = relax_hydrodynamics(moments_of(g), F, rate, reference_density);
        populations_of(step.after, g);
        for_each_direction([&](auto i) VESICA_INLINE_LAMBDA {
            V sum = V(0);
            add_modes<decltype(i)::value>(sum, kept, std::make_integer_sequence<int, ghost_mode_count>{});
            g[i] = fma(V(weight(i)), sum, g[i]);
        });
    }

private:
    template <class V, int... mode>
    [[gnu::always_inline]] constexpr void project(const V (&g)[direction_count], const V& rate,
                                                  V (&kept)[ghost_mode_count],
                                                  std::integer_sequence<int, mode...>) const {
        ((kept[mode] = V(1.0 / ghost_norm(mode)) * ghosts.template kept<ghost_family(mode)>(rate) *
                       ghost_moment<mode>(g)),
         ...);
    }

    template <int mode, class V>
    [[gnu::always_inline]] static constexpr V ghost_moment(const V (&g)[direction_count]) {
        V sum = V(0);
        for_each_direction([&](auto i) VESICA_INLINE_LAMBDA {
            constexpr double h = ghost_mode(mode, decltype(i)::value);
            if constexpr (h == 1.0)
                sum += g[i];
            else if constexpr (h == -1.0)
                sum -= g[i];
            else if constexpr (h != 0.0)
                sum = fma(V(h), g[i], sum);
        });
        return sum;
    }

    template <int i, class V, int... mode>
    [[gnu::always_inline]] static constexpr void add_modes(V& sum, const V (&kept)[ghost_mode_count],
                                                           std::integer_sequence<int, mode...>) {
        (add_mode<ghost_mode(mode, i) == 0.0>(sum, V(ghost_mode(mode, i)), kept[mode]), ...);
    }

    template <bool absent, class V>
    [[gnu::always_inline]] static constexpr void add_mode(V& sum, const V& h, const V& kept) {
        if constexpr (!absent)
            sum = fma(h, kept, sum);
    }
};

} // namespace vesica
