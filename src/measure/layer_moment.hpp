#pragma once

namespace vesica {

/// Moments of the diffuse layer about phi = 0, by which sums over cells exceed integrals over the sharp
/// surface and the body inside (cells^2, cells^4). With w = (beta/2)(1 - phi^2) and s the distance to phi =
/// 0,
///
///     area:    sum_x w q          = int (q + (area/2) q'' + ...),             area   = int w s^2 ds,
///     volume:  sum_x q(1 + phi)/2 = int_V q + (volume/2) int (n.grad q + 2 H q) dA + ...,
///                                                                            volume = int (-phi'/2) s^2 ds.
///
/// For a tanh w = -phi'/2 and the two agree; on the lattice's own profile they differ by 1/6 (see below).
struct LayerMoments {
    double area = 0.0;
    double volume = 0.0;
    double volume_fourth = 0.0; ///< int (-phi'/2) s^4 ds
};

/// Of phi = -tanh(beta s), the initial state: pi^2/(12 beta^2), fourth moment 7 pi^4/(240 beta^4).
LayerMoments tanh_layer_moments(double beta);

/// Of the lattice's own stationary flat profile along an axis, which obeys, between neighbouring nodes,
///
///     phi' - phi = -(beta/2)(2 - phi'^2 - phi^2),
///
/// averaged over the offset of phi = 0 from the nodes. Dividing by -2, the difference over a cell is the mean
/// of w at its ends, so the Fourier transforms D of -phi'/2 and W of w obey D = W (k/2)/tan(k/2) and volume =
/// area + 1/6, volume_fourth = area_fourth + area - 1/30. Needs 0 < beta < 1.
LayerMoments lattice_layer_moments(double beta);

/// The node after one with 1 + phi = `height`, going outwards along that profile, as 1 + phi (which keeps its
/// digits in the tail): decreasing, and by (1 - beta)/(1 + beta) per cell in the far tail.
double next_height(double height, double beta);

} // namespace vesica
