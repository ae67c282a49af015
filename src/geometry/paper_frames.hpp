#pragma once

#include "geometry/curvature.hpp"

namespace vesica {

/// H and K by the paper's three local frames (Spendlove et al. 2021, Eqs 54-62 and B2-B10, with the exponents
/// of B9 corrected). In a tangent frame (x, y) at the cell the Monge form has f_xx = -(n_x)_x and so on, so
/// with outward n and H > 0 on a sphere: H = ((n_x)_x + (n_y)_y)/2, K = (n_x)_x (n_y)_y - ((n_y)_x)^2. A
/// frame divides by 1 - N_a^2; the one whose axis a is farthest from the normal (|N_a| smallest) is taken.
template <class V>
struct FrameDerivatives {
    V xx{}; ///< (n_x)_x
    V yy{}; ///< (n_y)_y
    V yx{}; ///< (n_y)_x
};

namespace detail {

/// e_x = (e_a x N)/|e_a x N| in cyclic order (a, b, c): components (0, -N_c, N_b)/r, r^2 = 1 - N_a^2;
/// e_y = N x e_x: components (1 - N_a^2, -N_a N_b, -N_a N_c)/r. G[i][j] = d_j N_i.
template <int a, class V>
[[gnu::always_inline]] constexpr FrameDerivatives<V> frame_derivatives(const Jacobian<V>& jacobian,
                                                                       const Vec3<V>& N) {
    constexpr int b = (a + 1) % 3;
    constexpr int c = (a + 2) % 3;
    const Vec3<V> G[3] = {jacobian.x, jacobian.y, jacobian.z};
    const V Na = N[a];
    const V Nb = N[b];
    const V Nc = N[c];
    const V q = V(1) - Na * Na;
    const V inverse = V(1) / larger(q, V(1e-12));
    FrameDerivatives<V> d;
    d.xx = inverse * (Nc * Nc * G[b][b] + Nb * Nb * G[c][c] - Nb * Nc * (G[b][c] + G[c][b]));
    d.yy = inverse * (q * q * G[a][a] + Na * Na * Nb * Nb * G[b][b] + Na * Na * Nc * Nc * G[c][c] -
                      q * Na * Nb * (G[a][b] + G[b][a]) - q * Na * Nc * (G[a][c] + G[c][a]) +
                      Na * Na * Nb * Nc * (G[b][c] + G[c][b]));
    d.yx = inverse * (q * (Nb * G[a][c] - Nc * G[a][b]) + Na * Nb * Nc * (G[b][b] - G[c][c]) +
                      Na * (Nc * Nc * G[c][b] - Nb * Nb * G[b][c]));
    return d;
}

template <class V>
[[gnu::always_inline]] constexpr Curvatures<V> curvatures_in_frame(const FrameDerivatives<V>& d) {
    // The rotation to the principal frame (Eqs 56-58) leaves trace and determinant as they are.
    return {V(0.5) * (d.xx + d.yy), fma(d.xx, d.yy, -(d.yx * d.yx))};
}

} // namespace detail

/// Curvatures in the frame of axis a: 2 is the paper's frame 1, 0 its frame 2, 1 its frame 3.
template <int a, class V>
[[gnu::always_inline]] constexpr Curvatures<V> curvatures_in_frame_of(const Jacobian<V>& G,
                                                                      const Vec3<V>& N) {
    return detail::curvatures_in_frame(detail::frame_derivatives<a>(G, N));
}

/// Curvatures in the best conditioned of the three frames.
template <class V>
[[gnu::always_inline]] constexpr Curvatures<V> paper_curvatures_of(const Jacobian<V>& G, const Vec3<V>& N) {
    const Curvatures<V> of_x = curvatures_in_frame_of<0>(G, N);
    const Curvatures<V> of_y = curvatures_in_frame_of<1>(G, N);
    const Curvatures<V> of_z = curvatures_in_frame_of<2>(G, N);
    const Vec3<V> size{magnitude(N.x), magnitude(N.y), magnitude(N.z)};
    const auto x_before_y = size.x <= size.y;
    const Curvatures<V> of_xy{select(x_before_y, of_x.H, of_y.H), select(x_before_y, of_x.K, of_y.K)};
    const auto z_smallest = size.z < smaller(size.x, size.y);
    return {select(z_smallest, of_z.H, of_xy.H), select(z_smallest, of_z.K, of_xy.K)};
}

} // namespace vesica
