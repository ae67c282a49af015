#include "io/describe_file.hpp"

#include "core/input_error.hpp"
#include "io/checkpoint.hpp"
#include "io/checkpoint_seal.hpp"
#include "io/description_lines.hpp"
#include "io/metrics_table.hpp"
#include "io/posix_file.hpp"
#include "io/toml_tree.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

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

/// What stands at `path`, or nothing.
const TomlNode* find(const TomlNode& root, std::initializer_list<const char*> path) {
    const TomlNode* found = &root;
    for (const char* key : path) {
        const TomlTable* table = found->table();
        found = table == nullptr ? nullptr : find_member(*table, key);
        if (found == nullptr)
            return nullptr;
    }
    return found;
}

std::string title_of(const TomlNode& root) {
    const TomlNode* title = find(root, {"title"});
    const auto* text = title == nullptr ? nullptr : std::get_if<std::string>(&title->value);
    return text == nullptr ? "(no title)" : *text;
}

std::string title_of_case(const std::string& text) {
    try {
        return title_of(parse_toml(text, ""));
    } catch (const InputError&) {
        return "(unreadable)";
    }
}

FileDescription describe_checkpoint(const Path& path) {
    CheckpointSummary summary;
    try {
        summary = summarise_checkpoint(path);
    } catch (const RunError& error) {
        DescriptionLines lines(path, "checkpoint", false);
        lines.add("refused", std::string_view(error.what()).substr(path.string().size() + 2));
        return lines.description();
    }
    DescriptionLines lines(path, "checkpoint", true);
    lines.add("step", std::to_string(summary.step));
    lines.add("lattice",
              fmt::format("{}, {} precision", cells_text(summary.size), name_of(summary.precision)));
    lines.add("case", title_of_case(summary.case_text));
    lines.add("written by", fmt::format("Vesica {}, checkpoint format {}", summary.program_version,
                                        summary.format_version));
    lines.add("size", readable_bytes(static_cast<double>(summary.bytes)));
    lines.add("arrays", summary.arrays);
    return lines.description();
}

FileDescription describe_metrics(const Path& path) {
    const MetricsTable table = read_metrics(path);
    const auto step = table.column("step");
    if (!step)
        refuse(path, "is a table, but not of metrics: it has no column step");
    std::vector<double> steps;
    for (const auto& row : table.rows)
        if (steps.empty() || steps.back() != row[*step])
            steps.push_back(row[*step]);
    DescriptionLines lines(path, table.torn_bytes == 0 ? "metrics" : "metrics, torn at the end",
                           table.torn_bytes == 0);
    lines.add("samples", readable_steps(steps));
    lines.add("rows", std::to_string(table.rows.size()));
    if (table.torn_bytes != 0)
        lines.add("torn", fmt::format("{} bytes after the last row", table.torn_bytes));
    lines.add("columns", fmt::format("{}", fmt::join(table.columns, " ")));
    return lines.description();
}

FileDescription describe_summary(const Path& path) {
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
    return lines.description();
}

FileDescription describe_case(const Path& path) {
    const TomlNode root = parse_toml(read_whole_file(path), path.string());
    const TomlNode* size = find(root, {"lattice", "size"});
    if (size == nullptr || size->array() == nullptr || size->array()->size() != 3)
        refuse(path, "is TOML, but not a case: it has no lattice.size");
    std::vector<std::string> edges;
    for (const TomlNode& edge : *size->array())
        edges.push_back(shown(edge));
    DescriptionLines lines(path, "case");
    lines.add("title", title_of(root));
    lines.add("lattice", fmt::format("{} cells", fmt::join(edges, " x ")));
    std::vector<std::string> types;
    if (const TomlNode* kinds = find(root, {"vesicle_type"}); kinds != nullptr && kinds->table() != nullptr)
        for (const TomlMember& kind : *kinds->table())
            types.push_back(kind.key);
    lines.add("types", types);
    const TomlNode* vesicles = find(root, {"vesicle"});
    const bool several = vesicles != nullptr && vesicles->array() != nullptr;
    lines.add("vesicles", std::to_string(several ? vesicles->array()->size() : 0));
    for (const char* length : {"steps", "time"})
        if (const TomlNode* given = find(root, {"run", length}))
            lines.add(length, shown(*given));
    lines.add("units", find(root, {"units"}) != nullptr ? "given" : "lattice units only");
    return lines.description();
}

} // namespace

FileDescription describe_file(const Path& path) {
    std::error_code none;
    const auto status = std::filesystem::status(path, none);
    if (!exists(status))
        refuse(path, "there is no such file");
    if (is_directory(status))
        refuse(path, "is a directory");
    if (!is_regular_file(status))
        refuse(path, "is not a regular file");
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
