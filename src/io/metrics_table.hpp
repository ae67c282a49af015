#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
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

} // namespace vesica
