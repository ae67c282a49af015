#include "simulation/schedule.hpp"

#include <algorithm>
#include <cassert>

namespace vesica {

namespace {

/// A runaway doubles within some tens of steps once it has begun; looking more often costs time, looking less
/// often loses the place where it began.
constexpr std::int64_t steps_between_trouble_checks = 100;

/// Samples of a time average: enough for its statistical error to be that of the flow, few enough to be
/// cheap.
constexpr std::int64_t samples_per_average = 50;

} // namespace

Schedule::Schedule(const OutputParameters& output) {
    const auto set = [this](Event event, std::int64_t every) {
        assert(every >= 0);
        every_[static_cast<std::size_t>(event)] = every;
    };
    set(Event::trouble, steps_between_trouble_checks);
    set(Event::metrics, output.metrics_every);
    set(Event::surfaces, output.surfaces_every);
    set(Event::checkpoint, output.checkpoint_every);
    if (output.profiles)
        set(Event::profiles, output.profiles->every);
    tracers_ = output.tracers;
    if (tracers_)
        set(Event::tracers, tracers_->every);
    if (output.fields) {
        set(Event::fields, output.fields->every);
        if (output.fields->average)
            set(Event::sample, std::max<std::int64_t>(1, output.fields->every / samples_per_average));
    }
}

std::int64_t Schedule::every(Event event) const {
    return every_[static_cast<std::size_t>(event)];
}

bool Schedule::due(Event event, std::int64_t step) const {
    if (event == Event::carry)
        return tracers_ && tracers_->carried_at(step);
    const std::int64_t period = every(event);
    if (period == 0 || (step == 0 && event == Event::checkpoint))
        return false;
    return step % period == 0;
}

bool Schedule::anything_to_write(std::int64_t step) const {
    return std::any_of(all_events.begin(), all_events.end(),
                       [&](Event event) { return event != Event::carry && due(event, step); });
}

bool Schedule::anything_due(std::int64_t step) const {
    return std::any_of(all_events.begin(), all_events.end(), [&](Event event) { return due(event, step); });
}

} // namespace vesica
