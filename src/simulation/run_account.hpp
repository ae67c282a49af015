#pragma once

#include "case/case.hpp"
#include "io/run_summary.hpp"
#include "measure/metrics.hpp"
#include "simulation/plan.hpp"
#include "simulation/run_loop.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace vesica {

/// Where a run's time went, in seconds of wall time of this process, and how it was run.
struct RunAccount {
    double total = 0.0;
    double setting_up = 0.0;
    double stepping = 0.0;
    double recording = 0.0;
    std::int64_t first_step = 0;
    int threads = 1;
    std::string instruction_set;
    double bytes_allocated = 0.0;
    double interface_fraction = 0.0;
    OutputSummary output;
    StepProfile profile; ///< of the rank that leads
    ParallelSummary parallel;

    /// Million lattice updates per second of stepping; 0 if nothing was stepped.
    double mlups(double cells, std::int64_t last_step) const;

    /// All there is to say of a run at its end.
    RunSummary summary(const Case& what, const Plan& plan, const LoopResult& result,
                       const std::vector<MetricsRow>& last) const;
};

/// Why a run failed, for the user: step, place, vesicle, what was found and what it is likely to come from.
std::string failure_text(const Case& what, const Plan& plan, const LoopResult& result);

} // namespace vesica
