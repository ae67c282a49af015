#pragma once

#include "case/case.hpp"
#include "simulation/plan_flow.hpp"
#include "simulation/plan_remarks.hpp"
#include "simulation/plan_vesicle.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace vesica {

struct PlanOptions {
    /// Membranes so soft that the recolouring's own resistance is more than a tenth of theirs are refused
    /// unless their user knows.
    bool accept_soft_membranes = false;
};

/// What can be known of a run before its first step.
struct Plan {
    std::int64_t cells = 0;
    double relaxation_time = 1.0; ///< of the outer fluid: 3 nu + 1/2
    double interface_width = 0.0; ///< 2/beta, cells
    FlowPlan flow;
    std::shared_ptr<const SolidVoxels> obstacles; ///< null without
    double expected_speed = 0.0; ///< the fastest of the flow and of the vesicles' own, cells per step
    double mach = 0.0;           ///< expected_speed over the speed of sound
    std::vector<VesiclePlan> vesicles;
    std::size_t different =
        0;           ///< of them, the first ones: those that were packed are alike, but for their places
    Remarks remarks; ///< each begins with its place in the case file
};

/// Plans and judges. Throws InputError where the case cannot be built at all (shapes); whatever else `run`
/// refuses is a remark of severity error.
Plan make_plan(const Case& what, const PlanOptions& options = {});

/// Throws InputError with every error the plan found, if it found any.
void refuse_errors(const Plan& plan);

} // namespace vesica
