#pragma once

#include "core/real.hpp"
#include "core/vec3.hpp"

#include <cmath>

namespace vesica {

/// Spreads a force per membrane area over the diffuse layer: F = -(1/2) f_n grad psi, where psi(phi) goes
/// from -1 outside to 1 inside. The lattice's gradients of any psi add up to its jump, 2, across a layer,
/// whatever the layer's direction, place and exact profile; so the layer sustains the pressure jump f_n. A
/// constant f_n is the gradient of a potential; the flow it drives all the same is the lattice's, whose
/// streaming balances averages of a force over its links.
///
/// psi = (3 x - x^3)/2 with x = phi/phi_c kept within -1..1, phi_c^2 = 1 - cutoff: flat beyond 1 - phi^2 =
/// cutoff, where curvatures are not trusted, without a corner there, and steepest at phi = 0: the force falls
/// off like (1 - phi^2)^2 and rests on the cells whose geometry is the best.
class LayerForce {
public:
    /// cutoff: the 1 - phi^2 below which there is no force.
    constexpr explicit LayerForce(double cutoff) : inverse_reach_(1.0 / std::sqrt(1.0 - cutoff)) {}

    /// psi of a cell.
    template <class V>
    [[gnu::always_inline]] constexpr V profile(const V& phi) const {
        const V x = smaller(larger(V(inverse_reach_) * phi, V(-1)), V(1));
        return V(0.5) * x * fma(-x, x, V(3));
    }

    /// Force per volume on the fluid. `profile_gradient` is grad psi, `normal_force` f_n per membrane area.
    template <class V>
    [[gnu::always_inline]] constexpr Vec3<V> operator()(const Vec3<V>& profile_gradient,
                                                        const V& normal_force) const {
        const V strength = V(-0.5) * normal_force;
        return {strength * profile_gradient.x, strength * profile_gradient.y, strength * profile_gradient.z};
    }

private:
    double inverse_reach_ = 1.0;
};

} // namespace vesica
