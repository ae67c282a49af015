#include "simulation/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vesica {

namespace {

using namespace std::chrono_literals;

constexpr auto between_live_lines = 200ms;
constexpr auto between_plain_lines = 30s;
/// Speed is that of the last half minute or so: fast enough to follow a change, slow enough not to flicker.
constexpr auto speed_window = 30s;

double seconds(Progress::Clock::duration duration) {
    return std::chrono::duration<double>(duration).count();
}

std::string bar(double fraction) {
    constexpr int width = 24;
    const int filled = static_cast<int>(std::clamp(fraction, 0.0, 1.0) * width);
    std::string text(static_cast<std::size_t>(filled), '=');
    if (filled < width)
        text += '>';
    text.resize(width, ' ');
    return "[" + text + "]";
}

} // namespace

std::string duration_text(double seconds) {
    if (!std::isfinite(seconds) || seconds < 0.0)
        return "?";
    if (seconds < 9.95)
        return fmt::format("{:.1f} s", seconds);
    const auto whole = static_cast<std::int64_t>(std::llround(seconds));
    if (whole < 60)
        return fmt::format("{} s", whole);
    if (whole < 3600)
        return fmt::format("{} min {:02} s", whole / 60, whole % 60);
    if (whole < 86400)
        return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
    return fmt::format("{} d {} h", whole / 86400, whole % 86400 / 3600);
}

Progress::Progress(const Settings& settings, std::ostream* out, Clock::time_point begin)
    : settings_(settings),
      out_(out),
      begin_(begin),
      last_written_(begin),
      window_begin_(begin),
      window_step_(settings.first_step) {}

double Progress::steps_per_second(std::int64_t step, Clock::time_point now) const {
    const double elapsed = seconds(now - window_begin_);
    return elapsed > 0.0 ? static_cast<double>(step - window_step_) / elapsed : 0.0;
}

std::string Progress::rate_and_rest(std::int64_t step, Clock::time_point now) const {
    const double speed = steps_per_second(step, now);
    const double rest = static_cast<double>(settings_.last_step - step);
    const std::string left = speed > 0.0 ? duration_text(rest / speed) : "?";
    return fmt::format("{:.2f} MLUPS, {} left", 1e-6 * speed * settings_.cells, left);
}

std::string Progress::live_line(std::int64_t step, Clock::time_point now) const {
    const double fraction =
        settings_.last_step > 0 ? static_cast<double>(step) / static_cast<double>(settings_.last_step) : 1.0;
    std::string time = fmt::format("time {}", step);
    if (settings_.seconds_per_step)
        time = fmt::format("time {:.4g} s", static_cast<double>(step) * *settings_.seconds_per_step);
    return fmt::format("{} {:3.0f} %  step {}/{}  {}  {}", bar(fraction), std::floor(100.0 * fraction), step,
                       settings_.last_step, time, rate_and_rest(step, now));
}

std::string Progress::plain_line(std::int64_t step, Clock::time_point now) const {
    std::string time;
    if (settings_.seconds_per_step)
        time = fmt::format(", time {:.4g} s", static_cast<double>(step) * *settings_.seconds_per_step);
    return fmt::format("step {} of {}{}, {}", step, settings_.last_step, time, rate_and_rest(step, now));
}

void Progress::update(std::int64_t step, Clock::time_point now) {
    if (out_ == nullptr)
        return;
    const Clock::duration interval =
        settings_.terminal ? Clock::duration(between_live_lines) : between_plain_lines;
    if (now - last_written_ < interval)
        return;
    if (settings_.terminal) {
        std::string line = live_line(step, now);
        const std::size_t width = line.size();
        if (width < live_width_)
            line.resize(live_width_, ' ');
        live_width_ = width;
        *out_ << '\r' << line << std::flush;
    } else {
        *out_ << plain_line(step, now) << std::endl;
    }
    last_written_ = now;
    if (now - window_begin_ > speed_window) {
        window_begin_ = now;
        window_step_ = step;
    }
}

void Progress::finish() {
    if (out_ != nullptr && live_width_ > 0)
        *out_ << '\r' << std::string(live_width_, ' ') << '\r' << std::flush;
    live_width_ = 0;
}

} // namespace vesica
