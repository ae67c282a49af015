#include "io/metrics_table.hpp"

#include "core/input_error.hpp"
#include "io/number_text.hpp"
#include "io/posix_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <tuple>

namespace vesica {
namespace {

/// The numbers of one line, or nothing when it is not `columns` of them.
std::optional<std::vector<double>> parse_row(std::string_view line, std::size_t columns) {
    std::vector<double> row;
    row.reserve(columns);
    while (true) {
        const std::size_t comma = line.find(',');
        const auto value = parse_number(line.substr(0, comma));
        if (!value)
            return std::nullopt;
        row.push_back(*value);
        if (comma == std::string_view::npos)
            break;
        line.remove_prefix(comma + 1);
    }
    if (row.size() != columns)
        return std::nullopt;
    return row;
}

std::vector<std::string> split_names(std::string_view line) {
    std::vector<std::string> names;
    while (true) {
        const std::size_t comma = line.find(',');
        names.emplace_back(line.substr(0, comma));
        if (comma == std::string_view::npos)
            return names;
        line.remove_prefix(comma + 1);
    }
}

} // namespace

std::optional<std::size_t> MetricsTable::column(std::string_view name) const {
    const auto found = std::find(columns.begin(), columns.end(), name);
    if (found == columns.end())
        return std::nullopt;
    return static_cast<std::size_t>(found - columns.begin());
}

MetricsTable read_metrics(const std::filesystem::path& path) {
    const std::string content = read_whole_file(path);
    const std::size_t header_length = content.find('\n');
    if (header_length == std::string::npos || header_length == 0)
        throw RunError(fmt::format("{}: is not a table of metrics: it has no header line", path.string()));

    MetricsTable table;
    table.columns = split_names(std::string_view(content).substr(0, header_length));
    table.header_end = header_length + 1;
    std::size_t begin = table.header_end;
    std::size_t line_number = 1;
    std::size_t first_bad_line = 0;
    while (begin < content.size()) {
        ++line_number;
        const std::size_t end = content.find('\n', begin);
        if (end == std::string::npos)
            break;
        auto row = parse_row(std::string_view(content).substr(begin, end - begin), table.columns.size());
        // A crash tears only the end of the file. Whole rows after a bad one mean that something else
        // happened, and cutting there would lose good data silently.
        if (row && first_bad_line != 0)
            throw RunError(fmt::format("{}:{}: is damaged: expected {} numbers", path.string(),
                                       first_bad_line, table.columns.size()));
        if (row) {
            table.rows.push_back(std::move(*row));
            table.row_ends.push_back(end + 1);
        } else if (first_bad_line == 0) {
            first_bad_line = line_number;
        }
        begin = end + 1;
    }
    table.torn_bytes = content.size() - (table.row_ends.empty() ? table.header_end : table.row_ends.back());
    return table;
}

namespace {

/// Samples one after the other, thinner and thinner as they become too many.
class ThinnedSamples {
public:
    explicit ThinnedSamples(std::size_t most_rows) : most_rows_(most_rows) {}

    void add_row(std::vector<double> row, std::optional<std::size_t> step) {
        if (newest_.empty() || !step || newest_.back()[*step] != row[*step])
            begin_sample();
        newest_.push_back(std::move(row));
    }
    std::pair<std::vector<std::vector<double>>, std::size_t> whole() {
        keep_newest(); // the last, whichever it is
        std::vector<std::vector<double>> rows;
        for (auto& sample : kept_)
            std::move(sample.begin(), sample.end(), std::back_inserter(rows));
        return {std::move(rows), every_};
    }

private:
    void begin_sample() {
        if (!newest_.empty() && (count_ - 1) % every_ == 0)
            keep_newest();
        newest_.clear();
        ++count_;
        while (rows_ > most_rows_ && kept_.size() > 1)
            thin();
    }
    void keep_newest() {
        rows_ += newest_.size();
        kept_.push_back(std::move(newest_));
        newest_.clear();
    }
    void thin() {
        every_ *= 2;
        std::size_t to = 0;
        rows_ = 0;
        for (std::size_t from = 0; from < kept_.size(); from += 2) {
            if (to != from)
                kept_[to] = std::move(kept_[from]);
            rows_ += kept_[to++].size();
        }
        kept_.resize(to);
    }

    std::size_t most_rows_, every_ = 1, count_ = 0, rows_ = 0;
    std::vector<std::vector<std::vector<double>>> kept_; ///< samples whose number is a multiple of every_
    std::vector<std::vector<double>> newest_;            ///< number count_ - 1
};

} // namespace

std::pair<MetricsTable, std::size_t> read_thinned_metrics(const std::filesystem::path& path,
                                                          std::size_t most_numbers) {
    std::ifstream stream(path);
    if (!stream)
        throw RunError(fmt::format("{}: cannot be read", path.string()));
    std::string line;
    if (!std::getline(stream, line) || stream.eof() || line.empty())
        throw RunError(fmt::format("{}: is not a table of metrics: it has no header line", path.string()));
    MetricsTable table;
    table.columns = split_names(line);
    table.header_end = line.size() + 1;
    const std::optional<std::size_t> step = table.column("step");
    ThinnedSamples samples(most_numbers / table.columns.size());
    std::size_t first_bad_line = 0;
    for (std::size_t number = 2; std::getline(stream, line) && !stream.eof(); ++number) {
        auto row = parse_row(line, table.columns.size());
        if (row && first_bad_line != 0)
            throw RunError(fmt::format("{}:{}: is damaged: expected {} numbers", path.string(),
                                       first_bad_line, table.columns.size()));
        if (row)
            samples.add_row(std::move(*row), step);
        else if (first_bad_line == 0)
            first_bad_line = number;
    }
    std::size_t every = 1;
    std::tie(table.rows, every) = samples.whole();
    return {std::move(table), every};
}

} // namespace vesica
