#include "io/describe_file.hpp"

#include "core/input_error.hpp"
#include "io/checkpoint.hpp"
#include "io/checkpoint_seal.hpp"
#include "io/description_lines.hpp"
#include "io/metrics_table.hpp"
#include "io/posix_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <toml++/toml.h>

namespace vesica {
namespace {

using Path = std::filesystem::path;

[[noreturn]] void refuse(const Path& path, std::string_view reason) {
    throw InputError(fmt::format("{}: {}; expected a case (.toml) or a file that a run of Vesica leaves: "
                                 "metrics.csv, summary.json, fields.xmf, .h5, .vtp, .pvd",
                                 path.string(), reason));
}

std::string cells_text(const Vec3<int>& size) {
    return fmt::format("{} x {} x {} cells", size.x, size.y, size.z);
}

std::string title_of_case(const std::string& text) {
    try {
        return toml::parse(text)["title"].value_or(std::string("(no title)"));
    } catch (const toml::parse_error&) {
        return "(unreadable)";
    }
}

std::string describe_checkpoint(const Path& path) {
    CheckpointSummary summary;
    try {
        summary = summarise_checkpoint(path);
    } catch (const RunError& error) {
        DescriptionLines lines(path, "checkpoint, NOT INTACT");
        lines.add("refused", std::string_view(error.what()).substr(path.string().size() + 2));
        return lines.text();
    }
    const bool single = summary.precision == Precision::single_precision;
    DescriptionLines lines(path, "checkpoint, intact");
    lines.add("step", std::to_string(summary.step));
    lines.add("lattice",
              fmt::format("{}, {} precision", cells_text(summary.size), single ? "single" : "double"));
    lines.add("case", title_of_case(summary.case_text));
    lines.add("written by", fmt::format("Vesica {}, checkpoint format {}", summary.program_version,
                                        summary.format_version));
    lines.add("size", readable_bytes(static_cast<double>(summary.bytes)));
    lines.add("arrays", summary.arrays);
    return lines.text();
}

std::string describe_metrics(const Path& path) {
    const MetricsTable table = read_metrics(path);
    const auto step = table.column("step");
    if (!step)
        refuse(path, "is a table, but not of metrics: it has no column step");
    std::vector<double> steps;
    for (const auto& row : table.rows)
        if (steps.empty() || steps.back() != row[*step])
            steps.push_back(row[*step]);
    DescriptionLines lines(path, table.torn_bytes == 0 ? "metrics, intact" : "metrics, torn at the end");
    lines.add("samples", readable_steps(steps));
    lines.add("rows", std::to_string(table.rows.size()));
    if (table.torn_bytes != 0)
        lines.add("torn", fmt::format("{} bytes after the last row", table.torn_bytes));
    lines.add("columns", fmt::format("{}", fmt::join(table.columns, " ")));
    return lines.text();
}

std::string describe_summary(const Path& path) {
    const auto json = nlohmann::json::parse(read_whole_file(path), nullptr, false);
    if (!json.is_object() || json.value("format", "") != "vesica-summary-1")
        refuse(path, "is not the summary of a run");
    DescriptionLines lines(path, "summary of a run");
    lines.add("title", json.at("title").get<std::string>());
    const auto reason = json.at("reason").get<std::string>();
    lines.add("end", json.at("end").get<std::string>() + (reason.empty() ? "" : ": " + reason));
    lines.add("steps", fmt::format("{} to {}", json.at("first_step").get<std::int64_t>(),
                                   json.at("last_step").get<std::int64_t>()));
    if (json.at("mlups").is_number())
        lines.add("MLUPS", fmt::format("{:.1f}", json.at("mlups").get<double>()));
    std::vector<std::string> verdicts, versions;
    for (const auto& verdict : json.at("verdicts"))
        verdicts.push_back(fmt::format("{}: {}, {}", verdict.at("passed").get<bool>() ? "passed" : "FAILED",
                                       verdict.at("name").get<std::string>(),
                                       verdict.at("text").get<std::string>()));
    for (const auto& [name, version] : json.at("versions").items())
        versions.push_back(fmt::format("{} {}", name, version.get<std::string>()));
    lines.add("verdicts", verdicts);
    lines.add("versions", versions);
    return lines.text();
}

std::string describe_case(const Path& path) {
    toml::table table;
    try {
        table = toml::parse(read_whole_file(path), path.string());
    } catch (const toml::parse_error& error) {
        const auto& at = error.source().begin;
        throw InputError(SourcePlace{path.string(), static_cast<int>(at.line), static_cast<int>(at.column)},
                         fmt::format("is not TOML: {}", error.description()));
    }
    const auto* size = table["lattice"]["size"].as_array();
    if (size == nullptr || size->size() != 3)
        refuse(path, "is TOML, but not a case: it has no lattice.size");
    DescriptionLines lines(path, "case");
    lines.add("title", table["title"].value_or(std::string("(no title)")));
    lines.add("lattice",
              cells_text({(*size)[0].value_or(0), (*size)[1].value_or(0), (*size)[2].value_or(0)}));
    std::vector<std::string> types;
    if (const auto* kinds = table["vesicle_type"].as_table())
        for (const auto& [name, kind] : *kinds)
            types.emplace_back(name.str());
    lines.add("types", types);
    const auto* vesicles = table["vesicle"].as_array();
    lines.add("vesicles", std::to_string(vesicles == nullptr ? 0 : vesicles->size()));
    if (const auto steps = table["run"]["steps"].value<std::int64_t>())
        lines.add("steps", std::to_string(*steps));
    lines.add("units", table.contains("units") ? "given" : "lattice units only");
    return lines.text();
}

} // namespace

std::string describe_file(const Path& path) {
    std::error_code none;
    const auto status = std::filesystem::status(path, none);
    if (!exists(status))
        refuse(path, "there is no such file");
    if (is_directory(status))
        refuse(path, "is a directory");
    const std::string ending = path.extension().string();
    try {
        if (ending == ".toml")
            return describe_case(path);
        if (ending == ".csv")
            return describe_metrics(path);
        if (ending == ".json")
            return describe_summary(path);
        if (ending == ".xmf")
            return describe_fields_index(path);
        if (ending == ".vtp")
            return describe_surface(path);
        if (ending == ".pvd")
            return describe_surface_index(path);
        // A checkpoint whose first bytes are damaged is still to be called a damaged checkpoint.
        if (looks_like_checkpoint(path) ||
            (ending == ".h5" && path.parent_path().filename() == "checkpoints"))
            return describe_checkpoint(path);
        if (ending == ".h5")
            return describe_fields(path);
    } catch (const nlohmann::json::exception&) {
        refuse(path, "is not a complete summary of a run");
    }
    refuse(path, "is of no kind known");
}

} // namespace vesica
