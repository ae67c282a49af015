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
/// f_i* += t_i sum_h (1 - lambda_h) h_i (sum_j h_j f_j)/(sum_j t_j h_j^2), h as in ghost_modes.hpp.
template <class Ghosts>
struct SymmetricMrt {
    Ghosts ghosts;

    template <class V>
    [[gnu::always_inline]] constexpr void operator()(V (&g)[direction_count], const Vec3<V>& F, const V& rate,
                                                     const V& reference_density) const {
        const EvenParts<V> even = even_parts(g);
        const OddParts<V> odd = odd_parts(g);
        const HydrodynamicStep<V> step =
            relax_hydrodynamics(moments_of(even, odd), F, rate, reference_density);
        EvenParts<V> even_after = even_parts_with(step.after);
        OddParts<V> odd_after = odd_parts_with(step.after);
        keep_even_ghosts(even, rate, even_after);
        keep_odd_ghosts(odd, rate, odd_after);
        join(even_after, odd_after, g);
    }

private:
    static constexpr int vector_mode = 0;
    static constexpr int twist_mode = 3;
    static constexpr int scalar_mode = 6;
    static constexpr int tensor_mode = 7;
    static constexpr double axis_weight = weight(along_axis(0));
    static constexpr double diagonal_weight = weight(rising_diagonal(0));

    /// The scalar mode sees rest - 2 axes + planes. The tensor modes see, of axis k and the plane across it
    /// together, how far they exceed the mean of all three. The third is what makes their sum zero: so the
    /// mass stays in any precision.
    template <class V>
    [[gnu::always_inline]] constexpr void keep_even_ghosts(const EvenParts<V>& before, const V& rate,
                                                           EvenParts<V>& after) const {
        const V axes = before.axis[0] + before.axis[1] + before.axis[2];
        const V planes = before.plane[0] + before.plane[1] + before.plane[2];
        const V scalar =
            V(diagonal_weight / ghost_norm(scalar_mode)) *
            (ghosts.template kept<GhostFamily::even_scalar>(rate) * fma(V(-2), axes, before.rest + planes));
        after.rest = fma(V(12), scalar, after.rest);
        const V tensor_kept = ghosts.template kept<GhostFamily::even_tensor>(rate);
        const V mean = V(1.0 / 3.0) * (axes + planes);
        V tensor[3] = {tensor_kept * (before.axis[0] + before.plane[0] - mean),
                       tensor_kept * (before.axis[1] + before.plane[1] - mean), V(0)};
        tensor[2] = -(tensor[0] + tensor[1]);
        for_each_axis([&](auto k) VESICA_INLINE_LAMBDA {
            after.axis[k] += fma(V(6 * axis_weight / ghost_norm(tensor_mode)), tensor[k], V(-4) * scalar);
            after.plane[k] += fma(V(6 * diagonal_weight / ghost_norm(tensor_mode)), tensor[k], scalar);
        });
    }

    /// Of what moves along axis k, the vector mode sees the planes less twice the axis, the twist one plane
    /// less the other.
    template <class V>
    [[gnu::always_inline]] constexpr void keep_odd_ghosts(const OddParts<V>& before, const V& rate,
                                                          OddParts<V>& after) const {
        const V vector_kept = V(2 * axis_weight / ghost_norm(vector_mode)) *
                              ghosts.template kept<GhostFamily::odd_vector>(rate);
        const V twist_kept =
            V(diagonal_weight / ghost_norm(twist_mode)) * ghosts.template kept<GhostFamily::odd_twist>(rate);
        for_each_axis([&](auto k) VESICA_INLINE_LAMBDA {
            constexpr int first_in = (k + 2) % 3;
            constexpr int second_in = (k + 1) % 3;
            const V& a = before.first[first_in];
            const V& b = before.second[second_in];
            const V vector = vector_kept * fma(V(-2), before.axis[k], a + b);
            const V twist = twist_kept * (a - b);
            after.axis[k] -= vector;
            after.first[first_in] += fma(V(0.25), vector, twist);
            after.second[second_in] += fma(V(0.25), vector, -twist);
        });
    }
};

} // namespace vesica
