#pragma once

#include "case/parameters.hpp"

#include <array>
#include <cstdint>
#include <optional>

namespace vesica {

/// What may fall due at a step, in the order in which it is done: the checkpoint comes last, so that whatever
/// a checkpoint's step owes to the output is on disk before the checkpoint is.
enum class Event { trouble, sample, metrics, fields, surfaces, profiles, tracers, carry, checkpoint };

inline constexpr std::array<Event, 9> all_events = {Event::trouble, Event::sample,   Event::metrics,
                                                    Event::fields,  Event::surfaces, Event::profiles,
                                                    Event::tracers, Event::carry,    Event::checkpoint};

/// When each event falls due: every so many steps, counted from step 0 whatever step a run starts from, so
/// that two half runs do the same as one whole run.
class Schedule {
public:
    /// `tracers` writes them, and `carry` moves them on, of which nothing is written.
    /// `sample` collects time averages of fields; it falls due only if the case asks for averages.
    explicit Schedule(const OutputParameters& output);

    /// Every event but `checkpoint` may fall due at step 0: there is nothing in a checkpoint of the initial
    /// state that the case does not say.
    bool due(Event event, std::int64_t step) const;
    bool anything_due(std::int64_t step) const;
    /// Something that is written, or looked at for that.
    bool anything_to_write(std::int64_t step) const;

    /// Steps between two occurrences; 0 is never, and for `carry`, which has no period.
    std::int64_t every(Event event) const;

private:
    std::array<std::int64_t, all_events.size()> every_{};
    std::optional<TracerOutput> tracers_;
};

} // namespace vesica
