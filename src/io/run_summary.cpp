#include "io/run_summary.hpp"

#include "io/atomic_file.hpp"

#include <nlohmann/json.hpp>

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

} // namespace

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
    json["mlups"] = number(summary.mlups);
    json["seconds"] = numbers(summary.seconds);
    json["profile"] = numbers(summary.profile);
    json["versions"] = summary.versions;
    json["scales"] = scales_of(summary);
    json["dimensionless"] = numbers(summary.dimensionless);
    json["last_metrics"] = metrics_of(summary);
    // Reasons may quote bytes from anywhere; a summary with a replaced character beats none.
    write_atomically(path, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

} // namespace vesica
