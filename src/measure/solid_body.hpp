#pragma once

#include "measure/snapshot.hpp"

#include <array>

namespace vesica {

/// A symmetric tensor in space.
struct SymmetricTensor {
    double xx = 0.0;
    double yy = 0.0;
    double zz = 0.0;
    double xy = 0.0;
    double xz = 0.0;
    double yz = 0.0;
};

/// The body inside phi = 0 as if it were solid and of density one.
struct SolidBody {
    double volume = 0.0;      ///< cells^3
    Vec3<double> centre{};    ///< of mass, unwrapped like the snapshot
    SymmetricTensor second{}; ///< int (x - centre)(x - centre) dV, cells^5
};

/// Volume, centre and second moments, corrected for the layer. For a smooth q
///
///     sum q (1 + phi)/2 = int_V q dV + int [c H q + (m2/2)(n.grad q + 2 H q) + (m4/4)(2 H q2 + K n.grad q)]
///     dA
///
/// with c, m2 and m4 the shift and the moments of LayerMoments, and q2 the second-order coefficient of q
/// along n; from the parallel surfaces' areas 1 + 2 s H + s^2 K, and exact for a tanh and q up to second
/// degree. q = 1, x and x x are used. Without geometry nothing is corrected.
SolidBody solid_body(const VesicleSnapshot& vesicle);
/// The same, about a centre of mass and with an area that are known.
SolidBody solid_body(const VesicleSnapshot& vesicle, const Vec3<double>& centre_of_mass, double known_area);

/// The volume inside phi = 0: sum (1 + phi)/2 minus the layer's share, proportional to int H dA.
double volume(const VesicleSnapshot& vesicle);

/// Centre of all the colour, sum x (1 + phi)/2 / sum (1 + phi)/2: not corrected for the layer, so that it
/// moves with the velocity that the colour's momentum states.
Vec3<double> centre_of_mass(const VesicleSnapshot& vesicle);

/// (R0/R_A)^3 = 6 sqrt(pi) V / A^(3/2): 1 for a sphere.
double reduced_volume(double volume, double area);

/// Ascending eigenvalues of the inertia tensor about the centre, density times int (r^2 delta - r r) dV.
std::array<double, 3> principal_inertia(const SolidBody& body, double density);

} // namespace vesica
