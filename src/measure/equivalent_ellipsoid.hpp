#pragma once

#include "measure/solid_body.hpp"

#include <array>
#include <optional>

namespace vesica {

/// The ellipsoid of equal volume and inertia: a_i^2 = 5 M_i/V of the second moments' eigenvalues M_i.
struct EquivalentEllipsoid {
    std::array<double, 3> semi_axes{};        ///< descending, cells
    std::array<Vec3<double>, 3> directions{}; ///< orthonormal, in that order; signs arbitrary
};

EquivalentEllipsoid equivalent_ellipsoid(const SolidBody& body);

/// The plane in which a flow shears: two orthonormal vectors.
struct ShearPlane {
    Vec3<double> flow{1.0, 0.0, 0.0};
    Vec3<double> gradient{0.0, 0.0, 1.0};
};

/// How the ellipsoid of equal inertia looks in the shear plane (its shadow along the vorticity).
struct PlaneDeformation {
    double taylor = 0.0; ///< (L - B)/(L + B)
    double inclination =
        0.0; ///< of L, degrees in (-90, 90] from the flow towards the gradient; NaN without flow
};

/// Without a flow the plane of the largest and the smallest axis serves.
PlaneDeformation plane_deformation(const SolidBody& body, const std::optional<ShearPlane>& plane);

} // namespace vesica
