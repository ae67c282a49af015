#include "simulation/schedule.hpp"

#include <catch2/catch.hpp>

#include <vector>

using namespace vesica;

namespace {

OutputParameters output() {
    OutputParameters output;
    output.metrics_every = 20;
    output.surfaces_every = 50;
    output.checkpoint_every = 70;
    return output;
}

} // namespace

TEST_CASE("an event falls due at every multiple of its period and at no other step") {
    const Schedule schedule(output());
    for (std::int64_t step = 1; step <= 200; ++step) {
        REQUIRE(schedule.due(Event::metrics, step) == (step % 20 == 0));
        REQUIRE(schedule.due(Event::surfaces, step) == (step % 50 == 0));
        REQUIRE(schedule.due(Event::checkpoint, step) == (step % 70 == 0));
    }
}

TEST_CASE("the initial state is recorded but not checkpointed") {
    const Schedule schedule(output());
    CHECK(schedule.due(Event::metrics, 0));
    CHECK(schedule.due(Event::surfaces, 0));
    CHECK_FALSE(schedule.due(Event::checkpoint, 0));
}

TEST_CASE("what the case does not ask for never falls due") {
    const Schedule schedule(OutputParameters{});
    for (std::int64_t step = 0; step < 1000; ++step)
        for (const Event event : all_events) {
            if (event == Event::trouble)
                continue;
            REQUIRE_FALSE(schedule.due(event, step));
        }
}

TEST_CASE("tracers are carried ten steps at a time, and less to a row or a release") {
    OutputParameters traced;
    traced.tracers = TracerOutput{35, 7, 50, 0, {}};
    const Schedule schedule(traced);
    std::vector<std::int64_t> steps;
    for (std::int64_t step = 0; step <= 60; ++step)
        if (schedule.due(Event::carry, step))
            steps.push_back(step);
    CHECK(steps == std::vector<std::int64_t>{0, 7, 10, 20, 30, 35, 40, 50, 57, 60});
    CHECK(schedule.due(Event::tracers, 35));
    CHECK_FALSE(schedule.anything_to_write(57));
}

TEST_CASE("trouble is looked for whatever the case asks for") {
    const Schedule schedule(OutputParameters{});
    CHECK(schedule.due(Event::trouble, 100));
    CHECK(schedule.anything_due(100));
    CHECK_FALSE(schedule.anything_due(101));
}

TEST_CASE("samples for an average fall due between two outputs of fields, and at the outputs") {
    OutputParameters averaged;
    averaged.fields = FieldOutput{};
    averaged.fields->every = 1000;
    CHECK_FALSE(Schedule(averaged).due(Event::sample, 1000));
    averaged.fields->average = true;
    const Schedule schedule(averaged);
    CHECK(schedule.due(Event::sample, 20));
    CHECK(schedule.due(Event::sample, 1000));
    CHECK_FALSE(schedule.due(Event::fields, 20));

    averaged.fields->every = 7;
    CHECK(Schedule(averaged).every(Event::sample) == 1);
}
