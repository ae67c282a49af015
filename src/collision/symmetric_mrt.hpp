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
        // A mode is even or odd under c -> -c: of each pair of directions it sees the sum or the difference.
        V even[direction_count]; // by the pair's first direction, and the resting one
        V odd[direction_count];
        even[0] = g[0];
        for_each_pair([&](auto i) VESICA_INLINE_LAMBDA {
            constexpr int head = decltype(i)::value;
            even[head] = g[head] + g[opposite(head)];
            odd[head] = g[head] - g[opposite(head)];
        });
        V kept[ghost_mode_count];
        project(even, odd, rate, kept, std::make_integer_sequence<int, ghost_mode_count>{});
        const HydrodynamicStep<V> step = relax_hydrodynamics(moments_of(g), F, rate, reference_density);
        populations_of(step.after, g);
        g[0] = fma(V(weight(0)), kept[even_scalar_mode], g[0]);
        for_each_pair([&](auto i) VESICA_INLINE_LAMBDA {
            constexpr int head = decltype(i)::value;
            V even_sum = V(-0.0);
            V odd_sum = V(-0.0);
            add_modes<head>(even_sum, odd_sum, kept, std::make_integer_sequence<int, ghost_mode_count>{});
            g[head] = fma(V(weight(head)), even_sum + odd_sum, g[head]);
            g[opposite(head)] = fma(V(weight(head)), even_sum - odd_sum, g[opposite(head)]);
        });
    }

private:
    static constexpr int even_scalar_mode = 6; // the only one in which the resting population takes part
    static constexpr bool is_odd(int mode) {
        return ghost_family(mode) == GhostFamily::odd_vector || ghost_family(mode) == GhostFamily::odd_twist;
    }
    static_assert(ghost_mode(even_scalar_mode, 0) == 1.0 && ghost_mode(7, 0) == 0.0 &&
                  ghost_mode(8, 0) == 0.0);

    template <class V, int... mode>
    [[gnu::always_inline]] constexpr void
    project(const V (&even)[direction_count], const V (&odd)[direction_count], const V& rate,
            V (&kept)[ghost_mode_count], std::integer_sequence<int, mode...>) const {
        ((kept[mode] = V(1.0 / ghost_norm(mode)) * ghosts.template kept<ghost_family(mode)>(rate) *
                       ghost_moment<mode>(even, odd)),
         ...);
    }

    template <int mode, class V>
    [[gnu::always_inline]] static constexpr V ghost_moment(const V (&even)[direction_count],
                                                           const V (&odd)[direction_count]) {
        V sum = V(-0.0);
        if constexpr (mode == even_scalar_mode)
            sum += even[0];
        for_each_pair([&](auto i) VESICA_INLINE_LAMBDA {
            constexpr int head = decltype(i)::value;
            add_term<mode, head>(sum, is_odd(mode) ? odd[head] : even[head]);
        });
        return sum;
    }

    template <int head, class V, int... mode>
    [[gnu::always_inline]] static constexpr void add_modes(V& even_sum, V& odd_sum,
                                                           const V (&kept)[ghost_mode_count],
                                                           std::integer_sequence<int, mode...>) {
        (add_term<mode, head>(is_odd(mode) ? odd_sum : even_sum, kept[mode]), ...);
    }

    /// sum += h a, h what the mode has in this direction.
    template <int mode, int i, class V>
    [[gnu::always_inline]] static constexpr void add_term(V& sum, const V& a) {
        constexpr double h = ghost_mode(mode, i);
        if constexpr (h == 1.0)
            sum += a;
        else if constexpr (h == -1.0)
            sum -= a;
        else if constexpr (h != 0.0)
            sum = fma(V(h), a, sum);
    }
};

} // namespace vesica
