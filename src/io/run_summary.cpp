#include "io/run_summary.hpp"

#include "io/atomic_file.hpp"
#include "io/description_lines.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace vesica {
namespace {

using Json = nlohmann::ordered_json;

/// Steps, indices and counts read as integers although the metrics are doubles.
Json number(double value) {
    if (!std::isfinite(value))
        return nullptr;
    if (std::trunc(value) == value && std::abs(value) < 1e15)
        return static_cast<std::int64_t>(value);
    return value;
}

Json numbers(const std::map<std::string, double>& values) {
    Json object = Json::object();
    for (const auto& [name, value] : values)
        object[name] = number(value);
    return object;
}

Json verdicts_of(const RunSummary& summary) {
    Json list = Json::array();
    for (const auto& verdict : summary.verdicts)
        list.push_back({{"name", verdict.name}, {"passed", verdict.passed}, {"text", verdict.text}});
    return list;
}

Json metrics_of(const RunSummary& summary) {
    Json list = Json::array();
    for (const auto& row : summary.last_metrics) {
        assert(row.size() == summary.columns.size());
        Json object = Json::object();
        for (std::size_t i = 0; i < row.size(); ++i)
            object[summary.columns[i]] = number(row[i]);
        list.push_back(std::move(object));
    }
    return list;
}

Json scales_of(const RunSummary& summary) {
    if (!summary.scales)
        return nullptr;
    return {{"cell_m", summary.scales->cell},
            {"step_s", summary.scales->step},
            {"density_kg_per_m3", summary.scales->density}};
}

Json axes(const Vec3<int>& values) {
    return Json::array({values.x, values.y, values.z});
}

Json parallel_of(const ParallelSummary& parallel) {
    const double steps = static_cast<double>(std::max<std::int64_t>(parallel.steps, 1));
    const auto per_step = [&](std::int64_t count) {
        return number(static_cast<double>(count) / steps);
    };
    Json ranks = Json::array();
    for (const ParallelSummary::Rank& rank : parallel.ranks)
        ranks.push_back({{"begin", axes(rank.block.begin)},
                         {"size", axes(rank.block.size)},
                         {"interface_cells", rank.interface_cells},
                         {"working_seconds", number(rank.working)},
                         {"waiting_seconds", number(rank.waiting)}});
    return {{"blocks", axes(parallel.blocks)},
            {"imbalance", number(parallel.imbalance())},
            {"waiting_share", number(parallel.waiting_share())},
            {"population_messages_per_step", per_step(parallel.population_messages)},
            {"population_bytes_per_step", per_step(parallel.population_bytes)},
            {"band_messages_per_step", per_step(parallel.band_messages)},
            {"band_bytes_per_step", per_step(parallel.band_bytes)},
            {"ranks", std::move(ranks)}};
}

Json kind_of(const OutputSummary::Kind& kind) {
    return {{"files", kind.files}, {"bytes", number(kind.bytes)}, {"seconds", number(kind.seconds)}};
}

Json output_of(const OutputSummary& output) {
    Json all = kind_of(output.total());
    all["share"] = number(output.share());
    for (const auto& [name, kind] : output.kinds)
        all["kinds"][name] = kind_of(kind);
    return all;
}

} // namespace

OutputSummary::Kind OutputSummary::total() const {
    Kind all;
    for (const auto& [name, kind] : kinds) {
        all.files += kind.files;
        all.bytes += kind.bytes;
        all.seconds += kind.seconds;
    }
    return all;
}

double OutputSummary::share() const {
    return run_seconds > 0.0 ? total().seconds / run_seconds : 0.0;
}

std::string OutputSummary::text() const {
    const auto words = [](const Kind& kind) {
        return fmt::format("{} file{}, {}, {:.1f} s", kind.files, kind.files == 1 ? "" : "s",
                           readable_bytes(kind.bytes), kind.seconds);
    };
    std::string text = fmt::format("output: {} = {:.1f} % of the run", words(total()), 100.0 * share());
    std::string separator = " (";
    for (const auto& [name, kind] : kinds) {
        text += fmt::format("{}{}: {}", separator, name, words(kind));
        separator = "; ";
    }
    return text + (kinds.empty() ? "" : ")");
}

double ParallelSummary::imbalance() const {
    double most = 0.0;
    double sum = 0.0;
    for (const Rank& rank : ranks) {
        most = std::max(most, rank.working);
        sum += rank.working;
    }
    return sum > 0.0 ? most * static_cast<double>(ranks.size()) / sum : 1.0;
}

double ParallelSummary::waiting_share() const {
    double working = 0.0;
    double waiting = 0.0;
    for (const Rank& rank : ranks) {
        working += rank.working;
        waiting += rank.waiting;
    }
    return waiting > 0.0 ? waiting / (working + waiting) : 0.0;
}

std::string ParallelSummary::text() const {
    return fmt::format(
        "{} ranks in {} x {} x {} blocks: the busiest worked {:.2f} times as long as the mean, "
        "{:.0f} % of the steps' time went into waiting",
        ranks.size(), blocks.x, blocks.y, blocks.z, imbalance(), 100.0 * waiting_share());
}

void write_summary(const std::filesystem::path& path, const RunSummary& summary) {
    Json json;
    json["format"] = "vesica-summary-1";
    json["title"] = summary.title;
    json["end"] = summary.end;
    json["reason"] = summary.reason;
    json["first_step"] = summary.first_step;
    json["last_step"] = summary.last_step;
    json["verdicts"] = verdicts_of(summary);
    json["warnings"] = summary.warnings;
    json["lattice"] = {{"size", {summary.size.x, summary.size.y, summary.size.z}},
                       {"precision", summary.precision},
                       {"bytes_allocated", number(summary.bytes_allocated)}};
    json["machine"] = {{"device", summary.device},
                       {"instruction_set", summary.instruction_set},
                       {"threads", summary.threads},
                       {"ranks", summary.ranks}};
    if (!summary.parallel.ranks.empty())
        json["parallel"] = parallel_of(summary.parallel);
    json["mlups"] = number(summary.mlups);
    json["seconds"] = numbers(summary.seconds);
    json["output"] = output_of(summary.output);
    json["profile"] = numbers(summary.profile);
    json["versions"] = summary.versions;
    json["scales"] = scales_of(summary);
    json["dimensionless"] = numbers(summary.dimensionless);
    json["last_metrics"] = metrics_of(summary);
    // Reasons may quote bytes from anywhere; a summary with a replaced character beats none.
    write_atomically(path, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

} // namespace vesica
