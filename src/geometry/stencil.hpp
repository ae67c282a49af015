#pragma once

#include "core/real.hpp"
#include "core/vec3.hpp"
#include "lattice/velocity_set.hpp"

namespace vesica {

namespace detail {

/// sum += c_i difference
template <int i, class V>
[[gnu::always_inline]] constexpr void add_along(Vec3<V>& sum, const V& difference) {
    if constexpr (velocity(i, 0) == 1)
        sum.x += difference;
    if constexpr (velocity(i, 0) == -1)
        sum.x -= difference;
    if constexpr (velocity(i, 1) == 1)
        sum.y += difference;
    if constexpr (velocity(i, 1) == -1)
        sum.y -= difference;
    if constexpr (velocity(i, 2) == 1)
        sum.z += difference;
    if constexpr (velocity(i, 2) == -1)
        sum.z -= difference;
}

} // namespace detail

/// d_a q = 3 sum_i t_i q(x + c_i) c_ia, second order with an isotropic leading error (1/6) d_a Lap q.
/// `q(Direction<i>{})` is the value at x + c_i.
template <class V, class Around>
[[gnu::always_inline]] constexpr Vec3<V> gradient(const Around& q) {
    const V nothing = V(-0.0); // added to anything leaves it alone: unlike +0, it costs nothing
    Vec3<V> axial{nothing, nothing, nothing};
    Vec3<V> diagonal{nothing, nothing, nothing};
    for_each_pair([&](auto i) VESICA_INLINE_LAMBDA {
        constexpr int head = decltype(i)::value;
        const V difference = q(Direction<head>{}) - q(Direction<opposite(head)>{});
        detail::add_along<head>(detail::squared_speed(head) == 1 ? axial : diagonal, difference);
    });
    constexpr double near = 3.0 / 18.0;
    constexpr double far = 3.0 / 36.0;
    return {fma(V(near), axial.x, V(far) * diagonal.x), fma(V(near), axial.y, V(far) * diagonal.y),
            fma(V(near), axial.z, V(far) * diagonal.z)};
}

/// Lap q = 6 sum_i t_i (q(x + c_i) - q(x)), second order and isotropic.
template <class V, class Around>
[[gnu::always_inline]] constexpr V laplacian(const Around& q) {
    V near = V(-0.0);
    V far = V(-0.0);
    for_each_pair([&](auto i) VESICA_INLINE_LAMBDA {
        constexpr int head = decltype(i)::value;
        const V sum = q(Direction<head>{}) + q(Direction<opposite(head)>{});
        if constexpr (detail::squared_speed(head) == 1)
            near += sum;
        else
            far += sum;
    });
    constexpr double near_weight = 6.0 / 18.0;
    constexpr double far_weight = 6.0 / 36.0;
    return fma(V(near_weight), near,
               fma(V(far_weight), far, V(-6.0 * (1.0 - 1.0 / 3.0)) * q(Direction<0>{})));
}

/// q - (order/6) Lap q: makes up in advance for the leading error of `order` applications of gradient(), each
/// of which sees q + (1/6) Lap q.
template <class V, class Around>
[[gnu::always_inline]] constexpr V sharpened(const Around& q, double order) {
    return fma(V(-order / 6.0), laplacian<V>(q), q(Direction<0>{}));
}

/// The gradients of the three components of a vector field: rows[i] = grad q_i, so rows[i][j] = d_j q_i.
template <class V>
struct Jacobian {
    Vec3<V> x;
    Vec3<V> y;
    Vec3<V> z;

    constexpr V divergence() const { return x.x + y.y + z.z; }
    /// n_i n_j d_j q_i
    constexpr V normal_component(const Vec3<V>& n) const {
        return n.x * dot(n, x) + n.y * dot(n, y) + n.z * dot(n, z);
    }
};

/// `q` gives a Vec3 of neighbourhoods, one per component.
template <class V, class Around>
[[gnu::always_inline]] constexpr Jacobian<V> jacobian(const Vec3<Around>& q) {
    return {gradient<V>(q.x), gradient<V>(q.y), gradient<V>(q.z)};
}

/// The Jacobian of a field of unit normals where two sheets of a surface may lie within one stencil; n is the
/// normal here. Beyond the plane midway between the sheets the normals point the other way, and it is -q that
/// goes on smoothly. A neighbour without a normal (q = 0) is taken to have the one here.
template <class V, class Around>
[[gnu::always_inline]] constexpr Jacobian<V> jacobian_of_normals(const Vec3<Around>& q, const Vec3<V>& n) {
    const V nothing = V(-0.0);
    Jacobian<V> d{{nothing, nothing, nothing}, {nothing, nothing, nothing}, {nothing, nothing, nothing}};
    Vec3<V> missing{nothing, nothing, nothing};
    for_each_pair([&](auto i) VESICA_INLINE_LAMBDA {
        constexpr int head = decltype(i)::value;
        constexpr int tail = opposite(head);
        const Vec3<V> ahead{q.x(Direction<head>{}), q.y(Direction<head>{}), q.z(Direction<head>{})};
        const Vec3<V> behind{q.x(Direction<tail>{}), q.y(Direction<tail>{}), q.z(Direction<tail>{})};
        // 1, -1 where it lies beyond the middle, or 0 where there is none.
        const auto side = [&](const Vec3<V>& there) VESICA_INLINE_LAMBDA {
            return smaller(larger(dot(there, n) * V(1e30), V(-1)), V(1));
        };
        const V weight = V(detail::squared_speed(head) == 1 ? 3.0 / 18.0 : 3.0 / 36.0);
        const V side_ahead = side(ahead);
        const V side_behind = side(behind);
        const V weight_ahead = weight * side_ahead;
        const V weight_behind = weight * side_behind;
        detail::add_along<head>(d.x, fma(weight_ahead, ahead.x, -(weight_behind * behind.x)));
        detail::add_along<head>(d.y, fma(weight_ahead, ahead.y, -(weight_behind * behind.y)));
        detail::add_along<head>(d.z, fma(weight_ahead, ahead.z, -(weight_behind * behind.z)));
        detail::add_along<head>(missing, fma(weight_behind, side_behind, -(weight_ahead * side_ahead)));
    });
    for (int a = 0; a < 3; ++a) {
        d.x[a] = fma(missing[a], n.x, d.x[a]);
        d.y[a] = fma(missing[a], n.y, d.y[a]);
        d.z[a] = fma(missing[a], n.z, d.z[a]);
    }
    return d;
}

} // namespace vesica
