#pragma once

#include "collision/parity.hpp"
#include "core/real.hpp"
#include "core/symmetric_matrix.hpp"
#include "core/vec3.hpp"

namespace vesica {

/// The ten moments hydrodynamics knows, of the stored deviations g_i = f_i - t_i rho0:
/// the density's deviation from rho0, the momentum without the force's half, and S = Pi - rho/3, which is
/// zero for a fluid at rest.
template <class V>
struct Moments {
    V density_deviation{};
    Vec3<V> momentum{};
    SymmetricMatrix<V> stress{};
};

template <class V>
[[gnu::always_inline]] constexpr Moments<V> moments_of(const EvenParts<V>& even, const OddParts<V>& odd) {
    Moments<V> m;
    const V planes = even.plane[0] + even.plane[1] + even.plane[2];
    m.density_deviation = even.rest + (even.axis[0] + even.axis[1] + even.axis[2]) + planes;
    const V beside = fma(V(-sound_speed_squared), m.density_deviation, planes);
    m.momentum = {odd.axis[0] + (odd.first[2] + odd.second[1]), odd.axis[1] + (odd.first[0] + odd.second[2]),
                  odd.axis[2] + (odd.first[1] + odd.second[0])};
    m.stress = {even.axis[0] + (beside - even.plane[0]),
                even.axis[1] + (beside - even.plane[1]),
                even.axis[2] + (beside - even.plane[2]),
                even.shear[2],
                even.shear[1],
                even.shear[0]};
    return m;
}

template <class V>
[[gnu::always_inline]] constexpr Moments<V> moments_of(const V (&g)[direction_count]) {
    return moments_of(even_parts(g), odd_parts(g));
}

/// 3 t_i, chosen such that sum_i (3 t_i) c_ia c_ia is one in T's own arithmetic: each rounded for itself,
/// they would let momentum grow by 3e-8 a step in single precision.
template <class T>
constexpr T momentum_weight(int i) { // i != 0
    constexpr T diagonal = T(1) / T(12);
    return detail::squared_speed(i) == 1 ? (T(1) - T(8) * diagonal) / T(2) : diagonal;
}

static_assert(2 * momentum_weight<double>(1) + 8 * momentum_weight<double>(18) == 1.0);
static_assert(2 * momentum_weight<float>(1) + 8 * momentum_weight<float>(18) == 1.0f);

/// What `join` makes populations of that have exactly these moments and no ghost part:
/// g_i = t_i [ drho + 3 j.c + (9/2) S : (c c - 1/3) ].
template <class V>
[[gnu::always_inline]] constexpr EvenParts<V> even_parts_with(const Moments<V>& m) {
    const V twelfth_of_trace = V(1.0 / 12.0) * m.stress.trace();
    const V axis = fma(V(1.0 / 18.0), m.density_deviation, -twelfth_of_trace);
    const V plane = fma(V(1.0 / 36.0), m.density_deviation, twelfth_of_trace);
    const auto& S = m.stress;
    return {fma(V(1.0 / 3.0), m.density_deviation, V(-6) * twelfth_of_trace),
            {fma(V(0.25), S.xx, axis), fma(V(0.25), S.yy, axis), fma(V(0.25), S.zz, axis)},
            {fma(V(-0.125), S.xx, plane), fma(V(-0.125), S.yy, plane), fma(V(-0.125), S.zz, plane)},
            {V(0.25) * S.yz, V(0.25) * S.xz, V(0.25) * S.xy}};
}

template <class V>
[[gnu::always_inline]] constexpr OddParts<V> odd_parts_with(const Moments<V>& m) {
    using T = scalar_of_t<V>;
    const V along = V(momentum_weight<T>(along_axis(0)));
    const V diagonal = V(momentum_weight<T>(rising_diagonal(0)));
    const auto& j = m.momentum;
    const Vec3<V> shared{diagonal * j.x, diagonal * j.y, diagonal * j.z};
    return {{along * j.x, along * j.y, along * j.z},
            {shared.y, shared.z, shared.x},
            {shared.z, shared.x, shared.y}};
}

template <class V>
[[gnu::always_inline]] constexpr void populations_of(const Moments<V>& m, V (&g)[direction_count]) {
    join(even_parts_with(m), odd_parts_with(m), g);
}

} // namespace vesica
