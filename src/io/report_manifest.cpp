#include "io/report_manifest.hpp"

#include "core/version.hpp"
#include "io/base64.hpp"

#include <fmt/chrono.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>

namespace vesica {
namespace {

using Json = nlohmann::ordered_json;

/// Unit of what a surface file holds, in SI; the page has its own words where the case has no scales.
Dimension dimension_of_surface(std::string_view name) {
    if (name == "mean_curvature")
        return dimension::curvature;
    if (name == "gaussian_curvature")
        return dimension::curvature * dimension::curvature;
    if (name == "velocity")
        return dimension::velocity;
    return dimension::pressure; // forces per membrane area
}

Json quantities() {
    Json list = Json::array();
    for (const ColourQuantity& quantity : colour_quantities()) {
        const Dimension dimension = dimension_of_surface(quantity.unit_like);
        list.push_back({{"name", quantity.name}, {"si_unit", si_unit(dimension)}});
    }
    return list;
}

Json box_of(const ReportRun& run) {
    if (run.resolved) {
        const Parameters& parameters = run.resolved->parameters;
        Json ends = Json::array();
        for (int axis = 0; axis < 3; ++axis)
            ends.push_back(parameters.has_walls(axis) ? "walls"
                           : parameters.is_open(axis) ? "open"
                                                      : "periodic");
        return {{"size", {parameters.size.x, parameters.size.y, parameters.size.z}},
                {"ends", std::move(ends)}};
    }
    const auto summary = Json::parse(run.summary_text, nullptr, false);
    if (summary.is_object() && summary.contains("lattice") && summary["lattice"].contains("size"))
        return {{"size", summary["lattice"]["size"]}};
    return nullptr;
}

Json scales_of(const ReportRun& run) {
    if (run.resolved) {
        if (!run.resolved->scales)
            return nullptr;
        return {{"cell_m", run.resolved->scales->cell},
                {"step_s", run.resolved->scales->step},
                {"density_kg_per_m3", run.resolved->scales->density}};
    }
    const auto summary = Json::parse(run.summary_text, nullptr, false);
    return summary.is_object() && summary.contains("scales") ? summary["scales"] : Json(nullptr);
}

/// Columns of doubles in base64, since a page parses those without delay and without loss; null for a column
/// without a single number.
Json metrics_of(const MetricsTable& table, std::size_t every) {
    static_assert(std::endian::native == std::endian::little, "the page reads little-endian numbers");
    Json columns = Json::array();
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
        std::vector<double> values;
        for (const auto& row : table.rows)
            values.push_back(row[c]);
        const bool any = std::any_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
        Json column{{"name", table.columns[c]}, {"data", nullptr}};
        if (any)
            column["data"] =
                encode_base64({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double)});
        columns.push_back(std::move(column));
    }
    return {{"rows", table.rows.size()}, {"every", every}, {"columns", std::move(columns)}};
}

Json frames_of(const std::vector<ReportFrame>& frames) {
    Json list = Json::array();
    for (const ReportFrame& frame : frames) {
        Json spreads = Json::array();
        for (const ValueSpread& spread : frame.spreads)
            spreads.push_back({spread.low, spread.high});
        list.push_back({{"step", frame.step},
                        {"time", frame.time},
                        {"triangles", frame.triangles},
                        {"spreads", std::move(spreads)}});
    }
    return list;
}

std::string without_angle_brackets(const std::string& json) {
    std::string text;
    for (const char c : json)
        if (c == '<')
            text += "\\u003c";
        else
            text += c;
    return text;
}

} // namespace

std::string report_manifest(const ReportRun& run, const std::vector<ReportFrame>& frames,
                            const ReportMaking& making) {
    const auto now = std::chrono::time_point_cast<std::chrono::seconds>(std::chrono::system_clock::now());
    Json json;
    json["format"] = "vesica-report-1";
    json["live"] = making.live;
    json["made"] = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now));
    json["version"] = version;
    json["commit"] = commit;
    json["directory"] = run.directory;
    json["title"] = run.resolved ? run.resolved->title : std::string{};
    json["state"] = run.state;
    json["planned_steps"] = run.resolved ? Json(run.resolved->run.steps) : Json(nullptr);
    json["box"] = box_of(run);
    json["scales"] = scales_of(run);
    json["quantities"] = quantities();
    json["frames"] = frames_of(frames);
    json["notes"] = run.notes;
    for (const std::string& note : making.notes)
        json["notes"].push_back(note);
    json["metrics"] = metrics_of(run.metrics, making.metrics_every);
    json["summary"] = run.summary_text.empty() ? Json(nullptr) : Json::parse(run.summary_text);
    json["plan"] = making.plan_text;
    json["case"] = run.case_text;
    json["resolved"] = run.resolved_text;
    json["log"] = run.log_text;
    return without_angle_brackets(json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

std::string report_manifest_element(const std::string& manifest) {
    return "<script type=\"application/json\" id=\"vesica-manifest\">" + manifest + "</script>\n";
}

} // namespace vesica
