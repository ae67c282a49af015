#include "simulation/progress.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <sstream>

using namespace vesica;
using namespace std::chrono_literals;

namespace {

Progress::Settings settings(bool terminal) {
    Progress::Settings settings;
    settings.last_step = 1000;
    settings.cells = 1e6;
    settings.terminal = terminal;
    return settings;
}

} // namespace

TEST_CASE("durations are written as people say them") {
    CHECK(duration_text(0.25) == "0.2 s");
    CHECK(duration_text(45.0) == "45 s");
    CHECK(duration_text(200.0) == "3 min 20 s");
    CHECK(duration_text(59.7) == "1 min 00 s");
    CHECK(duration_text(7500.0) == "2 h 05 min");
    CHECK(duration_text(3.0 * 86400 + 4 * 3600) == "3 d 4 h");
    CHECK(duration_text(1.0 / 0.0) == "?");
}

TEST_CASE("without a terminal there is a plain line every half minute, whatever the number of steps") {
    std::ostringstream out;
    const Progress::Clock::time_point begin{};
    Progress progress(settings(false), &out, begin);
    for (int step = 1; step <= 1000; ++step)
        progress.update(step, begin + step * 100ms);
    const std::string text = out.str();
    CHECK(std::count(text.begin(), text.end(), '\n') == 3);
    CHECK(text.find('\r') == std::string::npos);
    CHECK(text.find("step 300 of 1000, 10.00 MLUPS, 1 min 10 s left\n") == 0);
}

TEST_CASE("on a terminal there is one line that rewrites itself and vanishes at the end") {
    std::ostringstream out;
    const Progress::Clock::time_point begin{};
    Progress::Settings live = settings(true);
    live.seconds_per_step = 1e-6;
    Progress progress(live, &out, begin);
    for (int step = 1; step <= 500; ++step)
        progress.update(step, begin + step * 10ms);
    const std::string text = out.str();
    CHECK(std::count(text.begin(), text.end(), '\n') == 0);
    CHECK(std::count(text.begin(), text.end(), '\r') == 25);
    CHECK(text.rfind(
              "[============>           ]  50 %  step 500/1000  time 0.0005 s  100.00 MLUPS, 5.0 s left") !=
          std::string::npos);
    progress.finish();
    CHECK(out.str().back() == '\r');
}

TEST_CASE("progress without a stream is silent") {
    Progress progress(settings(true), nullptr, {});
    progress.update(1000, Progress::Clock::now());
    progress.finish();
}
