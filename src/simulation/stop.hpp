#pragma once

#include <chrono>
#include <csignal>
#include <optional>
#include <string>

namespace vesica {

/// While it lives, SIGINT, SIGTERM and SIGUSR1 ask the run to stop at the end of the step instead of ending
/// the process. The second SIGINT finds the default action again and ends it at once. A limit on the size of
/// files (SIGXFSZ) becomes an error of the write that meets it. Restores the previous actions when it goes.
/// One at a time.
class StopSignals {
public:
    StopSignals();
    ~StopSignals();
    StopSignals(const StopSignals&) = delete;
    StopSignals& operator=(const StopSignals&) = delete;

    /// The name of the signal received, if any.
    static std::optional<std::string> received();

private:
    struct sigaction previous_interrupt_ {};
    struct sigaction previous_terminate_ {};
    struct sigaction previous_user_ {};
    struct sigaction previous_limit_ {};
};

/// Everything that may ask a run to stop early: a signal, or the end of its wall time.
class StopRequest {
public:
    using Clock = std::chrono::steady_clock;

    /// `wall_time` in seconds, counted from `begin`.
    StopRequest(std::optional<double> wall_time, Clock::time_point begin);

    /// Why to stop, in words for the log; nothing while the run may go on.
    std::optional<std::string> reason(Clock::time_point now = Clock::now()) const;

private:
    std::optional<double> wall_time_;
    Clock::time_point begin_;
};

} // namespace vesica
