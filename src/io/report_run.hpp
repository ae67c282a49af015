#pragma once

#include "case/case.hpp"
#include "io/metrics_table.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vesica {

/// What a run's directory tells without its surfaces. Whatever cannot be read is left empty, with a note.
struct ReportRun {
    std::string directory; ///< its name, not where it is
    std::string state;     ///< finished, steady, stopped, failed, running or interrupted
    std::string case_text;
    std::string resolved_text;
    std::string log_text;     ///< its end, if it is long
    std::string summary_text; ///< JSON; empty while the run goes on
    std::optional<Case> resolved;
    MetricsTable metrics;
    std::size_t metrics_every = 1;  ///< of the samples in metrics.csv
    std::vector<std::string> notes; ///< what could not be read or is not shown, for the reader
};

/// What need not be read, or not whole.
struct ReportReading {
    const Case* known = nullptr;  ///< the case, where it is at hand
    std::size_t most_numbers = 0; ///< of metrics.csv, as read_thinned_metrics; 0: all
};

/// Throws InputError when `directory` is none, or holds nothing that a run leaves.
ReportRun read_report_run(const std::filesystem::path& directory, const ReportReading& reading = {});

/// `table` with every k-th sample (all vesicles of a step) and the last, k as small as gives at most `rows`
/// rows. Returns k.
std::size_t thin_metrics(MetricsTable& table, std::size_t rows);

} // namespace vesica
