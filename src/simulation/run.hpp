#pragma once

#include "case/case.hpp"
#include "simulation/plan.hpp"
#include "simulation/run_loop.hpp"
#include "simulation/run_start.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <ostream>
#include <string>

namespace vesica {

struct RunOptions : EngineOptions {
    std::filesystem::path directory; ///< DIR
    bool overwrite = false;
    bool profile = false; ///< say at the end where the steps' time went
    PlanOptions plan;
    std::ostream* out = nullptr; ///< for progress and a word at the beginning and the end; null: silent
    bool terminal = false;       ///< whether `out` is one
    std::function<void()> begun; ///< called when the directory is this run's; may be empty
};

/// Exit statuses of the program, for whoever runs a case.
enum class ExitStatus { done = 0, run_failed = 1, input_wrong = 2, stopped = 3 };

struct RunOutcome {
    ExitStatus status = ExitStatus::done;
    RunEnd end = RunEnd::finished;
    std::int64_t step = 0;
    std::string message; ///< what to tell the user when it did not end well
};

/// Runs a case into DIR: case.toml, resolved.toml, log.txt, metrics.csv, fields, surfaces, checkpoints and at
/// last summary.json. Throws InputError if the case cannot serve and RunError if the
/// directory cannot; nothing is written then.
/// What goes wrong later is in the outcome, and everything written before it stays.
RunOutcome run_case(const Case& what, const RunOptions& options);

/// Continues the run in DIR from its newest intact checkpoint, bit for bit as if it had never stopped, up to
/// `steps` in total if given. Throws InputError if there is nothing to continue, RunError if
/// no checkpoint is intact.
RunOutcome resume_run(const std::optional<std::int64_t>& steps, const RunOptions& options);

} // namespace vesica
