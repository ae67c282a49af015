#include "io/run_summary.hpp"
#include "scratch_directory.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <limits>

using namespace vesica;

TEST_CASE("the summary tells everything in JSON") {
    const ScratchDirectory scratch;
    RunSummary summary;
    summary.title = "A \"quoted\" title";
    summary.end = "steady";
    summary.last_step = 40000;
    summary.verdicts = {{"mass", true, "2e-16, allowed 1e-12"}, {"path", false, "0.1, allowed 0.05"}};
    summary.size = {64, 32, 16};
    summary.mlups = 12.5;
    summary.seconds = {{"steps", 3.25}};
    summary.versions = {{"vesica", "0.1.0"}};
    summary.scales = Scales{2e-7, 1e-9, 1000.0};
    summary.columns = {"step", "inclination"};
    summary.last_metrics = {{40000.0, std::numeric_limits<double>::quiet_NaN()}};
    write_summary(scratch / "summary.json", summary);

    const auto json = nlohmann::json::parse(content_of(scratch / "summary.json"));
    REQUIRE(json["format"] == "vesica-summary-1");
    REQUIRE(json["title"] == summary.title);
    REQUIRE(json["end"] == "steady");
    REQUIRE(json["last_step"] == 40000);
    REQUIRE(json["verdicts"][1]["name"] == "path");
    REQUIRE(json["verdicts"][1]["passed"] == false);
    REQUIRE(json["lattice"]["size"] == nlohmann::json({64, 32, 16}));
    REQUIRE(json["mlups"] == 12.5);
    REQUIRE(json["seconds"]["steps"] == 3.25);
    REQUIRE(json["versions"]["vesica"] == "0.1.0");
    REQUIRE(json["scales"]["cell_m"] == 2e-7);
    REQUIRE(json["last_metrics"][0]["step"].is_number_integer());
    REQUIRE(json["last_metrics"][0]["inclination"].is_null());
}

TEST_CASE("a reason with broken characters does not cost the summary") {
    const ScratchDirectory scratch;
    RunSummary summary;
    summary.reason = "bad \xff byte";
    write_summary(scratch / "summary.json", summary);
    const auto json = nlohmann::json::parse(content_of(scratch / "summary.json"));
    REQUIRE(json["scales"].is_null());
    REQUIRE(json["reason"].get<std::string>().find("bad ") == 0);
}
