#include "simulation/run_summary.hpp"

#include "core/version.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace vesica {

namespace {

// Keys stay in the order in which they are written: the important things first.
using Json = nlohmann::ordered_json;

Json number(double value)
{
    if (!std::isfinite(value)) return nullptr;
    return value;
}

const char* name_of(RunEnd end)
{
    switch (end) {
    case RunEnd::finished: return "finished";
    case RunEnd::steady: return "steady";
    case RunEnd::stopped: return "stopped";
    case RunEnd::failed: return "failed";
    }
    return "failed";
}

Json json_of(const Verdict& verdict)
{
    Json json = {{"name", verdict.name}};
    if (verdict.vesicle >= 0) json["vesicle"] = verdict.vesicle;
    json["question"] = verdict.question;
    json["found"] = number(verdict.found);
    json["expected"] = number(verdict.expected);
    json["tolerance"] = number(verdict.tolerance);
    json["verdict"] = !verdict.passed ? "open" : *verdict.passed ? "pass" : "fail";
    return json;
}

Json json_of(const MetricsRow& row)
{
    Json json;
    for (const std::string& column : metrics_columns()) json[column] = number(metrics_value(row, column));
    return json;
}

Json json_of(const Trouble& trouble)
{
    Json json = {{"step", trouble.step}, {"cell", {trouble.cell.x, trouble.cell.y, trouble.cell.z}}};
    json["vesicle"] = trouble.vesicle >= 0 ? Json(trouble.vesicle) : Json(nullptr);
    json["cause"] = trouble.cause;
    return json;
}

Json scales_of(const Case& what)
{
    if (!what.scales) return nullptr;
    Json json = {{"cell_in_metres", what.scales->cell},
                 {"step_in_seconds", what.scales->step},
                 {"density_in_kg_per_cubic_metre", what.scales->density}};
    if (what.inertia)
        json["inertia"] = {{"reynolds", what.inertia->reynolds},
                           {"true_reynolds", what.inertia->true_reynolds},
                           {"true_density_in_kg_per_cubic_metre", what.inertia->true_density}};
    return json;
}

} // namespace

double RunTimings::mlups() const
{
    return stepping > 0.0 ? 1e-6 * cells * static_cast<double>(steps) / stepping : 0.0;
}

std::string summary_json(const Case& what, const LoopResult& result, int exit_status,
                         const std::vector<Verdict>& verdicts, const RunTimings& timings,
                         const RunCircumstances& circumstances, const std::vector<MetricsRow>& last)
{
    Json json;
    json["title"] = what.title;
    json["end"] = name_of(result.end);
    if (!result.reason.empty()) json["reason"] = result.reason;
    if (result.trouble) json["trouble"] = json_of(*result.trouble);
    json["exit_status"] = exit_status;
    json["steps"] = {{"done", result.step}, {"planned", what.run.steps}};
    json["verdicts"] = Json::array();
    for (const Verdict& verdict : verdicts) json["verdicts"].push_back(json_of(verdict));
    json["mlups"] = number(timings.mlups());
    json["timings"] = {{"total", timings.total},
                       {"setting_up", timings.setting_up},
                       {"stepping", timings.stepping},
                       {"recording", timings.recording},
                       {"steps_timed", timings.steps}};
    json["memory_in_bytes"] = circumstances.bytes_allocated;
    json["interface_fraction"] = number(circumstances.interface_fraction);
    json["versions"] = {{"vesica", version},       {"commit", commit},
                        {"compiler", compiler},    {"build_type", build_type},
                        {"instruction_set", circumstances.instruction_set}, {"threads", circumstances.threads}};
    json["scales"] = scales_of(what);
    json["case"] = {{"file", what.source_file}, {"overrides", what.overrides}};
    json["metrics"] = Json::array();
    for (const MetricsRow& row : last) json["metrics"].push_back(json_of(row));
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace vesica
