#include "simulation/plan_flow.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vesica {

FlowPlan plan_flow(const Parameters& parameters) {
    const FlowParameters& flow = parameters.flow;
    FlowPlan plan;
    double walls = 0.0;
    for (const AxisEnds& ends : parameters.ends) {
        if (const auto* moving = std::get_if<WallEnds>(&ends))
            walls = std::max({walls, norm(moving->lower_velocity), norm(moving->upper_velocity)});
        if (const auto* open = std::get_if<OpenEnds>(&ends))
            walls = std::max(walls,
                             (open->parabolic ? 2.1 : 1.0) * open->velocity); // 2.1: in the middle of a duct
    }
    double shear = 0.0;
    if (flow.shear) {
        plan.rate = std::abs(flow.shear->rate);
        shear = 0.5 * *plan.rate * parameters.size[flow.shear->gradient];
    }
    double channel = 0.0;
    double height = std::numeric_limits<double>::infinity();
    double side = std::numeric_limits<double>::infinity();
    for (int a = 0; a < 3; ++a) {
        side = std::min(side, static_cast<double>(parameters.size[a]));
        if (parameters.has_walls(a))
            height = std::min(height, static_cast<double>(parameters.size[a]));
    }
    if (std::isinf(height))
        height = side; // obstacles hold the fluid: no channel between them is wider than the box
    const double viscosity = parameters.fluid.density * parameters.fluid.kinematic_viscosity;
    if (flow.body_force && (parameters.is_bounded() || parameters.obstacles))
        channel = norm(flow.body_force->force) * height * height / (8.0 * viscosity);
    if (flow.poiseuille) {
        const double push = std::abs(flow.poiseuille->pressure_gradient);
        channel += push * height * height / (8.0 * viscosity); // between planes; less in a duct
        if (!plan.rate)
            plan.rate = push * height / (2.0 * viscosity);
    }
    double extension = 0.0;
    if (flow.extension) {
        plan.rate = std::abs(flow.extension->rate);
        const Vec3<int>& size = parameters.size;
        extension =
            0.5 * *plan.rate * std::hypot(size[flow.extension->stretch], size[flow.extension->squeeze]);
    }
    plan.speed = walls + shear + channel + extension;
    return plan;
}

FlowGroups flow_groups(const Parameters& parameters, double rate, double radius, const VesicleType& type) {
    const double viscosity = parameters.fluid.density * parameters.fluid.kinematic_viscosity;
    FlowGroups groups;
    groups.reynolds = rate * radius * radius / parameters.fluid.kinematic_viscosity;
    if (type.bending.modulus > 0.0)
        groups.capillary_bending = viscosity * rate * std::pow(radius, 3) / type.bending.modulus;
    if (type.sigma > 0.0)
        groups.capillary_tension = viscosity * rate * radius / type.sigma;
    return groups;
}

} // namespace vesica
