#pragma once

#include "core/real.hpp"
#include "core/vec3.hpp"
#include "lattice/velocity_set.hpp"

namespace vesica {

/// d_a q = 3 sum_i t_i q(x + c_i) c_ia, second order with an isotropic leading error (1/6) d_a Lap q.
/// `q(Direction<i>{})` is the value at x + c_i.
template <class V, class Around>
[[gnu::always_inline]] constexpr Vec3<V> gradient(const Around& q) {
    const V nothing = V(-0.0); // added to anything leaves it alone: unlike +0, it costs nothing
    Vec3<V> axial{nothing, nothing, nothing};
    Vec3<V> diagonal{nothing, nothing, nothing};
    for_each_pair([&](auto i) VESICA_INLINE_LAMBDA {
        constexpr int head = decltype(i)::value;
        constexpr int cx = velocity(head, 0);
        constexpr int cy = velocity(head, 1);
        constexpr int cz = velocity(head, 2);
        const V difference = q(Direction<head>{}) - q(Direction<opposite(head)>{});
        Vec3<V>& sum = cx * cx + cy * cy + cz * cz == 1 ? axial : diagonal;
        if constexpr (cx == 1)
            sum.x += difference;
        if constexpr (cx == -1)
            sum.x -= difference;
        if constexpr (cy == 1)
            sum.y += difference;
        if constexpr (cy == -1)
            sum.y -= difference;
        if constexpr (cz == 1)
            sum.z += difference;
        if constexpr (cz == -1)
            sum.z -= difference;
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

} // namespace vesica
