#include "core/input_error.hpp"
#include "io/checkpoint_store.hpp"
#include "io/describe_file.hpp"
#include "io/metrics_file.hpp"
#include "io/run_summary.hpp"
#include "sample_run.hpp"
#include "scratch_directory.hpp"

#include <catch2/catch.hpp>

using namespace vesica;
using Catch::Contains;
using Catch::StartsWith;

namespace {

std::string refusal(const std::filesystem::path& path) {
    return complaint_of<InputError>([&] { describe_file(path); });
}

} // namespace

TEST_CASE("a checkpoint is described, and a damaged one is called so with the reason") {
    const ScratchDirectory scratch;
    const CheckpointStore store(scratch / "checkpoints", 2);
    Checkpoint checkpoint;
    checkpoint.engine.step = 1200;
    checkpoint.engine.size = {4, 3, 2};
    checkpoint.engine.populations.assign(19, std::vector<double>(24, 0.25));
    checkpoint.case_text = "title = \"A rest\"\n";
    checkpoint.program_version = "0.1.0";
    const auto path = store.write(checkpoint);
    const std::string text = describe_file(path).text;
    REQUIRE_THAT(text, StartsWith(path.string() + ": checkpoint, intact\n"));
    for (const char* part : {"step        1200\n", "4 x 3 x 2 cells, double precision", "A rest",
                             "Vesica 0.1.0, checkpoint format 1", "populations [19, 24]"})
        REQUIRE_THAT(text, Contains(part));

    std::string bad = content_of(path);
    bad[0] = 'x'; // not even the magic is left
    put_content(path, bad);
    REQUIRE_THAT(describe_file(path).text, Contains("checkpoint, NOT INTACT\n") &&
                                               Contains("refused     is not a checkpoint of Vesica"));
}

TEST_CASE("metrics are described, torn ones too") {
    const ScratchDirectory scratch;
    const auto path = scratch / "metrics.csv";
    MetricsFile file(path, {"step", "vesicle"});
    for (const double step : {0.0, 100.0, 200.0})
        file.append(std::vector<std::vector<double>>{{step, 0.0}, {step, 1.0}});
    REQUIRE_THAT(describe_file(path).text, Contains("metrics, intact") && Contains("3, from 0 to 200") &&
                                               Contains("rows        6") && Contains("step vesicle"));
    put_content(path, content_of(path) + "300,");
    REQUIRE_THAT(describe_file(path).text,
                 Contains("metrics, torn at the end") && Contains("4 bytes after the last row"));
}

TEST_CASE("a summary is described with its verdicts") {
    const ScratchDirectory scratch;
    RunSummary summary;
    summary.title = "A run";
    summary.end = "stopped";
    summary.reason = "wall time";
    summary.verdicts = {{"mass", false, "1e-3, allowed 1e-12"}};
    summary.versions = {{"vesica", "0.1.0"}};
    write_summary(scratch / "summary.json", summary);
    REQUIRE_THAT(describe_file(scratch / "summary.json").text,
                 Contains("A run") && Contains("stopped: wall time") && Contains("FAILED: mass, 1e-3") &&
                     Contains("vesica 0.1.0"));
    put_content(scratch / "summary.json", "{\"format\": \"vesica-summary-1\"}");
    REQUIRE_THAT(refusal(scratch / "summary.json"), Contains("is not a complete summary of a run"));
    put_content(scratch / "summary.json", "[1, 2");
    REQUIRE_THAT(refusal(scratch / "summary.json"), Contains("is not the summary of a run"));
}

TEST_CASE("series of fields and surfaces are described, with what is missing") {
    const ScratchDirectory scratch;
    write_sample_fields(scratch.path(), {0, 100});
    write_sample_surfaces(scratch.path(), {0, 100});
    for (const char* name : {"fields.xmf", "fields.h5"})
        REQUIRE_THAT(describe_file(scratch / name).text,
                     Contains(", intact\n") && Contains("2, from 0 to 100") && Contains("2, from 0 to 25") &&
                         Contains("6 x 5 x 4, 0.5 apart, from 1, 0.5, 0") && Contains("velocity, vector"));
    REQUIRE_THAT(describe_file(scratch / "fields/step_000000100.h5").text,
                 Contains("fields of one step") && Contains("step        100") && Contains("phase\n"));
    REQUIRE_THAT(describe_file(scratch / "surfaces/surface_000000100.vtp").text,
                 Contains("surfaces of the vesicles, intact") && Contains("points      8") &&
                     Contains("triangles   8") && Contains("mean_curvature"));
    REQUIRE_THAT(describe_file(scratch / "surfaces/surfaces.pvd").text,
                 Contains(", intact\n") && Contains("2, from 0"));

    const auto surface = scratch / "surfaces/surface_000000100.vtp";
    put_content(surface, content_of(surface).substr(0, 1800));
    REQUIRE_THAT(describe_file(surface).text, Contains("NOT INTACT"));
    remove(surface);
    remove(scratch / "fields/step_000000100.h5");
    REQUIRE_THAT(describe_file(scratch / "fields.xmf").text,
                 Contains("NOT INTACT") && Contains("step_000000100.h5: cannot open"));
    REQUIRE_THAT(describe_file(scratch / "surfaces/surfaces.pvd").text,
                 Contains("NOT INTACT") && Contains("missing     surface_000000100.vtp"));
}

TEST_CASE("a case is described, and a file that is no TOML is refused with its place") {
    const ScratchDirectory scratch;
    const auto path = scratch / "case.toml";
    put_content(
        path, "title = \"Two\"\n[lattice]\nsize = [8, 9, 10]\n[vesicle_type.rbc]\n[[vesicle]]\n[[vesicle]]\n"
              "[run]\nsteps = 500\n");
    REQUIRE_THAT(describe_file(path).text, Contains("case\n") && Contains("Two") &&
                                               Contains("8 x 9 x 10 cells") && Contains("rbc") &&
                                               Contains("vesicles    2") && Contains("500"));
    put_content(path, "title = \n");
    REQUIRE_THAT(refusal(path), StartsWith(path.string() + ":1:") && Contains("the text is no TOML"));
    put_content(path, "[lattice]\nsize = 3\n");
    REQUIRE_THAT(refusal(path), Contains("it has no lattice.size"));
    put_content(path, "[tool]\nname = 1\n");
    REQUIRE_THAT(refusal(path), Contains("it has no lattice.size"));
}

TEST_CASE("anything else is refused as input") {
    const ScratchDirectory scratch;
    put_content(scratch / "a.txt", "text");
    put_content(scratch / "a.csv", "x,y\n1,2\n");
    REQUIRE_THAT(refusal(scratch / "none.h5"), Contains("there is no such file; expected a case (.toml) or"));
    REQUIRE_THAT(refusal(scratch.path()), Contains("is a directory"));
    REQUIRE_THAT(refusal("/dev/zero"), Contains("is not a regular file"));
    REQUIRE_THAT(refusal(scratch / "a.txt"), Contains("is of no kind known"));
    REQUIRE_THAT(refusal(scratch / "a.csv"), Contains("it has no column step"));
    for (const char* name : {"a.vtp", "a.pvd", "a.xmf"}) {
        put_content(scratch / name, "text");
        REQUIRE_THAT(refusal(scratch / name), Contains("that Vesica wrote"));
    }
    put_content(scratch / "a.h5", "text");
    REQUIRE_THAT(refusal(scratch / "a.h5"), Contains("is not an HDF5 file that Vesica wrote"));
}
