#include "io/live_report.hpp"
#include "io/surface_series.hpp"
#include "scratch_directory.hpp"
#include "sphere_mesh.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace vesica;

namespace {

std::string no_plan() {
    return {};
}

} // namespace

TEST_CASE("a run whose directory is still to come has a page without data") {
    const ScratchDirectory scratch;
    LiveReport report(scratch / "run", "<p><!--vesica:data--></p>", Case{}, no_plan);
    const auto manifest = nlohmann::json::parse(report.manifest());
    REQUIRE(manifest["state"] == "running");
    REQUIRE(manifest["live"] == true);
    REQUIRE(manifest["frames"].empty());
    REQUIRE(report.page().starts_with("<p><script type=\"application/json\" id=\"vesica-manifest\">{"));
    REQUIRE(report.page().ends_with("</script>\n</p>"));
    REQUIRE_FALSE(report.frame(0));
}

TEST_CASE("a live report grows with the run, and its tag tells when") {
    const ScratchDirectory scratch;
    LiveReport report(scratch.path(), "", Case{}, no_plan);
    SurfaceSeries series(scratch.path(), Scales{});
    series.write(0, {spheroid_mesh(5, 1, 1)});
    REQUIRE(nlohmann::json::parse(report.manifest())["frames"].empty()); // an earlier run's
    REQUIRE_FALSE(report.frame(0));
    const std::string early = report.tag();
    report.begin();
    REQUIRE(report.tag() != early);
    put_content(scratch / "metrics.csv", "step,time,vesicle,area\n0,0,0,1\n");
    const std::string before = report.tag();
    REQUIRE(report.tag() == before);
    REQUIRE(nlohmann::json::parse(report.manifest())["metrics"]["rows"] == 1);
    put_content(scratch / "metrics.csv", "step,time,vesicle,area\n0,0,0,1\n10,10,0,2\n");
    const std::string after = report.tag();
    REQUIRE(after != before);
    REQUIRE(nlohmann::json::parse(report.manifest())["metrics"]["rows"] == 2);
    series.write(20, {spheroid_mesh(5, 1, 1)});
    REQUIRE(report.tag() != after);
    const auto frames = nlohmann::json::parse(report.manifest())["frames"];
    REQUIRE(frames.size() == 2);
    REQUIRE(frames[1]["step"] == 20);
    REQUIRE(report.frame(20)->size() > 500);
    REQUIRE(report.frame(20) == report.frame(20));
    REQUIRE_FALSE(report.frame(10));
}

TEST_CASE("of very many frames a few hundred are shown, the last among them, always the same ones") {
    const ScratchDirectory scratch;
    LiveReport report(scratch.path(), "", Case{}, no_plan);
    report.begin();
    std::filesystem::create_directory(scratch / "surfaces");
    const auto steps = [&](int count) {
        for (int i = 0; i < count; ++i)
            put_content(scratch / ("surfaces/" + fmt::format("surface_{:09}.vtp", i)), "");
        std::vector<int> shown;
        const auto manifest = nlohmann::json::parse(report.manifest());
        for (const auto& frame : manifest["frames"])
            shown.push_back(frame["step"]);
        return shown;
    };
    const std::vector<int> some = steps(1000), more = steps(1003);
    REQUIRE(some.size() <= 402);
    REQUIRE(some.size() > 200);
    REQUIRE(some.back() == 999);
    REQUIRE(more.back() == 1002);
    REQUIRE(std::includes(more.begin(), more.end(), some.begin(), some.end() - 1));
}
