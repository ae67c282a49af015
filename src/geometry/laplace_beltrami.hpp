#pragma once

#include "geometry/stencil.hpp"

namespace vesica {

/// grad_s q = g - n (n.g)
template <class V>
[[gnu::always_inline]] constexpr Vec3<V> tangential(const Vec3<V>& g, const Vec3<V>& n) {
    const V normal = dot(n, g);
    return {fma(-n.x, normal, g.x), fma(-n.y, normal, g.y), fma(-n.z, normal, g.z)};
}

/// Surface divergence of a tangential field g_t: d_i g_t,i - n_i n_j d_j g_t,i. With g_t = grad_s q this is
/// Lap_s q. Divergence form keeps its accuracy under refinement where a difference of second derivatives does
/// not.
template <class V>
[[gnu::always_inline]] constexpr V surface_divergence(const Jacobian<V>& d, const Vec3<V>& n) {
    return d.divergence() - d.normal_component(n);
}

/// What a surface gradient becomes when its divergence is to be that of the mid-surface phi = 0, at signed
/// distance s. With x = x0 + s n the metric of the parallel surface gives, exactly,
///   Lap_0 q = (1/J) div_s ( J (1 - s W)^-2 grad_s q ),   J = det(1 - s W),
/// for q constant along the normals. Here J (1 - s W)^-2 = A^2/J with the adjugate A = (1 - 2 s H) P + s W.
/// G_ij = d_j n_i, H and J those of the cell; g tangential. Of G only what it does along the surface counts,
/// which another sheet nearby hardly touches.
template <class V>
[[gnu::always_inline]] constexpr Vec3<V> flux_on_mid_surface(const Vec3<V>& g, const Jacobian<V>& G,
                                                             const Vec3<V>& n, const V& s, const V& H,
                                                             const V& J) {
    const V spherical = fma(V(-2) * s, H, V(1));
    const auto adjugate = [&](const Vec3<V>& a) VESICA_INLINE_LAMBDA {
        const Vec3<V> Wa = tangential(Vec3<V>{dot(G.x, a), dot(G.y, a), dot(G.z, a)}, n);
        return Vec3<V>{fma(s, Wa.x, spherical * a.x), fma(s, Wa.y, spherical * a.y),
                       fma(s, Wa.z, spherical * a.z)};
    };
    const Vec3<V> twice = adjugate(adjugate(g));
    const V inverse = V(1) / J;
    return {inverse * twice.x, inverse * twice.y, inverse * twice.z};
}

/// The paper's operator (Spendlove et al. 2021, Eq 38, in the sign H > 0 on a sphere):
///   Lap_s H = Lap H - n_i n_j d_i d_j H - n.grad(H^2),
/// from the compact Laplacian, the nested second derivatives d of g = grad H, and H itself.
template <class V>
[[gnu::always_inline]] constexpr V paper_laplace_beltrami(const V& laplacian_H, const Jacobian<V>& d,
                                                          const Vec3<V>& g, const Vec3<V>& n, const V& H) {
    return laplacian_H - d.normal_component(n) - V(2) * H * dot(n, g);
}

} // namespace vesica
