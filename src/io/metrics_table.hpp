#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vesica {

/// What metrics.csv holds: names, and rows of as many numbers.
struct MetricsTable {
    std::vector<std::string> columns;
    std::vector<std::vector<double>> rows;
    std::vector<std::size_t> row_ends; ///< bytes from the start of the file to the end of each row
    std::size_t header_end = 0;        ///< bytes of the header line
    std::size_t torn_bytes = 0;        ///< after the last whole row: what a crash left

    std::optional<std::size_t> column(std::string_view name) const;
};

/// Reads the whole rows; a torn end is left out and counted. Throws RunError when the file cannot be read,
/// has no header, or is damaged before its end (`FILE:LINE: ...`).
MetricsTable read_metrics(const std::filesystem::path& path);

/// Every k-th sample (all vesicles of a step) and the last, k the least power of two with which all but the
/// last are at most `most_numbers`, and k. Takes memory for what it returns only. Without row_ends and
/// torn_bytes. Throws as read_metrics does.
std::pair<MetricsTable, std::size_t> read_thinned_metrics(const std::filesystem::path& path,
                                                          std::size_t most_numbers);

} // namespace vesica
