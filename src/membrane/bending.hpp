#pragma once

#include "core/real.hpp"

namespace vesica {

/// Helfrich 1973: E = (kappa/2) int (2H - C0)^2 dA. Minus its variation is the normal force per membrane
/// area,
///   f_n = kappa [ 2 Lap_s H + (2H - C0)(2H^2 - 2K + C0 H) ]
/// along the outward normal, with H > 0 on a sphere.
struct HelfrichLaw {
    double modulus = 0.0;
    double spontaneous_curvature = 0.0;

    template <class V>
    [[gnu::always_inline]] constexpr V force(const V& H, const V& K, const V& laplace_beltrami_H) const {
        const V c0 = V(spontaneous_curvature);
        const V excess = V(2) * H - c0;
        const V shape = fma(V(2) * H, H, fma(V(-2), K, c0 * H));
        return V(modulus) * fma(V(2), laplace_beltrami_H, excess * shape);
    }

    /// Energy per membrane area.
    template <class V>
    [[gnu::always_inline]] constexpr V energy(const V& H) const {
        const V excess = V(2) * H - V(spontaneous_curvature);
        return V(0.5 * modulus) * excess * excess;
    }
};

/// The form printed by Spendlove et al. 2021: kappa_B (c Lap_s H + H^3 - H K), kappa_B = 4 kappa. c = 1/2
/// (their Eq 32) is Helfrich's law at C0 = 0; c = 3/2 (Eqs 13, 42) is the derivative of no energy and pushes
/// shapes without mirror symmetry through the fluid.
struct PaperBendingLaw {
    double modulus = 0.0; ///< kappa, a quarter of the paper's kappa_B
    double laplacian_coefficient = 1.5;

    template <class V>
    [[gnu::always_inline]] constexpr V force(const V& H, const V& K, const V& laplace_beltrami_H) const {
        return V(4 * modulus) * fma(V(laplacian_coefficient), laplace_beltrami_H, H * fma(H, H, -K));
    }

    /// The energy whose derivative the curvature part is: (kappa_B/2) int H^2 dA.
    template <class V>
    [[gnu::always_inline]] constexpr V energy(const V& H) const {
        return V(2 * modulus) * H * H;
    }
};

} // namespace vesica
