#pragma once

#include "geometry/stencil.hpp"

namespace vesica {

/// Mean and Gaussian curvature; H > 0 on a sphere.
template <class V>
struct Curvatures {
    V H{};
    V K{};
};

/// From G_ij = d_j n_i alone: W = P G P with P = 1 - n n, H = div n/2, K = [(tr W)^2 - tr(W W)]/2.
/// For exact derivatives div n = tr W. Of the lattice's leading error, (1/6) Lap n, the divergence of a
/// sphere's normals sees nothing, while tr W would make H low by 1/(3 R^2). For K the projected form is the
/// better one: its integral over a closed surface stays near 4 pi (1 - genus).
template <class V>
[[gnu::always_inline]] constexpr Curvatures<V> curvatures_of(const Jacobian<V>& G, const Vec3<V>& n) {
    // a_i = n_j d_j n_i and b_j = n_i d_j n_i are zero for exact unit normals along straight lines; on a
    // lattice the projection takes out what is left of them.
    const Vec3<V> a{dot(G.x, n), dot(G.y, n), dot(G.z, n)};
    const Vec3<V> b{fma(G.x.x, n.x, fma(G.y.x, n.y, G.z.x * n.z)),
                    fma(G.x.y, n.x, fma(G.y.y, n.y, G.z.y * n.z)),
                    fma(G.x.z, n.x, fma(G.y.z, n.y, G.z.z * n.z))};
    const V c = dot(a, n);
    // tr W = tr G - n G n, and tr(W W) = tr(G G) - 2 n G G n + (n G n)^2, as P P = P.
    const V divergence = G.divergence();
    const V trace = divergence - c;
    const V squares = fma(G.x.x, G.x.x, fma(G.y.y, G.y.y, G.z.z * G.z.z));
    const V products = fma(G.x.y, G.y.x, fma(G.x.z, G.z.x, G.y.z * G.z.y)) - dot(a, b);
    const V trace_of_square = fma(V(2), products, fma(c, c, squares));
    const V K = V(0.5) * (trace * trace - trace_of_square);
    const V restored = fma(V(1.0 / 6.0), fma(divergence, divergence, V(-2) * K), V(1));
    return {V(0.5) * divergence, restored * restored * K};
}

/// Area of phi = 0 per area of the parallel surface through a cell at signed distance s from it:
/// J = 1 - 2 s H + s^2 K, exact for parallel surfaces. Where layers of a thin or sharply bent vesicle meet, s
/// is no distance and J may come near zero or below: it is kept between 1/10 and 10.
template <class V>
[[gnu::always_inline]] constexpr V area_to_mid_surface(const Curvatures<V>& c, const V& s) {
    return smaller(larger(fma(s * s, c.K, fma(V(-2) * s, c.H, V(1))), V(0.1)), V(10));
}

/// The curvatures of phi = 0 on the normal through a cell: H0 = (H - s K)/J, K0 = K/J.
template <class V>
[[gnu::always_inline]] constexpr Curvatures<V> map_to_mid_surface(const Curvatures<V>& c, const V& s) {
    const V inverse = V(1) / area_to_mid_surface(c, s);
    return {inverse * fma(-s, c.K, c.H), inverse * c.K};
}

} // namespace vesica
