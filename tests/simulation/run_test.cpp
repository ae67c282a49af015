#include "core/input_error.hpp"
#include "io/case_file.hpp"
#include "io/checkpoint_store.hpp"
#include "io/metrics_table.hpp"
#include "io/scratch_directory.hpp"
#include "simulation/run.hpp"
#include "simulation/run_fake_engine.hpp"

#include <catch2/catch.hpp>
#include <hdf5.h>
#include <nlohmann/json.hpp>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>

using namespace vesica;
using test::FakeEngine;
namespace fs = std::filesystem;

namespace {

const char* const small_case = R"(title = "small"
[lattice]
size = [32, 32, 32]
[fluid]
kinematic_viscosity = 0.1666667
[vesicle_type.rbc]
[vesicle_type.rbc.bending]
modulus = 0.25
[[vesicle]]
type = "rbc"
shape = "sphere"
centre = [16, 16, 16]
radius = 8
[run]
steps = 60
[output]
metrics = { every = 10 }
fields = { every = 30, names = ["phase", "velocity"] }
surfaces = { every = 20 }
checkpoint = { every = 25, keep = 2 }
)";

Case a_case(const std::vector<std::string>& overrides = {}) {
    return read_case_text(small_case, "small.toml", overrides);
}

RunOptions into(const fs::path& directory, std::function<void(FakeEngine&)> prepare = {}) {
    RunOptions options;
    options.directory = directory;
    options.threads = 1;
    options.factory = [prepare](const Parameters& parameters, int) -> std::unique_ptr<Engine> {
        auto engine = std::make_unique<FakeEngine>(parameters);
        if (prepare)
            prepare(*engine);
        return engine;
    };
    return options;
}

std::string content(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

std::vector<double> metrics_steps(const fs::path& directory) {
    std::vector<double> steps;
    for (const auto& row : read_metrics(directory / "metrics.csv").rows)
        steps.push_back(row[0]);
    return steps;
}

float first_value(const fs::path& path, const char* name) {
    const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    REQUIRE(file >= 0);
    const hid_t dataset = H5Dopen2(file, name, H5P_DEFAULT);
    const hid_t space = H5Dget_space(dataset);
    std::vector<float> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
    H5Dread(dataset, H5T_NATIVE_FLOAT, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    H5Sclose(space);
    H5Dclose(dataset);
    H5Fclose(file);
    return values.at(0);
}

nlohmann::json summary(const fs::path& directory) {
    return nlohmann::json::parse(content(directory / "summary.json"));
}

} // namespace

TEST_CASE("a run leaves everything the case asks for") {
    const ScratchDirectory scratch;
    const fs::path directory = scratch / "out";
    const RunOutcome outcome = run_case(a_case(), into(directory));
    CHECK(outcome.status == ExitStatus::done);
    CHECK(outcome.message.empty());
    CHECK(content(directory / "case.toml") == small_case);
    CHECK(read_case(directory / "resolved.toml").parameters.size == Vec3<int>{32, 32, 32});
    CHECK(metrics_steps(directory) == std::vector<double>{0, 10, 20, 30, 40, 50, 60});
    for (const char* name : {"fields.xmf", "fields.h5", "fields/step_000000030.h5", "surfaces/surfaces.pvd",
                             "surfaces/surface_000000060.vtp", "checkpoints/step_000000050.h5",
                             "checkpoints/step_000000060.h5", "log.txt"})
        CHECK(fs::exists(directory / name));
    CHECK_FALSE(fs::exists(directory / "checkpoints/step_000000025.h5")); // keep = 2
    const auto json = summary(directory);
    CHECK(json["end"] == "finished");
    CHECK(json["last_step"] == 60);
    CHECK(json["last_metrics"][0]["step"] == 60);
}

TEST_CASE("a directory that holds something is refused and left alone, unless it may be overwritten") {
    const ScratchDirectory scratch;
    const fs::path directory = scratch / "out";
    fs::create_directory(directory);
    std::ofstream(directory / "notes.txt") << "mine";
    CHECK_THROWS_AS(run_case(a_case(), into(directory)), RunError);
    CHECK_FALSE(fs::exists(directory / "case.toml"));
    RunOptions overwrite = into(directory);
    overwrite.overwrite = true;
    CHECK(run_case(a_case(), overwrite).status == ExitStatus::done);
    CHECK(content(directory / "notes.txt") == "mine");
}

TEST_CASE("a case that the plan refuses touches no directory") {
    const ScratchDirectory scratch;
    CHECK_THROWS_AS(run_case(a_case({"vesicle_type.rbc.bending.modulus=0.001"}), into(scratch / "out")),
                    InputError);
    CHECK_FALSE(fs::exists(scratch / "out"));
}

TEST_CASE("trouble ends the run with its step, place, vesicle and cause, and what was written stays") {
    const ScratchDirectory scratch;
    const fs::path directory = scratch / "out";
    const RunOutcome outcome =
        run_case(a_case(), into(directory, [](FakeEngine& engine) { engine.breaks_at = 37; }));
    CHECK(outcome.status == ExitStatus::run_failed);
    for (const char* part : {"step 40", "cell (1, 2, 3)", "vesicle[0]", "speed 0.91", "likely cause: "})
        CHECK_THAT(outcome.message, Catch::Contains(part));
    CHECK(metrics_steps(directory) == std::vector<double>{0, 10, 20, 30});
    CHECK(fs::exists(directory / "checkpoints/step_000000025.h5"));
    const auto json = summary(directory);
    CHECK(json["end"] == "failed");
    CHECK(json["last_metrics"][0]["step"] == 30);
}

TEST_CASE("a signal stops the run after the step with a checkpoint, and it can be resumed to the same end") {
    const ScratchDirectory scratch;
    const fs::path halves = scratch / "halves";
    const fs::path whole = scratch / "whole";
    const auto stop_at_33 = [](FakeEngine& engine) {
        engine.after_step = [](std::int64_t step) {
            if (step == 33)
                std::raise(SIGTERM);
        };
    };
    const RunOutcome stopped = run_case(a_case(), into(halves, stop_at_33));
    CHECK(stopped.status == ExitStatus::stopped);
    CHECK(stopped.step == 33);
    CHECK_THAT(stopped.message, Catch::Contains("SIGTERM"));
    CHECK(fs::exists(halves / "checkpoints/step_000000033.h5"));
    CHECK(summary(halves)["end"] == "stopped");

    const RunOutcome resumed = resume_run(std::nullopt, into(halves));
    CHECK(resumed.status == ExitStatus::done);
    CHECK(resumed.step == 60);
    run_case(a_case(), into(whole));
    CHECK(content(halves / "metrics.csv") == content(whole / "metrics.csv"));
    CHECK(content(halves / "surfaces/surfaces.pvd") == content(whole / "surfaces/surfaces.pvd"));
    CHECK(content(halves / "fields.xmf") == content(whole / "fields.xmf"));
}

TEST_CASE("a finished run can be made longer, and reads as if it had always been") {
    const ScratchDirectory scratch;
    const fs::path twice = scratch / "twice";
    const fs::path once = scratch / "once";
    run_case(a_case({"run.steps=45"}), into(twice));
    CHECK(metrics_steps(twice).back() == 45);
    CHECK(resume_run(60, into(twice)).step == 60);
    run_case(a_case(), into(once));
    CHECK(content(twice / "metrics.csv") == content(once / "metrics.csv"));
}

TEST_CASE("a resumed run keeps what the command line changed") {
    const ScratchDirectory scratch;
    const fs::path directory = scratch / "out";
    run_case(a_case({"vesicle_type.rbc.bending.modulus=0.5", "run.steps=30"}), into(directory));
    double modulus = 0.0;
    RunOptions options = into(directory);
    options.factory = [&](const Parameters& parameters, int) -> std::unique_ptr<Engine> {
        modulus = parameters.types[0].bending.modulus;
        return std::make_unique<FakeEngine>(parameters);
    };
    resume_run(40, options);
    CHECK(modulus == 0.5);
}

TEST_CASE("a damaged newest checkpoint is passed over for the one before") {
    const ScratchDirectory scratch;
    const fs::path directory = scratch / "out";
    run_case(a_case(), into(directory));
    {
        std::fstream file(directory / "checkpoints/step_000000060.h5",
                          std::ios::in | std::ios::out | std::ios::binary);
        file.seekp(5000);
        file.put('\x55');
        file.put('\x2a');
    }
    std::int64_t begun_at = -1;
    const RunOutcome outcome = resume_run(70, into(directory, [&](FakeEngine& engine) {
                                              engine.after_step = [&](std::int64_t step) {
                                                  if (begun_at < 0)
                                                      begun_at = step - 1;
                                              };
                                          }));
    CHECK(begun_at == 50);
    CHECK(outcome.step == 70);
}

TEST_CASE("there is nothing to resume where no run has been") {
    const ScratchDirectory scratch;
    CHECK_THROWS_AS(resume_run(std::nullopt, into(scratch / "none")), InputError);
    fs::create_directory(scratch / "empty");
    CHECK_THROWS_AS(resume_run(std::nullopt, into(scratch / "empty")), InputError);
}

TEST_CASE("a steady run ends when it is steady and says so") {
    const ScratchDirectory scratch;
    Case what = a_case();
    what.run.stop_when_steady = SteadyCriterion{"area", 1e-9, 30};
    const RunOutcome outcome = run_case(what, into(scratch / "out"));
    CHECK(outcome.status == ExitStatus::done);
    CHECK(outcome.end == RunEnd::steady);
    CHECK(outcome.step == 30);
    CHECK(summary(scratch / "out")["end"] == "steady");
}

TEST_CASE("the wall time stops a run like a signal does") {
    const ScratchDirectory scratch;
    Case what = a_case();
    what.run.wall_time = 0.0;
    const RunOutcome outcome = run_case(what, into(scratch / "out"));
    CHECK(outcome.status == ExitStatus::stopped);
    CHECK(outcome.step == 1);
    CHECK_THAT(outcome.message, Catch::Contains("wall time"));
}

TEST_CASE("an average in time is that of the samples since the last output") {
    const ScratchDirectory scratch;
    Case what = a_case();
    what.output.fields->average = true;
    what.output.fields->names = {"density"};
    CHECK(run_case(what, into(scratch / "out")).status == ExitStatus::done);
    // the engine's density is the number of the step: the mean of 1..30 and of 31..60
    CHECK(first_value(scratch / "out/fields/step_000000000.h5", "density") == 0.0F);
    CHECK(first_value(scratch / "out/fields/step_000000030.h5", "density") == 15.5F);
    CHECK(first_value(scratch / "out/fields/step_000000060.h5", "density") == 45.5F);
}

TEST_CASE("fields and surfaces are in SI units when the case has units") {
    const ScratchDirectory scratch;
    Case what = a_case();
    what.scales = Scales{1e-6, 1e-3, 1000.0};
    what.output.fields->names = {"velocity"};
    run_case(what, into(scratch / "out"));
    // the engine's velocity is the number of the step, 1e-3 m/s per lattice unit
    CHECK(first_value(scratch / "out/fields/step_000000030.h5", "velocity") == Approx(0.030F));
}

TEST_CASE("a run cannot be resumed to an end it has passed") {
    const ScratchDirectory scratch;
    run_case(a_case(), into(scratch / "out"));
    CHECK_THROWS_AS(resume_run(30, into(scratch / "out")), InputError);
    CHECK(metrics_steps(scratch / "out").back() == 60);
}
