#pragma once

#include "case/case.hpp"
#include "simulation/plan.hpp"

#include <cmath>
#include <memory>
#include <vector>

namespace vesica {

/// Cells between two surfaces at which their interfaces, 2/beta wide, and the stencils there do not meet.
inline double comfortable_gap(const FluidParameters& fluid) {
    return 2.0 / fluid.segregation + 2.0;
}

/// Cells between a surface and an open end: a run ends where the layer, down to the cutoff, has come within
/// six of it.
inline double gap_to_open_ends(const Parameters& parameters) {
    return 6.0 + std::atanh(std::sqrt(1.0 - parameters.numerics.cutoff)) / parameters.fluid.segregation;
}

/// The judgements a plan is made of; each adds what it has to say to `remarks`.

void judge_fluid(const Parameters& parameters, const Plan& plan, Remarks& remarks);
void judge_flow(const Parameters& parameters, const Plan& plan, const RunParameters& run, Remarks& remarks);
void judge_vesicle(const Parameters& parameters, std::size_t vesicle, const VesiclePlan& plan,
                   const RunParameters& run, const PlanOptions& options, Remarks& remarks);
void judge_places(const Case& what, const std::vector<std::unique_ptr<const Shape>>& shapes, const Plan& plan,
                  Remarks& remarks);
void judge_schedule(const Parameters& parameters, const RunParameters& run, const OutputParameters& output,
                    Remarks& remarks);

} // namespace vesica
