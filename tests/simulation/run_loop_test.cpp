#include "simulation/run_fake_engine.hpp"
#include "simulation/run_loop.hpp"

#include <catch2/catch.hpp>

#include <map>

using namespace vesica;
using test::FakeEngine;

namespace {

class Notes : public RunObserver {
public:
    std::map<Event, std::vector<std::int64_t>> recorded;
    std::vector<Event> order;
    std::int64_t steps = 0;
    std::int64_t steady_from = -1;
    std::int64_t stop_from = -1;

    void record(Event event, const Engine& engine) override {
        recorded[event].push_back(engine.steps_done());
        order.push_back(event);
    }
    void progressed(std::int64_t step) override { steps = step; }
    bool is_steady() const override { return steady_from >= 0 && steps >= steady_from; }
    std::optional<std::string> stop_reason() const override {
        if (stop_from < 0 || steps < stop_from)
            return std::nullopt;
        return "asked";
    }
};

Schedule schedule() {
    OutputParameters output;
    output.metrics_every = 10;
    output.surfaces_every = 40;
    output.checkpoint_every = 20;
    return Schedule(output);
}

} // namespace

using Steps = std::vector<std::int64_t>;

TEST_CASE("a run records what is due, from step 0 to the last, and ends with metrics and a checkpoint") {
    FakeEngine engine(test::small_sphere());
    Notes notes;
    const LoopResult result = run_loop(engine, 45, schedule(), notes);
    CHECK(result.end == RunEnd::finished);
    CHECK(result.step == 45);
    CHECK(notes.recorded[Event::metrics] == Steps{0, 10, 20, 30, 40, 45});
    CHECK(notes.recorded[Event::surfaces] == Steps{0, 40});
    CHECK(notes.recorded[Event::checkpoint] == Steps{20, 40, 45});
}

TEST_CASE("nothing is recorded twice when the last step is due anyway") {
    FakeEngine engine(test::small_sphere());
    Notes notes;
    run_loop(engine, 40, schedule(), notes);
    CHECK(notes.recorded[Event::metrics] == Steps{0, 10, 20, 30, 40});
    CHECK(notes.recorded[Event::checkpoint] == Steps{20, 40});
}

TEST_CASE("the checkpoint of a step follows everything else that the step owes") {
    FakeEngine engine(test::small_sphere());
    Notes notes;
    run_loop(engine, 40, schedule(), notes);
    REQUIRE(notes.order.size() >= 3);
    CHECK(std::vector<Event>(notes.order.end() - 3, notes.order.end()) ==
          std::vector<Event>{Event::metrics, Event::surfaces, Event::checkpoint});
}

TEST_CASE("two half runs record what one whole run records") {
    FakeEngine engine(test::small_sphere());
    Notes notes;
    run_loop(engine, 40, schedule(), notes);
    run_loop(engine, 80, schedule(), notes);
    FakeEngine other(test::small_sphere());
    Notes whole;
    run_loop(other, 80, schedule(), whole);
    CHECK(notes.recorded == whole.recorded);
}

TEST_CASE("a request to stop lets the step finish and leaves a checkpoint, even if the case wants none") {
    FakeEngine engine(test::small_sphere());
    Notes notes;
    notes.stop_from = 13;
    const LoopResult result = run_loop(engine, 100, Schedule(OutputParameters{}), notes);
    CHECK(result.end == RunEnd::stopped);
    CHECK(result.step == 13);
    CHECK(result.reason == "asked");
    CHECK(notes.recorded[Event::checkpoint] == Steps{13});
    CHECK(notes.recorded[Event::metrics].empty());
}

TEST_CASE("a run whose last step is done has finished, whoever asks it to stop") {
    FakeEngine engine(test::small_sphere());
    Notes notes;
    notes.stop_from = 50;
    CHECK(run_loop(engine, 50, schedule(), notes).end == RunEnd::finished);
}

TEST_CASE("a steady run ends at the first metrics that are steady") {
    FakeEngine engine(test::small_sphere());
    Notes notes;
    notes.steady_from = 25;
    const LoopResult result = run_loop(engine, 100, schedule(), notes);
    CHECK(result.end == RunEnd::steady);
    CHECK(result.step == 30);
    CHECK(notes.recorded[Event::checkpoint] == Steps{20, 30});
}

TEST_CASE("a broken state ends the run and is not recorded") {
    FakeEngine engine(test::small_sphere());
    engine.breaks_at = 33;
    Notes notes;
    const LoopResult result = run_loop(engine, 100, schedule(), notes);
    CHECK(result.end == RunEnd::failed);
    REQUIRE(result.trouble);
    CHECK(result.step == 40);
    CHECK(notes.recorded[Event::metrics] == Steps{0, 10, 20, 30});
    CHECK(notes.recorded[Event::checkpoint] == Steps{20});
}

TEST_CASE("a state that breaks where nothing is due is found before the last record") {
    FakeEngine engine(test::small_sphere());
    engine.breaks_at = 45;
    Notes notes;
    const LoopResult result = run_loop(engine, 45, schedule(), notes);
    CHECK(result.end == RunEnd::failed);
    CHECK(notes.recorded[Event::metrics].back() == 40);
    CHECK(notes.recorded[Event::checkpoint] == Steps{20, 40});
}
