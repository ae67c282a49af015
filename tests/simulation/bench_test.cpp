#include "core/input_error.hpp"
#include "simulation/bench.hpp"
#include "simulation/run_fake_engine.hpp"

#include <catch2/catch.hpp>

#include <chrono>
#include <thread>

using namespace vesica;
using namespace vesica::test;

TEST_CASE("the rate of a case is its cells over the time of a step") {
    constexpr auto step = std::chrono::milliseconds(10);
    BenchOptions options;
    options.threads = 1;
    options.edges = {40};
    options.cases = {"crowd"};
    options.seconds = 0.01;
    options.factory = [&](const Parameters& parameters, int) {
        auto engine = std::make_unique<FakeEngine>(parameters);
        engine->after_step = [&](std::int64_t) {
            std::this_thread::sleep_for(step);
        };
        return engine;
    };
    const BenchReport report = run_bench(options);
    REQUIRE(report.cases.size() == 2);
    REQUIRE(report.limits.size() == 2);
    const double fastest = 1e-6 * 40 * 40 * 40 / 10e-3; // sleep may take longer, never less
    for (std::size_t k = 0; k < 2; ++k) {
        const BenchCase& measured = report.cases[k];
        CHECK(measured.name == "crowd");
        CHECK(measured.mlups <= fastest);
        CHECK(measured.mlups > 0.6 * fastest);
        const BenchLimit& limit = report.limits[k];
        CHECK(limit.streaming_mlups == measured.streaming_mlups);
        CHECK(limit.bandwidth_mlups == measured.bandwidth_mlups);
        const double bytes = k == 0 ? 8.0 : 4.0;
        CHECK(limit.bandwidth == Approx(1e6 * limit.bandwidth_mlups * 38.0 * bytes));
        // Streaming moves what the bandwidth counts; small boxes lie in caches, but no pass is many times the
        // other.
        CHECK(limit.streaming_mlups > 0.1 * limit.bandwidth_mlups);
        CHECK(limit.streaming_mlups < 10.0 * limit.bandwidth_mlups);
    }
}

TEST_CASE("a case of bench that nobody knows is refused") {
    BenchOptions options;
    options.cases = {"fluid", "drop"};
    CHECK_THROWS_WITH(run_bench(options), Catch::Contains("drop") && Catch::Contains("discocyte"));
}

TEST_CASE("spheres are measured by name only, in as many colours as are asked for") {
    BenchOptions options;
    options.threads = 1;
    options.edges = {96};
    options.seconds = 1e-3;
    std::vector<int> colours;
    std::vector<std::size_t> spheres;
    options.factory = [&](const Parameters& parameters, int) {
        colours.push_back(parameters.labels().empty() ? 0 : parameters.labels().back() + 1);
        spheres.push_back(parameters.vesicles.size());
        return std::make_unique<FakeEngine>(parameters);
    };
    options.cases = {"spheres"};
    for (const int wanted : {0, 1, 4, 100}) {
        options.colours = wanted;
        run_bench(options);
    }
    CHECK(colours == std::vector<int>{27, 27, 1, 1, 4, 4, 27, 27});
    CHECK(spheres == std::vector<std::size_t>(8, 27));
}
