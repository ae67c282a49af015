#pragma once

#include "case/parameters.hpp"
#include "parallel/ranks.hpp"
#include "simulation/engine.hpp"
#include "simulation/plan_output.hpp"

#include <cstdint>
#include <functional>
#include <memory>

namespace vesica {

/// How to build an engine; a test's double or make_engine.
using EngineFactory = std::function<std::unique_ptr<Engine>(const Parameters& parameters, int threads)>;

/// What a run will cost on this machine.
struct RunCost {
    double seconds_per_step = 0.0;
    double bytes = 0.0; ///< of memory
    OutputCost output;
    bool of_this_case = false; ///< measured on the case itself, not on a small box and scaled
};

/// Takes a few steps: of the case itself if that is quick, otherwise of one sphere in two small boxes, from
/// which the cost of a cell and of a cell in a membrane's layer follow.
RunCost measure_cost(const Parameters& parameters, const RunParameters& run, const OutputParameters& output,
                     int threads, const EngineFactory& factory);

/// Memory that this process may still take: the machine's available one or its control group's limit.
/// 0 if unknown.
double available_memory();

/// The number of threads a run takes if nobody says otherwise: OMP_NUM_THREADS, or the processors at hand.
int default_threads();
/// The same for each of several ranks, which may share a machine's processors.
int default_threads(const Ranks& ranks);

} // namespace vesica
