#include "io/report_run.hpp"

#include "core/input_error.hpp"
#include "io/case_file.hpp"
#include "io/output_directory.hpp"
#include "io/posix_file.hpp"
#include "io/step_name.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <tuple>

namespace vesica {
namespace {

using Path = std::filesystem::path;

constexpr std::size_t longest_log = 64 * 1024;

/// A file's text; empty, with a note unless it is only absent, where it cannot be read.
std::string text_of(const Path& file, std::vector<std::string>& notes) {
    std::error_code none;
    if (!std::filesystem::exists(file, none))
        return {};
    try {
        return read_whole_file(file);
    } catch (const RunError& error) {
        notes.emplace_back(error.what());
        return {};
    }
}

std::string log_end(std::string text) {
    if (text.size() <= longest_log)
        return text;
    const std::size_t line = text.find('\n', text.size() - longest_log);
    return "...\n" + text.substr(line == std::string::npos ? text.size() - longest_log : line + 1);
}

/// Only what is whole JSON of ours goes into the page.
void read_summary(const Path& directory, ReportRun& run) {
    run.summary_text = text_of(directory / "summary.json", run.notes);
    if (run.summary_text.empty())
        return;
    const auto json = nlohmann::json::parse(run.summary_text, nullptr, false);
    if (json.is_object() && json.contains("end") && json["end"].is_string()) {
        run.state = json["end"].get<std::string>();
        return;
    }
    run.summary_text.clear();
    run.notes.emplace_back("summary.json is damaged; verdicts and timings are missing");
}

void read_resolved(const Path& directory, const Case* known, ReportRun& run) {
    if (run.resolved_text.empty())
        return;
    if (known != nullptr) {
        run.resolved = *known;
        return;
    }
    try {
        run.resolved = read_case(directory / "resolved.toml");
    } catch (const std::exception& error) {
        run.notes.push_back(fmt::format("the case cannot be read again ({}); its box, boundaries and units "
                                        "may be missing",
                                        words_of(error)));
    }
}

void read_table(const Path& directory, std::size_t most_numbers, ReportRun& run) {
    std::error_code none;
    if (!std::filesystem::exists(directory / "metrics.csv", none))
        return;
    try {
        if (most_numbers == 0)
            run.metrics = read_metrics(directory / "metrics.csv");
        else
            std::tie(run.metrics, run.metrics_every) =
                read_thinned_metrics(directory / "metrics.csv", most_numbers);
    } catch (const RunError& error) {
        run.notes.push_back(fmt::format("no plots: {}", error.what()));
    }
}

} // namespace

ReportRun read_report_run(const Path& directory, const ReportReading& reading) {
    std::error_code none;
    if (!std::filesystem::is_directory(directory, none))
        throw InputError(fmt::format("{}: is not a directory; expected the directory of a run; try vesica "
                                     "run CASE.toml -o {} first",
                                     directory.string(), directory.string()));
    ReportRun run;
    const Path whole = std::filesystem::weakly_canonical(directory, none);
    run.directory = whole.filename().string();
    run.case_text = text_of(directory / "case.toml", run.notes);
    run.resolved_text = text_of(directory / "resolved.toml", run.notes);
    run.log_text = log_end(text_of(directory / "log.txt", run.notes));
    read_summary(directory, run);
    read_resolved(directory, reading.known, run);
    read_table(directory, reading.most_numbers, run);
    if (run.case_text.empty() && run.resolved_text.empty() && run.summary_text.empty() &&
        run.metrics.columns.empty() && list_steps(directory / "surfaces", "surface_", ".vtp").empty())
        throw InputError(fmt::format("{}: holds no run; expected case.toml, metrics.csv, summary.json or "
                                     "surfaces; try the directory given to vesica run -o",
                                     directory.string()));
    if (is_being_written(directory))
        run.state = "running";
    else if (run.state.empty())
        run.state = "interrupted";
    return run;
}

std::size_t thin_metrics(MetricsTable& table, std::size_t rows) {
    const auto step = table.column("step");
    if (!step || table.rows.size() <= rows || rows == 0)
        return 1;
    std::vector<std::size_t> begins; // of each sample
    for (std::size_t i = 0; i < table.rows.size(); ++i)
        if (i == 0 || table.rows[i][*step] != table.rows[i - 1][*step])
            begins.push_back(i);
    begins.push_back(table.rows.size());
    const std::size_t samples = begins.size() - 1;
    const std::size_t every = (table.rows.size() + rows - 1) / rows;
    std::vector<std::vector<double>> kept;
    for (std::size_t sample = 0; sample < samples; ++sample)
        if (sample % every == 0 || sample + 1 == samples)
            for (std::size_t i = begins[sample]; i < begins[sample + 1]; ++i)
                kept.push_back(std::move(table.rows[i]));
    table.rows = std::move(kept);
    return every;
}

} // namespace vesica
