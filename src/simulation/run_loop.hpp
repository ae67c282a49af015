#pragma once

#include "simulation/engine.hpp"
#include "simulation/schedule.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace vesica {

/// How a run came to its end.
enum class RunEnd {
    finished, ///< the last step is done
    steady,   ///< the case's criterion for a steady state is met
    stopped,  ///< on request, with a checkpoint written
    failed,   ///< NaN or runaway values
};

struct LoopResult {
    RunEnd end = RunEnd::finished;
    std::int64_t step = 0;          ///< steps done
    std::string reason;             ///< why it stopped
    std::optional<Trouble> trouble; ///< why it failed
};

/// What a run does besides stepping. The loop decides when, the observer how.
class RunObserver {
public:
    RunObserver() = default;
    RunObserver(const RunObserver&) = delete;
    RunObserver& operator=(const RunObserver&) = delete;
    virtual ~RunObserver() = default;

    /// Something is due: write it. Never called with a broken state, nor for Event::trouble.
    virtual void record(Event event, const Engine& engine) = 0;

    /// A step is done.
    virtual void progressed(std::int64_t step) = 0;

    /// Asked after every record of the metrics.
    virtual bool is_steady() const = 0;

    /// Asked after every step: words for why the run should stop now, if it should.
    virtual std::optional<std::string> stop_reason() const = 0;
};

/// Steps `engine` until `last_step`, a steady state, a request to stop or trouble, and lets `observer` record
/// what `schedule` says. A run from step 0 records what is due there first; a resumed one has done so before.
/// When it ends well, the last step has its metrics, and its checkpoint if the case wants checkpoints; when
/// it is stopped, it has a checkpoint whatever the case wants.
LoopResult run_loop(Engine& engine, std::int64_t last_step, const Schedule& schedule, RunObserver& observer);

} // namespace vesica
