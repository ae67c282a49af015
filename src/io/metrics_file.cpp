#include "io/metrics_file.hpp"

#include "core/input_error.hpp"
#include "io/atomic_file.hpp"
#include "io/metrics_table.hpp"
#include "io/number_text.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cassert>

namespace vesica {
namespace {

std::string header_of(const std::vector<std::string>& columns) {
    return fmt::format("{}\n", fmt::join(columns, ","));
}

void cut(const FileDescriptor& file, std::uint64_t length, const std::filesystem::path& path) {
    if (::ftruncate(file.number(), static_cast<off_t>(length)) != 0)
        fail_with_errno(path, "cannot shorten");
}

/// An open file outlives its name: without this, a run whose folder was deleted would write into nothing.
void require_name(const FileDescriptor& file, const std::filesystem::path& path) {
    struct stat status = {};
    if (::fstat(file.number(), &status) != 0)
        fail_with_errno(path, "cannot write");
    if (status.st_nlink == 0)
        throw RunError(fmt::format("{}: has been deleted during the run", path.string()));
}

} // namespace

MetricsFile::MetricsFile(std::filesystem::path path, std::vector<std::string> columns)
    : path_(std::move(path)), columns_(columns.size()) {
    const std::string header = header_of(columns);
    write_atomically(path_, header);
    open_at(header.size());
}

MetricsFile MetricsFile::resume(std::filesystem::path path, std::vector<std::string> columns,
                                std::int64_t last_step) {
    if (!std::filesystem::exists(path))
        return MetricsFile(std::move(path), std::move(columns));
    const MetricsTable table = read_metrics(path);
    if (table.columns != columns)
        throw RunError(fmt::format("{}: cannot be continued: its columns are {}; expected {}", path.string(),
                                   fmt::join(table.columns, ","), fmt::join(columns, ",")));
    std::uint64_t length = table.header_end;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        if (table.rows[row].front() > static_cast<double>(last_step))
            break;
        length = table.row_ends[row];
    }
    MetricsFile metrics;
    metrics.path_ = std::move(path);
    metrics.columns_ = columns.size();
    metrics.open_at(length);
    return metrics;
}

void MetricsFile::open_at(std::uint64_t length) {
    file_ = open_file(path_, O_WRONLY | O_APPEND, "cannot open for appending");
    if (length_of(file_, path_) != length)
        cut(file_, length, path_);
    length_ = length;
}

void MetricsFile::append(std::span<const std::vector<double>> rows) {
    std::string text;
    for (const auto& row : rows) {
        assert(row.size() == columns_);
        for (const double value : row) {
            append_number(text, value);
            text += ',';
        }
        text.back() = '\n';
    }
    require_name(file_, path_);
    try {
        write_fully(file_, text, path_);
    } catch (const RunError&) {
        // The table stays whole even if this fails too: the torn end is cut off at the next opening.
        [[maybe_unused]] const int ignored = ::ftruncate(file_.number(), static_cast<off_t>(length_));
        throw;
    }
    length_ += text.size();
}

void MetricsFile::flush() {
    require_name(file_, path_);
    synchronise(file_, path_);
}

} // namespace vesica
