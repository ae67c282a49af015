#pragma once

namespace vesica {

/// How far sums over the cells of a diffuse layer exceed integrals over the sharp surface phi = 0 and the
/// body inside. With w = (beta/2)(1 - phi^2), whose integral across the layer is one, s the distance to phi =
/// 0, and m = `volume`, c = `shift`,
///
///     sum w           = A + area int K dA + bending int H^2 dA
///     sum q (1+phi)/2 = int_V q dV + int [c H q + (m/2)(n.grad q + 2 H q)] dA + ...
///
/// The parallel surfaces' areas, 1 + 2 s H + s^2 K, bring in the layer's second moments: `area`, of w, and
/// `volume`, of -phi'/2. Curvature makes the lattice's profile itself lopsided: `bending` and `shift` say by
/// how much. Cells^2 all, but for the fourth moment.
struct LayerMoments {
    double area = 0.0;
    double bending = 0.0;
    double volume = 0.0;
    double shift = 0.0;
    double volume_fourth = 0.0; ///< int (-phi'/2) s^4 ds, cells^4
};

/// Of phi = -tanh(beta s), the initial state: both second moments are pi^2/(12 beta^2), the fourth is
/// 7 pi^4/(240 beta^4), and nothing is lopsided.
LayerMoments tanh_layer_moments(double beta);

/// Of the profile that the lattice relaxes to. Flat and along an axis it obeys, between neighbouring nodes,
///
///     phi' - phi = -(beta/2)(2 - phi'^2 - phi^2);
///
/// `area` is its moment averaged over the offset of phi = 0 from the nodes. Dividing by -2, the difference
/// over a cell is the mean of w at its ends, so the Fourier transforms D of -phi'/2 and W of w obey D = W
/// (k/2)/tan(k/2): volume = area + 1/6, volume_fourth = area_fourth + area - 1/30. The same holds in any
/// direction, since the velocity set is isotropic to fourth order.
///
/// On a curved layer the colour's balance to fourth order, with D = -phi'/2 along the normal, is
///
///     D - (D'' + (2 H D)')/12 = w.
///
/// Its solution is displaced by shift H, shift = (1 - ln 2)/3, and integrating it over the parallel surfaces
/// gives bending = 1/3 + 2 shift. Both are the leading terms for small beta, and 7 % high at beta = 0.67.
/// Needs 0 < beta < 1.
LayerMoments lattice_layer_moments(double beta);

/// The node after one with 1 + phi = `height`, going outwards along that profile, as 1 + phi (which keeps its
/// digits in the tail): decreasing, and by (1 - beta)/(1 + beta) per cell in the far tail.
double next_height(double height, double beta);

} // namespace vesica
