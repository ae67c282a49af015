#pragma once

#include "core/real.hpp"
#include "core/symmetric_matrix.hpp"
#include "core/vec3.hpp"
#include "lattice/velocity_set.hpp"

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
[[gnu::always_inline]] constexpr Moments<V> moments_of(const V (&g)[direction_count]) {
    Moments<V> m;
    m.density_deviation = g[0];
    for_each_pair([&](auto i) VESICA_INLINE_LAMBDA {
        constexpr int head = decltype(i)::value;
        constexpr int tail = opposite(head);
        constexpr int cx = velocity(head, 0);
        constexpr int cy = velocity(head, 1);
        constexpr int cz = velocity(head, 2);
        const V even = g[head] + g[tail];
        const V odd = g[head] - g[tail];
        m.density_deviation += even;
        if constexpr (cx == 1)
            m.momentum.x += odd;
        if constexpr (cx == -1)
            m.momentum.x -= odd;
        if constexpr (cy == 1)
            m.momentum.y += odd;
        if constexpr (cy == -1)
            m.momentum.y -= odd;
        if constexpr (cz == 1)
            m.momentum.z += odd;
        if constexpr (cz == -1)
            m.momentum.z -= odd;
        if constexpr (cx != 0)
            m.stress.xx += even;
        if constexpr (cy != 0)
            m.stress.yy += even;
        if constexpr (cz != 0)
            m.stress.zz += even;
        if constexpr (cx * cy == 1)
            m.stress.xy += even;
        if constexpr (cx * cy == -1)
            m.stress.xy -= even;
        if constexpr (cx * cz == 1)
            m.stress.xz += even;
        if constexpr (cx * cz == -1)
            m.stress.xz -= even;
        if constexpr (cy * cz == 1)
            m.stress.yz += even;
        if constexpr (cy * cz == -1)
            m.stress.yz -= even;
    });
    const V pressure_deviation = V(sound_speed_squared) * m.density_deviation;
    m.stress.xx -= pressure_deviation;
    m.stress.yy -= pressure_deviation;
    m.stress.zz -= pressure_deviation;
    return m;
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

/// The populations that have exactly these ten moments and no ghost part:
/// g_i = t_i [ drho + 3 j.c + (9/2) S : (c c - 1/3) ].
template <class V>
[[gnu::always_inline]] constexpr void populations_of(const Moments<V>& m, V (&g)[direction_count]) {
    const V third_of_trace = V(sound_speed_squared) * m.stress.trace();
    const V base = m.density_deviation - V(4.5) * third_of_trace;
    g[0] = V(weight(0)) * base;
    for_each_pair([&](auto i) VESICA_INLINE_LAMBDA {
        constexpr int head = decltype(i)::value;
        constexpr int tail = opposite(head);
        constexpr int cx = velocity(head, 0);
        constexpr int cy = velocity(head, 1);
        constexpr int cz = velocity(head, 2);
        V j = V(0);
        if constexpr (cx == 1)
            j += m.momentum.x;
        if constexpr (cx == -1)
            j -= m.momentum.x;
        if constexpr (cy == 1)
            j += m.momentum.y;
        if constexpr (cy == -1)
            j -= m.momentum.y;
        if constexpr (cz == 1)
            j += m.momentum.z;
        if constexpr (cz == -1)
            j -= m.momentum.z;
        V s = V(0);
        if constexpr (cx != 0)
            s += m.stress.xx;
        if constexpr (cy != 0)
            s += m.stress.yy;
        if constexpr (cz != 0)
            s += m.stress.zz;
        V shear = V(0);
        if constexpr (cx * cy == 1)
            shear += m.stress.xy;
        if constexpr (cx * cy == -1)
            shear -= m.stress.xy;
        if constexpr (cx * cz == 1)
            shear += m.stress.xz;
        if constexpr (cx * cz == -1)
            shear -= m.stress.xz;
        if constexpr (cy * cz == 1)
            shear += m.stress.yz;
        if constexpr (cy * cz == -1)
            shear -= m.stress.yz;
        const V even = V(weight(head)) * fma(V(4.5), s + shear + shear, base);
        const V odd = V(momentum_weight<scalar_of_t<V>>(head)) * j;
        g[head] = even + odd;
        g[tail] = even - odd;
    });
}

} // namespace vesica
