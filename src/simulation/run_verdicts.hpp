#pragma once

#include "case/parameters.hpp"
#include "io/run_summary.hpp"
#include "measure/metrics.hpp"
#include "simulation/run_loop.hpp"

#include <vector>

namespace vesica {

/// What the last sample of a run says about the run: area held, mass conserved, topology kept and, for a
/// steady vesicle without spontaneous curvature, the energy of the exact shape (Helfrich 1973). A question
/// that has no answer is not asked: about the area before the ramp is over, about the energy of a shape on
/// its way.
std::vector<Verdict> judge_run(const Parameters& parameters, const RunParameters& run, RunEnd end,
                               const std::vector<MetricsRow>& last);

} // namespace vesica
