#pragma once

#include "io/posix_file.hpp"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace vesica {

/// metrics.csv, growing while the run goes on. The rows of one sample are appended by one write, so that a
/// reader sees whole lines; should a crash or a full disk tear the end, it is cut off when the file is opened
/// again or at once. The first column is the step.
class MetricsFile {
public:
    /// Begins a new table, replacing any old one. Throws RunError.
    MetricsFile(std::filesystem::path path, std::vector<std::string> columns);

    /// Continues a table: a torn end and every row with a step beyond `last_step` are cut off. Begins a new
    /// table when there is none. Throws RunError, also when its columns are not these.
    static MetricsFile resume(std::filesystem::path path, std::vector<std::string> columns,
                              std::int64_t last_step);

    /// Appends the rows of one sample, row after row, as many numbers as columns each. Throws RunError (disk
    /// full); the file then ends with the sample before.
    void append(std::span<const std::vector<double>> rows);

    /// Waits until all rows are on the device. Call it before writing a checkpoint: a resumed run relies on
    /// the rows up to the checkpoint's step.
    void flush();

    const std::filesystem::path& path() const { return path_; }

private:
    MetricsFile() = default;
    void open_at(std::uint64_t length);

    std::filesystem::path path_;
    std::size_t columns_ = 0;
    FileDescriptor file_;
    std::uint64_t length_ = 0;
};

} // namespace vesica
