#include "core/input_error.hpp"
#include "io/metrics_file.hpp"
#include "io/metrics_table.hpp"
#include "io/number_text.hpp"
#include "small_disk.hpp"

#include <catch2/catch.hpp>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

using namespace vesica;

namespace {

const std::vector<std::string> columns = {"step", "vesicle", "area"};
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

std::vector<std::vector<double>> sample(double step) {
    return {{step, 0.0, step / 3.0}, {step, 1.0, not_a_number}};
}

std::string number(double value) {
    std::string text;
    append_number(text, value);
    return text;
}

} // namespace

TEST_CASE("a number's text reads back as the same number, and is short") {
    REQUIRE(number(not_a_number) == "nan");
    REQUIRE(number(-not_a_number) == "nan");
    REQUIRE(number(std::numeric_limits<double>::infinity()) == "inf");
    REQUIRE(number(100000.0) == "100000");
    REQUIRE(number(123456789012.0) == "123456789012");
    REQUIRE(number(-0.0) == "-0");
    REQUIRE(number(0.1) == "0.1");
    REQUIRE(number(1e-5) == "1e-05");
    REQUIRE(number(1e300) == "1e+300");
    std::mt19937_64 random(3);
    for (int i = 0; i < 20000; ++i) {
        const double value = std::bit_cast<double>(random());
        if (std::isnan(value))
            continue;
        REQUIRE(std::bit_cast<std::uint64_t>(*parse_number(number(value))) ==
                std::bit_cast<std::uint64_t>(value));
    }
    for (const char* text : {"", " 1", "1 ", "1,", "0x10", "one", "1e", "+1"})
        REQUIRE_FALSE(parse_number(text));
}

TEST_CASE("metrics.csv holds the header and a line per row") {
    const ScratchDirectory scratch;
    MetricsFile file(scratch / "metrics.csv", columns);
    file.append(sample(0.0));
    file.append(sample(200000.0));
    file.flush();
    REQUIRE(content_of(scratch / "metrics.csv") ==
            "step,vesicle,area\n0,0,0\n0,1,nan\n200000,0,66666.66666666667\n200000,1,nan\n");
    const MetricsTable table = read_metrics(scratch / "metrics.csv");
    REQUIRE(table.columns == columns);
    REQUIRE(table.rows.size() == 4);
    REQUIRE(table.rows[2][2] == 200000.0 / 3.0);
    REQUIRE(std::isnan(table.rows[3][2]));
    REQUIRE(table.torn_bytes == 0);
    REQUIRE(table.column("area") == 2);
    REQUIRE_FALSE(table.column("volume"));
}

TEST_CASE("a table torn anywhere in its last sample continues as if it had not been") {
    const ScratchDirectory scratch;
    const auto path = scratch / "metrics.csv";
    std::string before, whole;
    {
        MetricsFile file(path, columns);
        for (const double step : {0.0, 100.0, 200.0})
            file.append(sample(step));
        before = content_of(path);
        file.append(sample(300.0));
        whole = content_of(path);
    }
    for (std::size_t length = before.size(); length <= whole.size(); ++length) {
        put_content(path, whole.substr(0, length));
        MetricsFile::resume(path, columns, 200);
        REQUIRE(content_of(path) == before);
    }
    put_content(path, before + std::string(100, '\0')); // what a crash of the machine can leave
    MetricsFile file = MetricsFile::resume(path, columns, 200);
    file.append(sample(300.0));
    REQUIRE(content_of(path) == whole);
}

TEST_CASE("resuming drops the rows after the checkpoint") {
    const ScratchDirectory scratch;
    const auto path = scratch / "metrics.csv";
    {
        MetricsFile file(path, columns);
        for (const double step : {0.0, 100.0, 200.0, 300.0})
            file.append(sample(step));
    }
    MetricsFile::resume(path, columns, 150);
    const MetricsTable table = read_metrics(path);
    REQUIRE(table.rows.size() == 4);
    REQUIRE(table.rows.back()[0] == 100.0);
}

TEST_CASE("resuming without a table begins one, and refuses one of other columns") {
    const ScratchDirectory scratch;
    const auto path = scratch / "metrics.csv";
    MetricsFile::resume(path, columns, 100);
    REQUIRE(content_of(path) == "step,vesicle,area\n");
    REQUIRE_THAT(complaint_of<RunError>([&] {
                     MetricsFile::resume(path, {"step", "area"}, 100);
                 }),
                 Catch::EndsWith("metrics.csv: cannot be continued: its columns are step,vesicle,area; "
                                 "expected step,area"));
}

TEST_CASE("damage before the end of the table is reported, not cut away") {
    const ScratchDirectory scratch;
    const auto path = scratch / "metrics.csv";
    put_content(path, "step,vesicle,area\n0,0,1\n100,0,2x\n200,0,3\n");
    REQUIRE_THAT(complaint_of<RunError>([&] { MetricsFile::resume(path, columns, 300); }),
                 Catch::EndsWith("metrics.csv:3: is damaged: expected 3 numbers"));
    put_content(path, "");
    REQUIRE_THAT(complaint_of<RunError>([&] { read_metrics(path); }),
                 Catch::Contains("it has no header line"));
}

TEST_CASE("rows are not written into a deleted file") {
    const ScratchDirectory scratch;
    const auto path = scratch / "metrics.csv";
    MetricsFile file(path, columns);
    remove(path);
    REQUIRE_THAT(complaint_of<RunError>([&] { file.append(sample(0.0)); }),
                 Catch::EndsWith("metrics.csv: has been deleted during the run"));
    REQUIRE_THAT(complaint_of<RunError>([&] { file.flush(); }),
                 Catch::EndsWith("has been deleted during the run"));
}

TEST_CASE("on a full disk the table ends with the last whole sample") {
    const SmallDisk disk("256k");
    if (!disk.mounted())
        return; // only root can mount one
    const auto path = disk / "metrics.csv";
    MetricsFile file(path, columns);
    disk.fill_but(8192);
    std::string text;
    double step = 0.0;
    while (text.empty() && step < 1000.0)
        text = complaint_of<RunError>([&] { file.append(sample(step++)); });
    REQUIRE_THAT(text, Catch::EndsWith("metrics.csv: cannot write: No space left on device"));
    const MetricsTable table = read_metrics(path);
    REQUIRE(table.torn_bytes == 0);
    REQUIRE(table.rows.size() == 2 * (static_cast<std::size_t>(step) - 1));
    REQUIRE(table.rows.size() > 100);
}

TEST_CASE("a thinned table has every k-th sample whole, and the last") {
    const ScratchDirectory scratch;
    const auto table_of = [&](int samples) {
        std::string text = "step,vesicle\n";
        for (int sample = 0; sample < samples; ++sample)
            for (int vesicle = 0; vesicle < 3; ++vesicle)
                text += fmt::format("{},{}\n", 10 * sample, vesicle);
        put_content(scratch / "metrics.csv", text + "99999,");    // torn
        return read_thinned_metrics(scratch / "metrics.csv", 60); // ten samples of three rows of two
    };
    for (int samples = 1; samples < 100; ++samples) {
        INFO(samples);
        const auto [table, every] = table_of(samples);
        REQUIRE(every == std::bit_ceil((static_cast<unsigned>(samples) + 8) / 10)); // the last is not counted
        std::vector<std::vector<double>> expected;
        for (int sample = 0; sample < samples; ++sample)
            if (sample % static_cast<int>(every) == 0 || sample + 1 == samples)
                for (int vesicle = 0; vesicle < 3; ++vesicle)
                    expected.push_back({10.0 * sample, static_cast<double>(vesicle)});
        REQUIRE(table.rows == expected);
    }
    put_content(scratch / "metrics.csv", "step,vesicle\n0,0\n1,?\n2,0\n");
    REQUIRE_THAT(complaint_of<RunError>([&] { read_thinned_metrics(scratch / "metrics.csv", 60); }),
                 Catch::EndsWith(":3: is damaged: expected 2 numbers"));
}
