#include "simulation/stop.hpp"

#include <fmt/format.h>

namespace vesica {

namespace {

volatile std::sig_atomic_t received_signal = 0;

extern "C" void vesica_note_signal(int signal) {
    received_signal = signal;
}

void install(int signal, int flags, struct sigaction& previous, void (*handler)(int) = vesica_note_signal) {
    struct sigaction action {};
    action.sa_handler = handler;
    // Interrupted reads and writes are taken up again: a signal must not look like a full disk.
    action.sa_flags = SA_RESTART | flags;
    sigemptyset(&action.sa_mask);
    sigaction(signal, &action, &previous);
}

} // namespace

StopSignals::StopSignals() {
    received_signal = 0;
    install(SIGINT, static_cast<int>(SA_RESETHAND), previous_interrupt_);
    install(SIGTERM, 0, previous_terminate_);
    install(SIGUSR1, 0, previous_user_);
    install(SIGXFSZ, 0, previous_limit_, SIG_IGN);
}

StopSignals::~StopSignals() {
    sigaction(SIGINT, &previous_interrupt_, nullptr);
    sigaction(SIGTERM, &previous_terminate_, nullptr);
    sigaction(SIGUSR1, &previous_user_, nullptr);
    sigaction(SIGXFSZ, &previous_limit_, nullptr);
}

std::optional<std::string> StopSignals::received() {
    switch (received_signal) {
    case 0:
        return std::nullopt;
    case SIGINT:
        return "SIGINT";
    case SIGTERM:
        return "SIGTERM";
    case SIGUSR1:
        return "SIGUSR1";
    default:
        return "a signal";
    }
}

StopRequest::StopRequest(std::optional<double> wall_time, Clock::time_point begin)
    : wall_time_(wall_time), begin_(begin) {}

std::optional<std::string> StopRequest::reason(Clock::time_point now) const {
    if (const auto signal = StopSignals::received())
        return *signal + " received";
    const double elapsed = std::chrono::duration<double>(now - begin_).count();
    if (wall_time_ && elapsed >= *wall_time_)
        return fmt::format("the wall time of {:g} s is used up", *wall_time_);
    return std::nullopt;
}

} // namespace vesica
