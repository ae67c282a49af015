#include "simulation/step_profile.hpp"

#include <catch2/catch.hpp>

using namespace vesica;

namespace {

/// Shows what it is told to.
struct HandClock {
    using duration = std::chrono::milliseconds;
    using time_point = std::chrono::time_point<HandClock, duration>;

    static inline duration shown{0};
    static time_point now() { return time_point(shown); }
    static void pass(int milliseconds) { shown += duration(milliseconds); }
};

} // namespace

TEST_CASE("time is charged to the part that was entered last, and to none between steps") {
    BasicStepClock<HandClock> clock;
    clock.enter(StepPart::slopes); // set-up uses the same passes
    HandClock::pass(500);
    for (int step = 0; step < 2; ++step) {
        clock.begin(StepPart::fluid);
        HandClock::pass(2);
        clock.enter(StepPart::normals);
        HandClock::pass(6);
        clock.leave(1000.0, 100.0);
        HandClock::pass(40);
    }
    const StepProfile& profile = clock.profile();
    CHECK(profile.steps == 2);
    CHECK(profile.of(StepPart::fluid) == Approx(4e-3));
    CHECK(profile.of(StepPart::normals) == Approx(12e-3));
    CHECK(profile.of(StepPart::slopes) == 0.0);
    CHECK(profile.total() == Approx(16e-3));
}

TEST_CASE("costs are those of one core, and of the cells that were worked on") {
    StepProfile profile;
    profile.steps = 10;
    profile.cells = 10 * 1e6;
    profile.interface_cells = 10 * 1e4;
    profile.seconds[static_cast<std::size_t>(StepPart::fluid)] = 0.2;
    profile.seconds[static_cast<std::size_t>(StepPart::locate)] = 0.01;
    profile.seconds[static_cast<std::size_t>(StepPart::forces)] = 0.03;
    CHECK(profile.per_cell(2) == Approx(40.0));
    CHECK(profile.per_interface_cell(2) == Approx(800.0));
    const auto numbers = profile.numbers(2);
    CHECK(numbers.at("seconds_forces") == 0.03);
    CHECK(numbers.at("interface_cells_per_step") == 1e4);
    const std::string text = profile.text(2);
    CHECK(text.find("a cell costs 40.0 ns, one of the interface (1.0 % of all) 800.0 ns more") !=
          std::string::npos);
    for (std::size_t k = 0; k < step_part_count; ++k)
        CHECK(text.find(name_of(static_cast<StepPart>(k))) != std::string::npos);
}

TEST_CASE("a run without steps has no costs, and none that are not numbers") {
    CHECK(StepProfile{}.text(1).find("no steps") != std::string::npos);
    for (const auto& [name, value] : StepProfile{}.numbers(4))
        CHECK(value == 0.0);
}
