#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <ostream>
#include <string>

namespace vesica {

/// A duration as people say it: "45 s", "3 min 20 s", "2 h 05 min", "3 d 4 h".
std::string duration_text(double seconds);

/// How a run shows that it is alive: one live line on a terminal, otherwise one plain line every so often.
/// Never a line per step.
class Progress {
public:
    using Clock = std::chrono::steady_clock;

    struct Settings {
        std::int64_t first_step = 0;
        std::int64_t last_step = 0;
        double cells = 0.0;                     ///< for the million lattice updates per second
        std::optional<double> seconds_per_step; ///< physical seconds, when the case has units
        bool terminal = false;
    };

    /// Nothing is written when `out` is null.
    Progress(const Settings& settings, std::ostream* out, Clock::time_point begin);

    /// Call after every step; writes only when it is time to.
    void update(std::int64_t step, Clock::time_point now = Clock::now());

    /// Ends the live line, so that what follows starts on a line of its own.
    void finish();

private:
    std::string live_line(std::int64_t step, Clock::time_point now) const;
    std::string plain_line(std::int64_t step, Clock::time_point now) const;
    double steps_per_second(std::int64_t step, Clock::time_point now) const;
    std::string rate_and_rest(std::int64_t step, Clock::time_point now) const;

    Settings settings_;
    std::ostream* out_;
    Clock::time_point begin_;
    Clock::time_point last_written_;
    Clock::time_point window_begin_;
    std::int64_t window_step_ = 0;
    std::size_t live_width_ = 0;
};

} // namespace vesica
