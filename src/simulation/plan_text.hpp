#pragma once

#include "case/case.hpp"
#include "simulation/plan.hpp"
#include "simulation/plan_cost.hpp"

#include <optional>
#include <string>

namespace vesica {

/// What `check` prints: lattice and SI values side by side, groups, resolution, cost, and what there is to
/// say.
std::string plan_text(const Case& what, const Plan& plan, const std::optional<RunCost>& cost, int threads);

/// What `check --model` prints: what is in the model, and what is not.
std::string model_text();

} // namespace vesica
