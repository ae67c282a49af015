#include "simulation/run_loop.hpp"

namespace vesica {

namespace {

/// Records what is due at this step; nothing if the state is broken, for nothing broken may be written.
std::optional<Trouble> record_due(const Engine& engine, const Schedule& schedule, RunObserver& observer) {
    const std::int64_t step = engine.steps_done();
    if (!schedule.anything_due(step))
        return std::nullopt;
    if (schedule.anything_to_write(step))
        if (auto trouble = engine.trouble())
            return trouble;
    for (const Event event : all_events)
        if (event != Event::trouble && schedule.due(event, step))
            observer.record(event, engine);
    return std::nullopt;
}

/// The last step has metrics and a checkpoint whether or not the schedule owes them.
void record_last(const Engine& engine, const Schedule& schedule, bool stopped, RunObserver& observer) {
    const std::int64_t step = engine.steps_done();
    if (!stopped && !schedule.due(Event::metrics, step))
        observer.record(Event::metrics, engine);
    const bool wanted = stopped || schedule.every(Event::checkpoint) > 0;
    if (wanted && !schedule.due(Event::checkpoint, step))
        observer.record(Event::checkpoint, engine);
}

} // namespace

LoopResult run_loop(Engine& engine, std::int64_t last_step, const Schedule& schedule, RunObserver& observer) {
    LoopResult result;
    std::optional<Trouble> trouble;
    if (engine.steps_done() == 0)
        trouble = record_due(engine, schedule, observer);

    while (!trouble && engine.steps_done() < last_step) {
        engine.step();
        const std::int64_t step = engine.steps_done();
        observer.progressed(step);
        trouble = record_due(engine, schedule, observer);
        if (trouble || step == last_step)
            break;
        if (schedule.due(Event::metrics, step) && observer.is_steady()) {
            result.end = RunEnd::steady;
            break;
        }
        if (const auto reason = observer.stop_reason()) {
            result.end = RunEnd::stopped;
            result.reason = *reason;
            break;
        }
    }

    result.step = engine.steps_done();
    if (!trouble)
        trouble = engine.trouble();
    if (trouble) {
        result.end = RunEnd::failed;
        result.trouble = trouble;
        return result;
    }
    record_last(engine, schedule, result.end == RunEnd::stopped, observer);
    return result;
}

} // namespace vesica
