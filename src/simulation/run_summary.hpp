#pragma once

#include "case/case.hpp"
#include "simulation/run_loop.hpp"
#include "simulation/run_verdicts.hpp"

#include <string>

namespace vesica {

/// Where a run's time went, seconds of wall time of this process.
struct RunTimings {
    double total = 0.0;
    double setting_up = 0.0;
    double stepping = 0.0;
    double recording = 0.0;
    std::int64_t steps = 0; ///< done in `stepping`
    double cells = 0.0;

    /// Million lattice updates per second of stepping; 0 if nothing was stepped.
    double mlups() const;
};

/// How it was run, for whoever wants to run it again.
struct RunCircumstances {
    int threads = 1;
    std::string instruction_set;
    std::size_t bytes_allocated = 0;
    double interface_fraction = 0.0;
};

/// The text of summary.json. Numbers that are not numbers become null.
std::string summary_json(const Case& what, const LoopResult& result, int exit_status,
                         const std::vector<Verdict>& verdicts, const RunTimings& timings,
                         const RunCircumstances& circumstances, const std::vector<MetricsRow>& last);

} // namespace vesica
