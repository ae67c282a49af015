#pragma once

#include "collision/equilibrium.hpp"
#include "collision/forcing.hpp"

namespace vesica {

/// The hydrodynamic half of every collision here: rho, j and Pi after collision, with the consistent source
/// S_p = (1 - lambda_p/2) x Guo's moment p.
template <class V>
struct HydrodynamicStep {
    Moments<V> after;
    Vec3<V> u;
};

template <class V>
[[gnu::always_inline]] constexpr HydrodynamicStep<V>
relax_hydrodynamics(const Moments<V>& m, const Vec3<V>& F, const V& rate, const V& reference_density) {
    const Vec3<V> u = velocity_of(m, reference_density, F);
    const V density = reference_density + m.density_deviation;
    const SymmetricMatrix<V> source = source_stress(F, u);
    const Vec3<V> rho_u{density * u.x, density * u.y, density * u.z};
    const V keep = V(1) - rate;
    const V source_factor = fma(V(-0.5), rate, V(1));

    HydrodynamicStep<V> result;
    result.u = u;
    result.after.density_deviation = m.density_deviation;
    result.after.momentum = {m.momentum.x + F.x, m.momentum.y + F.y, m.momentum.z + F.z};
    const auto relax = [&](const V& stress, const V& equilibrium, const V& forced) VESICA_INLINE_LAMBDA {
        return fma(keep, stress, fma(rate, equilibrium, source_factor * forced));
    };
    result.after.stress = {
        relax(m.stress.xx, rho_u.x * u.x, source.xx), relax(m.stress.yy, rho_u.y * u.y, source.yy),
        relax(m.stress.zz, rho_u.z * u.z, source.zz), relax(m.stress.xy, rho_u.x * u.y, source.xy),
        relax(m.stress.xz, rho_u.x * u.z, source.xz), relax(m.stress.yz, rho_u.y * u.z, source.yz)};
    return result;
}

/// All ghost rates one in the t-orthogonal basis: what is left after collision is a function of ten moments.
struct RegularisedCollision {
    /// g: stored deviations, in: before, out: after collision. F: force per volume. rate: lambda of the
    /// stress.
    template <class V>
    [[gnu::always_inline]] constexpr void operator()(V (&g)[direction_count], const Vec3<V>& F, const V& rate,
                                                     const V& reference_density) const {
        const HydrodynamicStep<V> step = relax_hydrodynamics(moments_of(g), F, rate, reference_density);
        populations_of(step.after, g);
    }
};

} // namespace vesica
