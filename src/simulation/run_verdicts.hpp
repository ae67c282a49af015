#pragma once

#include "case/parameters.hpp"
#include "measure/metrics.hpp"
#include "simulation/run_loop.hpp"

#include <optional>
#include <string>
#include <vector>

namespace vesica {

/// One question asked of a finished run. `passed` is absent where the question has no answer: the run was not meant
/// to, or not over.
struct Verdict {
    std::string name;       ///< "area", "mass", ...
    int vesicle = -1;       ///< -1: the run as a whole
    std::string question;   ///< a sentence
    double found = 0.0;
    double expected = 0.0;
    double tolerance = 0.0; ///< of found - expected, absolute
    std::optional<bool> passed;
};

/// Judges the last sample of a run of `steps` steps.
std::vector<Verdict> judge_run(const Parameters& parameters, const RunParameters& run, RunEnd end,
                               std::int64_t steps, const std::vector<MetricsRow>& last);

} // namespace vesica
