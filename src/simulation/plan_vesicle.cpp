#include "simulation/plan_vesicle.hpp"

#include "core/input_error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace vesica {

namespace {

constexpr double pi = std::numbers::pi;

double sphere_area_of_volume(double volume) {
    return std::cbrt(36.0 * pi * volume * volume);
}

/// The rim of the discocyte of this reduced volume; nothing outside the tabulated range.
std::optional<double> discocyte_smallest_radius(double reduced_volume, double radius) {
    VesicleParameters discocyte;
    discocyte.shape = HelfrichShape{HelfrichBranch::discocyte, reduced_volume};
    discocyte.radius = radius;
    try {
        return make_shape(discocyte)->smallest_radius_of_curvature();
    } catch (const InputError&) {
        return std::nullopt;
    }
}

double penalty_modulus(const AreaParameters& area, double target_area) {
    if (const auto* penalty = std::get_if<PenaltyConstraint>(&area.constraint))
        return penalty->modulus;
    // sigma_A = (alpha/2) A (A - A0) is K_A (A - A0)/A0 with K_A = alpha A A0/2.
    if (const auto* paper = std::get_if<PaperConstraint>(&area.constraint))
        return 0.5 * paper->alpha * target_area * target_area;
    return 0.0;
}

} // namespace

VesiclePlan plan_vesicle(const Parameters& parameters, std::size_t vesicle, const Shape& shape) {
    const FluidParameters& fluid = parameters.fluid;
    const VesicleType& type = parameters.types[parameters.vesicles[vesicle].type];
    const double viscosity = fluid.density * fluid.kinematic_viscosity;

    VesiclePlan plan;
    plan.volume = shape.volume();
    plan.radius = std::cbrt(3.0 * plan.volume / (4.0 * pi));
    plan.area = shape.area();
    plan.target_area = plan.area;
    const bool constrained = !std::holds_alternative<NoConstraint>(type.area.constraint);
    if (type.area.deflation && constrained)
        plan.target_area = *type.area.deflation * sphere_area_of_volume(plan.volume);
    // v = 6 sqrt(pi) V A^(-3/2)
    plan.reduced_volume = 6.0 * std::sqrt(pi) * plan.volume * std::pow(plan.area, -1.5);
    plan.target_reduced_volume = 6.0 * std::sqrt(pi) * plan.volume * std::pow(plan.target_area, -1.5);

    plan.smallest_radius = shape.smallest_radius_of_curvature();
    double smallest = plan.smallest_radius;
    const bool bends = type.bending.modulus > 0.0;
    if (bends && constrained) {
        plan.target_smallest_radius = discocyte_smallest_radius(plan.target_reduced_volume, plan.radius);
        // A shape that starts at its target need not become a discocyte; one that is deflated may.
        const bool changes = std::abs(plan.target_area / plan.area - 1.0) > 1e-3;
        if (!changes)
            plan.target_smallest_radius.reset();
        if (plan.target_smallest_radius)
            smallest = std::min(smallest, *plan.target_smallest_radius);
    }
    plan.resolution = fluid.segregation * smallest;

    plan.viscosity_ratio = type.viscosity_ratio;
    plan.inner_relaxation_time = 3.0 * fluid.kinematic_viscosity * type.viscosity_ratio + 0.5;
    const Vec3<int>& size = parameters.size;
    plan.confinement = 2.0 * plan.radius / std::min({size.x, size.y, size.z});
    plan.penalty_modulus = penalty_modulus(type.area, plan.target_area);
    plan.buoyant_speed = 2.0 / 9.0 * norm(parameters.buoyancy_of(parameters.vesicles[vesicle])) *
                         plan.radius * plan.radius / viscosity;

    const double R0 = plan.radius;
    const double kappa = type.bending.modulus;
    if (bends) {
        plan.bending_time = viscosity * R0 * R0 * R0 / kappa;
        plan.bending_speed = R0 / *plan.bending_time;
        plan.reynolds = fluid.density * *plan.bending_speed * R0 / viscosity;
    }
    if (type.sigma > 0.0)
        plan.capillary_time = viscosity * R0 / type.sigma;
    if (bends && type.sigma > 0.0)
        plan.bending_over_tension = kappa / (type.sigma * R0 * R0);
    return plan;
}

double gap_between(const Shape& a, const Vec3<double>& centre_a, const Shape& b, const Vec3<double>& centre_b,
                   const Vec3<double>& shift, double reach) {
    const double radius_a = a.bounding_radius();
    const double radius_b = b.bounding_radius();
    const Vec3<double> between = centre_b + shift - centre_a;
    if (norm(between) > radius_a + radius_b + reach)
        return std::numeric_limits<double>::infinity();

    // For x between two bodies s_a(x) + s_b(x) is the length of the way from one to the other through x: its
    // minimum is their distance, stationary along the shortest way, so that a grid of one cell finds it well.
    double gap = std::numeric_limits<double>::infinity();
    Vec3<double> low{};
    Vec3<double> high{};
    for (int axis = 0; axis < 3; ++axis) {
        const double other = centre_b[axis] + shift[axis];
        low[axis] = std::max(centre_a[axis] - radius_a, other - radius_b) - reach;
        high[axis] = std::min(centre_a[axis] + radius_a, other + radius_b) + reach;
    }
    for (double z = low.z; z <= high.z; z += 1.0)
        for (double y = low.y; y <= high.y; y += 1.0)
            for (double x = low.x; x <= high.x;) {
                const Vec3<double> position{x, y, z};
                const double from_a = a.signed_distance(position);
                if (from_a > gap) { // a distance falls by no more than the way gone
                    x += std::max(1.0, std::floor(std::min(from_a, Shape::reach) - gap));
                    continue;
                }
                gap = std::min(gap, from_a + b.signed_distance(position - shift));
                x += 1.0;
            }
    return gap;
}

} // namespace vesica
