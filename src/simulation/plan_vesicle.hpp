#pragma once

#include "case/parameters.hpp"
#include "shape/shape.hpp"

#include <cstddef>
#include <optional>

namespace vesica {

/// What can be said of one vesicle before the first step, in lattice units. Groups as usual for vesicles:
/// R0 is the radius of the sphere of equal volume, eta the outer dynamic viscosity.
struct VesiclePlan {
    double radius = 0.0; ///< R0
    double volume = 0.0;
    double area = 0.0;           ///< of the initial shape
    double target_area = 0.0;    ///< after the ramp; the initial area if it is kept or free
    double reduced_volume = 1.0; ///< of the initial shape
    double target_reduced_volume = 1.0;
    double smallest_radius = 0.0;                 ///< smallest radius of curvature, initial shape
    std::optional<double> target_smallest_radius; ///< of the discocyte the area leads to, where it is known
    double resolution = 0.0;                      ///< beta times the smaller of the two
    double viscosity_ratio = 1.0;
    double inner_relaxation_time = 1.0;
    double confinement = 0.0;     ///< 2 R0 over the shortest edge of the box
    double penalty_modulus = 0.0; ///< K_A, 0 without a penalty
    double buoyant_speed = 0.0;   ///< of a hard sphere, (2/9) b R0^2/eta

    // With bending only.
    std::optional<double> bending_time;  ///< tau_b = eta R0^3/kappa, steps
    std::optional<double> bending_speed; ///< R0/tau_b = kappa/(eta R0^2)
    std::optional<double> reynolds;      ///< with that speed: kappa/(rho nu^2 R0) = Re/Ca_kappa of any flow
    // With tension only.
    std::optional<double> capillary_time; ///< eta R0/sigma, steps
    // With both.
    std::optional<double>
        bending_over_tension; ///< kappa/(sigma R0^2), which is Ca_sigma of the bending speed
};

/// `shape` is the vesicle's initial shape.
VesiclePlan plan_vesicle(const Parameters& parameters, std::size_t vesicle, const Shape& shape);

/// The smallest distance between two closed surfaces, `b` displaced by `shift`; negative if they overlap.
/// Within half a cell. Infinite if the bounding spheres are farther apart than `reach`.
double gap_between(const Shape& a, const Vec3<double>& centre_a, const Shape& b, const Vec3<double>& centre_b,
                   const Vec3<double>& shift, double reach);

} // namespace vesica
