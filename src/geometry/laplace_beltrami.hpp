#pragma once

#include "geometry/stencil.hpp"

namespace vesica {

/// grad_s q = g - n (n.g)
template <class V>
[[gnu::always_inline]] inline Vec3<V> tangential(const Vec3<V>& g, const Vec3<V>& n)
{
    const V normal = dot(n, g);
    return {fma(-n.x, normal, g.x), fma(-n.y, normal, g.y), fma(-n.z, normal, g.z)};
}

/// Surface divergence of a tangential field g_t: d_i g_t,i - n_i n_j d_j g_t,i. With g_t = grad_s q this is Lap_s q.
/// Divergence form keeps its accuracy under refinement where a difference of second derivatives does not.
template <class V>
[[gnu::always_inline]] inline V surface_divergence(const Jacobian<V>& d, const Vec3<V>& n)
{
    return d.divergence() - d.normal_component(n);
}

/// The paper's operator (Spendlove et al. 2021, Eq 38, in the sign H > 0 on a sphere):
///   Lap_s H = Lap H - n_i n_j d_i d_j H - n.grad(H^2),
/// from the compact Laplacian, the nested second derivatives d of g = grad H, and H itself.
template <class V>
[[gnu::always_inline]] inline V paper_laplace_beltrami(const V& laplacian_H, const Jacobian<V>& d, const Vec3<V>& g,
                                                       const Vec3<V>& n, const V& H)
{
    return laplacian_H - d.normal_component(n) - V(2) * H * dot(n, g);
}

} // namespace vesica
