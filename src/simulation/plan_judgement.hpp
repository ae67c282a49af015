#pragma once

#include "case/parameters.hpp"
#include "simulation/plan.hpp"

#include <memory>
#include <vector>

namespace vesica {

/// The judgements a plan is made of; each adds what it has to say to `remarks`.

void judge_fluid(const Parameters& parameters, const Plan& plan, Remarks& remarks);
void judge_flow(const Parameters& parameters, const Plan& plan, const RunParameters& run, Remarks& remarks);
void judge_vesicle(const Parameters& parameters, std::size_t vesicle, const VesiclePlan& plan,
                   const RunParameters& run, const PlanOptions& options, Remarks& remarks);
void judge_places(const Parameters& parameters, const std::vector<std::unique_ptr<const Shape>>& shapes,
                  const Plan& plan, Remarks& remarks);
void judge_schedule(const Parameters& parameters, const RunParameters& run, const OutputParameters& output,
                    Remarks& remarks);

} // namespace vesica
