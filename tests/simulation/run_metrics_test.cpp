#include "core/input_error.hpp"
#include "simulation/run_fake_engine.hpp"
#include "simulation/run_metrics.hpp"

#include <catch2/catch.hpp>

using namespace vesica;

namespace {

Snapshot sphere_at(const Vec3<double>& centre, std::int64_t step, double radius = 8.0) {
    Parameters parameters = test::small_sphere();
    parameters.vesicles[0].centre = centre;
    parameters.vesicles[0].radius = radius;
    Snapshot snapshot = test::FakeEngine(parameters).snapshot();
    snapshot.step = step;
    return snapshot;
}

RunParameters until_steady(double relative_change, std::int64_t over) {
    RunParameters run;
    run.steps = 1000000;
    run.stop_when_steady = SteadyCriterion{"area", relative_change, over};
    return run;
}

} // namespace

TEST_CASE("a centre goes on without a jump where the box ends") {
    RunMetrics metrics(test::small_sphere(), {}, 10, sphere_at({16, 16, 16}, 0));
    double last = 16.0;
    metrics.sample(sphere_at({16, 16, 16}, 0));
    for (int step = 1; step <= 12; ++step) {
        const double x = 16.0 + 4.0 * step;
        // the engine reports one image or the other
        metrics.sample(sphere_at({x - 32.0 * (step / 5), 16, 16}, 10 * step));
        CHECK(metrics.last()[0].x - last == Approx(4.0).margin(0.02));
        last = metrics.last()[0].x;
    }
}

TEST_CASE("steady is what has not changed for as long as asked, not what has not changed once") {
    RunMetrics metrics(test::small_sphere(), until_steady(1e-3, 100), 50, sphere_at({16, 16, 16}, 0));
    const auto sample = [&](std::int64_t step, double radius) {
        metrics.sample(sphere_at({16, 16, 16}, step, radius));
        return metrics.is_steady();
    };
    CHECK_FALSE(sample(0, 8.0));
    CHECK_FALSE(sample(50, 8.0));
    CHECK(sample(100, 8.0));
    CHECK_FALSE(sample(150, 8.1));
    CHECK_FALSE(sample(200, 8.0)); // as before, but not steadily
    CHECK_FALSE(sample(250, 8.0)); // the window still holds the step 150
    CHECK(sample(300, 8.0));
}

TEST_CASE("nothing is steady while the target area still moves") {
    Parameters parameters = test::small_sphere();
    parameters.types[0].area.deflation = 1.2;
    parameters.types[0].area.ramp = 1000;
    RunMetrics metrics(parameters, until_steady(1e-3, 100), 50, sphere_at({16, 16, 16}, 0));
    for (std::int64_t step = 0; step <= 1050; step += 50) {
        metrics.sample(sphere_at({16, 16, 16}, step));
        CHECK_FALSE(metrics.is_steady());
    }
    metrics.sample(sphere_at({16, 16, 16}, 1100));
    CHECK(metrics.is_steady());
}

TEST_CASE("what is remembered survives a checkpoint") {
    const Snapshot initial = sphere_at({16, 16, 16}, 0);
    RunMetrics whole(test::small_sphere(), until_steady(1e-3, 100), 50, initial);
    whole.sample(initial);
    whole.sample(sphere_at({28, 16, 16}, 50));

    // begun from another state, as a resumed run's engine is before its checkpoint is loaded
    RunMetrics resumed(test::small_sphere(), until_steady(1e-3, 100), 50, sphere_at({16, 16, 16}, 0, 7.0));
    resumed.restore(whole.notes());
    resumed.sample(sphere_at({28, 16, 16}, 50)); // looked at again: nothing new
    CHECK((resumed.notes() == whole.notes()));
    const Snapshot next = sphere_at({8, 16, 16}, 100);
    whole.sample(next);
    resumed.sample(next);
    CHECK(metrics_values(resumed.last()[0]).size() == metrics_values(whole.last()[0]).size());
    CHECK(resumed.last()[0].x == whole.last()[0].x);
    CHECK(resumed.last()[0].x == Approx(40.0).margin(0.02));
    CHECK(resumed.last()[0].mass_drift == whole.last()[0].mass_drift);
    CHECK(resumed.last()[0].deformation_index == whole.last()[0].deformation_index);
    CHECK(resumed.is_steady() == whole.is_steady());
    CHECK(resumed.is_steady());
}

TEST_CASE("the memory of another case is refused") {
    RunMetrics metrics(test::small_sphere(), {}, 10, sphere_at({16, 16, 16}, 0));
    CHECK_THROWS_AS(metrics.restore({}), RunError);
    CHECK_THROWS_AS(metrics.restore({{"colour_mass", {1.0, 2.0}}, {"diameter", {1.0, 2.0}}}), RunError);
}
