#pragma once

#include "case/parameters.hpp"

#include <optional>

namespace vesica {

/// What can be said of a case's flow before the first step, in lattice units.
struct FlowPlan {
    double speed = 0.0;         ///< the fastest that walls or the fluid alone reach
    std::optional<double> rate; ///< of shear: the flow's own, or a channel's at its walls
};

FlowPlan plan_flow(const Parameters& parameters);

/// A vesicle's groups in a flow of this rate. R0 is the radius of the sphere of equal volume, eta the outer
/// dynamic viscosity.
struct FlowGroups {
    double reynolds = 0.0;                   ///< rho gamma R0^2/eta
    std::optional<double> capillary_bending; ///< eta gamma R0^3/kappa
    std::optional<double> capillary_tension; ///< eta gamma R0/sigma
};

FlowGroups flow_groups(const Parameters& parameters, double rate, double radius, const VesicleType& type);

} // namespace vesica
