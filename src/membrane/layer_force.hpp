#pragma once

#include "core/real.hpp"
#include "core/vec3.hpp"

namespace vesica {

/// Spreads a force per membrane area over the diffuse layer: F = (1/2)|grad phi| f_n n = -(1/2) grad phi f_n,
/// since int (1/2)|grad phi| ds = 1 across the layer: with f_n constant along the normals the layer sustains
/// exactly the pressure jump f_n, whatever its curvature (a constant f_n is a pure gradient and drives no
/// flow at all). In the far tails, where curvatures are not trusted, the force is tapered to zero: the weight
/// falls smoothly from one at 1 - phi^2 = onset to zero at 1 - phi^2 = cutoff, and what the taper takes away
/// is given back by a constant factor, so that the weight still integrates to one.
class LayerForce {
public:
    /// cutoff: the 1 - phi^2 below which there is no force; the taper ends at four times that (at most 1/2).
    explicit LayerForce(double cutoff) : cutoff_(cutoff), inverse_width_(1.0 / (onset(cutoff) - cutoff)) {
        // (1/2) int_{-1}^{1} taper(1 - phi^2) dphi by the midpoint rule in phi, fine enough for 1e-9.
        constexpr int points = 20000;
        double sum = 0.0;
        for (int k = 0; k < points; ++k) {
            const double phi = (k + 0.5) / points;
            sum += taper(1.0 - phi * phi) / points;
        }
        inverse_mass_ = 1.0 / sum;
    }

    /// Smooth step 3 t^2 - 2 t^3 in 1 - phi^2.
    template <class V>
    [[gnu::always_inline]] V taper(const V& layer_density) const {
        const V t = smaller(larger(V(inverse_width_) * (layer_density - V(cutoff_)), V(0)), V(1));
        return t * t * fma(V(-2), t, V(3));
    }

    /// Force per volume on the fluid. `phase_gradient` is grad phi, `normal_force` f_n per membrane area.
    template <class V>
    [[gnu::always_inline]] Vec3<V> operator()(const V& layer_density, const Vec3<V>& phase_gradient,
                                              const V& normal_force) const {
        const V strength = V(-0.5 * inverse_mass_) * taper(layer_density) * normal_force;
        return {strength * phase_gradient.x, strength * phase_gradient.y, strength * phase_gradient.z};
    }

private:
    static constexpr double onset(double cutoff) { return 4.0 * cutoff < 0.5 ? 4.0 * cutoff : 0.5; }

    double cutoff_ = 0.0;
    double inverse_width_ = 0.0;
    double inverse_mass_ = 1.0;
};

} // namespace vesica
