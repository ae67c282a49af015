#pragma once

#include "core/vec3.hpp"
#include "lattice/velocity_set.hpp"

namespace vesica {

/// A collision relaxes the populations of one cell in place: `g` are the stored deviations f_i - t_i rho0, F
/// the force per volume, `rate` the relaxation rate of the stress, `reference_density` rho0. Mass stays,
/// momentum gains F.
template <class Collision>
concept CollisionModel = requires(const Collision& collision, double (&g)[direction_count],
                                  const Vec3<double>& F, const double& number) {
    collision(g, F, number, number);
};

} // namespace vesica
