#include "core/input_error.hpp"
#include "io/base64.hpp"
#include "io/byte_order.hpp"
#include "io/output_directory.hpp"
#include "io/report_file.hpp"
#include "io/report_run.hpp"
#include "sample_run.hpp"
#include "scratch_directory.hpp"
#include "sphere_mesh.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace vesica;

namespace {

const std::string page = "<!doctype html><p>page</p><!--vesica:data--><script>run()</script>";

/// The content of the script element with this id.
std::string script(const std::string& html, const std::string& id) {
    const std::size_t begin = html.find('>', html.find("id=\"" + id + "\"")) + 1;
    return html.substr(begin, html.find("</script>", begin) - begin);
}

nlohmann::json manifest_of(const std::filesystem::path& file) {
    return nlohmann::json::parse(script(content_of(file), "vesica-manifest"));
}

std::vector<double> numbers_of(const nlohmann::json& column) {
    const std::string bytes = *decode_base64(column["data"].get<std::string>(), std::string::npos);
    std::vector<double> numbers;
    for (std::size_t i = 0; i < bytes.size(); i += sizeof(double))
        numbers.push_back(from_bytes<double>(bytes.data() + i, std::endian::little));
    return numbers;
}

/// A run's directory with this many frames and samples of two vesicles.
void write_run(const std::filesystem::path& directory, int frames, int samples = 3, int level = 3) {
    SurfaceSeries series(directory, Scales{});
    SurfaceArrays second = spheroid_mesh(9, 1.5, level);
    second.vesicle = 1;
    for (int frame = 0; frame < frames; ++frame)
        series.write(100 * frame, {spheroid_mesh(12, 0.7, level), second});
    std::string table = "step,time,vesicle,area,gap\n";
    for (int sample = 0; sample < samples; ++sample)
        for (int vesicle = 0; vesicle < 2; ++vesicle)
            table += fmt::format("{0},{0},{1},{2},nan\n", 10 * sample, vesicle, 100 + sample / 3.0 + vesicle);
    put_content(directory / "metrics.csv", table);
    put_content(directory / "case.toml", "title = \"</script><b>\"\n");
}

} // namespace

TEST_CASE("a report holds the metrics to the last bit, and columns without numbers as none") {
    const ScratchDirectory scratch;
    write_run(scratch.path(), 2, 5);
    const ReportOutcome outcome = write_report(scratch.path(), scratch / "report.html", page, {});
    const auto manifest = manifest_of(scratch / "report.html");
    REQUIRE(manifest["metrics"]["rows"] == 10);
    REQUIRE(manifest["metrics"]["columns"][3]["name"] == "area");
    const std::vector<double> area = numbers_of(manifest["metrics"]["columns"][3]);
    for (std::size_t row = 0; row < 10; ++row)
        REQUIRE(area[row] ==
                Approx(100 + static_cast<double>(row / 2) / 3 + static_cast<double>(row % 2)).epsilon(1e-15));
    REQUIRE(manifest["metrics"]["columns"][4]["data"].is_null());
    REQUIRE(manifest["frames"].size() == 2);
    REQUIRE(manifest["state"] == "interrupted");
    REQUIRE(outcome.bytes == std::filesystem::file_size(scratch / "report.html"));
}

TEST_CASE("what a case says cannot end the element that holds it") {
    const ScratchDirectory scratch;
    write_run(scratch.path(), 1);
    write_report(scratch.path(), scratch / "report.html", page, {});
    const std::string html = content_of(scratch / "report.html");
    REQUIRE(html.find("<b>") == std::string::npos);
    REQUIRE(manifest_of(scratch / "report.html")["case"] == "title = \"</script><b>\"\n");
    REQUIRE(html.ends_with("<script>run()</script>"));
}

TEST_CASE("frames are chosen evenly, the first and the last among them") {
    const ScratchDirectory scratch;
    write_run(scratch.path(), 11, 1, 1);
    ReportOptions options;
    options.frames = 3;
    const ReportOutcome outcome = write_report(scratch.path(), scratch / "report.html", page, options);
    REQUIRE(outcome.frames == 3);
    REQUIRE(outcome.frames_found == 11);
    const auto frames = manifest_of(scratch / "report.html")["frames"];
    REQUIRE(frames[0]["step"] == 0);
    REQUIRE(frames[1]["step"] == 500);
    REQUIRE(frames[2]["step"] == 1000);
    REQUIRE_THAT(outcome.notes.back(), Catch::Contains("3 of 11 frames"));
    for (const auto& frame : frames)
        REQUIRE(script(content_of(scratch / "report.html"), "vesica-frame-" + frame["step"].dump()).size() >
                100);
}

TEST_CASE("a page is no larger than asked: surfaces become coarser, then fewer, or it is refused") {
    const ScratchDirectory scratch;
    write_run(scratch.path(), 12);
    ReportOptions options;
    const ReportOutcome whole = write_report(scratch.path(), scratch / "report.html", page, options);
    REQUIRE(whole.frames == 12);
    REQUIRE(whole.triangles == 12 * 2 * 1280);
    options.max_bytes = whole.bytes / 2;
    const ReportOutcome coarse = write_report(scratch.path(), scratch / "report.html", page, options);
    REQUIRE(coarse.bytes <= options.max_bytes);
    REQUIRE(coarse.bytes > options.max_bytes / 2);
    REQUIRE(coarse.frames == 12);
    options.max_bytes = whole.bytes / 10;
    const ReportOutcome fewer = write_report(scratch.path(), scratch / "report.html", page, options);
    REQUIRE(fewer.bytes <= options.max_bytes);
    REQUIRE(fewer.frames < 12);
    REQUIRE(fewer.frames > 1);
    options.max_bytes = 500;
    REQUIRE_THROWS_WITH(write_report(scratch.path(), scratch / "none.html", page, options),
                        Catch::Contains("--max-size"));
    REQUIRE_FALSE(std::filesystem::exists(scratch / "none.html"));
}

TEST_CASE("long tables are thinned by whole samples and keep the last") {
    MetricsTable table{{"step", "vesicle"}, {}, {}, 0, 0};
    for (double step = 0; step < 100; ++step)
        for (double vesicle = 0; vesicle < 3; ++vesicle)
            table.rows.push_back({step, vesicle});
    MetricsTable same = table;
    REQUIRE(thin_metrics(same, 300) == 1);
    REQUIRE(same.rows.size() == 300);
    REQUIRE(thin_metrics(table, 50) == 6);
    REQUIRE(table.rows.size() == 3 * 18); // 0, 6 ... 96, and 99
    REQUIRE(table.rows[3] == std::vector<double>{6, 0});
    REQUIRE(table.rows.back() == std::vector<double>{99, 2});
}

TEST_CASE("a damaged frame is left out and named, the others are shown") {
    const ScratchDirectory scratch;
    write_run(scratch.path(), 3);
    const auto victim = scratch.path() / "surfaces" / "surface_000000100.vtp";
    put_content(victim, content_of(victim).substr(0, 2000));
    const ReportOutcome outcome = write_report(scratch.path(), scratch / "report.html", page, {});
    REQUIRE(outcome.frames == 2);
    REQUIRE(outcome.notes.size() == 1);
    REQUIRE_THAT(outcome.notes[0], Catch::Contains("surface_000000100.vtp"));
    REQUIRE(manifest_of(scratch / "report.html")["notes"][0] == outcome.notes[0]);
}

TEST_CASE("what is damaged beside the surfaces is named, and the page made of the rest") {
    const ScratchDirectory scratch;
    write_run(scratch.path(), 1);
    put_content(scratch / "summary.json", "{\"end\": ");
    put_content(scratch / "resolved.toml", "[lattice]\nsize = 3\n");
    put_content(scratch / "metrics.csv", "step,time,vesicle\n0,0,0\n1,x,0\n2,2,0\n");
    const ReportOutcome outcome = write_report(scratch.path(), scratch / "report.html", page, {});
    REQUIRE(outcome.frames == 1);
    REQUIRE(outcome.notes.size() == 3);
    const auto manifest = manifest_of(scratch / "report.html");
    REQUIRE(manifest["summary"].is_null());
    REQUIRE(manifest["box"].is_null());
}

TEST_CASE("a run that goes on is told from one that was interrupted") {
    const ScratchDirectory scratch;
    {
        const OutputDirectory held = OutputDirectory::create(scratch / "run", false);
        write_run(scratch / "run", 1);
        REQUIRE(read_report_run(scratch / "run").state == "running");
    }
    REQUIRE(read_report_run(scratch / "run").state == "interrupted");
    put_content(scratch.path() / "run" / "summary.json", "{\"end\": \"steady\"}");
    REQUIRE(read_report_run(scratch / "run").state == "steady");
}

TEST_CASE("a directory without a run, or none, is refused with what was expected") {
    const ScratchDirectory scratch;
    REQUIRE_THROWS_WITH(write_report(scratch.path(), scratch / "report.html", page, {}),
                        Catch::Contains("holds no run; expected"));
    REQUIRE_THROWS_WITH(write_report(scratch / "none", scratch / "report.html", page, {}),
                        Catch::Contains("is not a directory"));
    REQUIRE_FALSE(std::filesystem::exists(scratch / "report.html"));
}
