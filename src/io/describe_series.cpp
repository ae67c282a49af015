#include "core/input_error.hpp"
#include "io/description_lines.hpp"
#include "io/field_step_file.hpp"
#include "io/hdf5_array.hpp"
#include "io/number_text.hpp"
#include "io/posix_file.hpp"

#include <fmt/format.h>

#include <algorithm>

/// `vesica info` for the files that make up series in time. Only files as Vesica writes them need be
/// understood, so plain searches serve instead of an XML parser.
namespace vesica {
namespace {

using Path = std::filesystem::path;

/// Everything that stands between `before` and `after`, in order.
std::vector<std::string> all_between(std::string_view text, std::string_view before, std::string_view after) {
    std::vector<std::string> found;
    while (true) {
        const std::size_t begin = text.find(before);
        if (begin == std::string_view::npos)
            return found;
        text.remove_prefix(begin + before.size());
        const std::size_t end = text.find(after);
        if (end == std::string_view::npos)
            return found;
        found.emplace_back(text.substr(0, end));
    }
}

std::string first_between(std::string_view text, std::string_view before, std::string_view after) {
    const auto found = all_between(text, before, after);
    return found.empty() ? std::string("(none)") : found.front();
}

std::vector<double> numbers_of(const std::vector<std::string>& texts) {
    std::vector<double> numbers;
    for (const auto& text : texts)
        if (const auto number = parse_number(text))
            numbers.push_back(*number);
    return numbers;
}

void remove_repeats(std::vector<std::string>& texts) {
    std::sort(texts.begin(), texts.end());
    texts.erase(std::unique(texts.begin(), texts.end()), texts.end());
}

[[noreturn]] void refuse(const Path& path, std::string_view what) {
    throw InputError(fmt::format("{}: is not {} that Vesica wrote", path.string(), what));
}

void add_step(DescriptionLines& lines, const FieldStep& step) {
    lines.add("samples",
              fmt::format("{} x {} x {}, {} apart, from {}, {}, {}", step.count.x, step.count.y, step.count.z,
                          step.spacing, step.origin.x, step.origin.y, step.origin.z));
    std::vector<std::string> arrays;
    for (const auto& array : step.arrays)
        arrays.push_back(fmt::format("{}{}", array.name, array.components == 1 ? "" : ", vector"));
    lines.add("fields", arrays);
}

/// Reads every step's file that an index names; collects what is wrong.
std::vector<FieldStep> read_steps(const Path& directory, const std::vector<std::string>& files,
                                  std::vector<std::string>& missing) {
    std::vector<FieldStep> steps;
    for (const auto& file : files) {
        try {
            steps.push_back(read_field_step(directory / file));
        } catch (const RunError& error) {
            missing.emplace_back(error.what());
        }
    }
    return steps;
}

FileDescription describe_field_files(const Path& path, std::string_view kind,
                                     const std::vector<std::string>& files) {
    std::vector<std::string> missing;
    const auto steps = read_steps(path.parent_path(), files, missing);
    DescriptionLines lines(path, kind, missing.empty());
    std::vector<double> numbers, times;
    for (const auto& step : steps) {
        numbers.push_back(static_cast<double>(step.step));
        times.push_back(step.time);
    }
    lines.add("steps", readable_steps(numbers));
    lines.add("times", readable_steps(times));
    if (!steps.empty())
        add_step(lines, steps.back());
    lines.add("unreadable", missing);
    return lines.description();
}

} // namespace

FileDescription describe_fields_index(const Path& path) {
    const std::string text = read_whole_file(path);
    if (text.find("<Xdmf") == std::string::npos)
        refuse(path, "a series of fields");
    auto files = all_between(text, "Format=\"HDF\">", ":/");
    remove_repeats(files);
    return describe_field_files(path, "series of fields for ParaView", files);
}

FileDescription describe_fields(const Path& path) {
    const QuietHdf5 quiet;
    if (H5Fis_hdf5(path.c_str()) <= 0)
        refuse(path, "an HDF5 file");
    const Hdf5File file = open_hdf5(path);
    if (H5Aexists(file, "step") > 0) {
        const FieldStep step = read_field_step(path);
        DescriptionLines lines(path, "fields of one step");
        lines.add("step", std::to_string(step.step));
        lines.add("time", fmt::format("{}", step.time));
        add_step(lines, step);
        return lines.description();
    }
    std::vector<std::string> files;
    for (const std::string& name : names_in(file, path)) {
        if (!name.starts_with("step_"))
            refuse(path, "a file of fields");
        files.push_back("fields/" + name + ".h5");
    }
    return describe_field_files(path, "series of fields", files);
}

FileDescription describe_surface(const Path& path) {
    const std::string text = read_whole_file(path);
    const std::string_view head = std::string_view(text).substr(0, text.find("<AppendedData"));
    if (head.find("type=\"PolyData\"") == std::string_view::npos)
        refuse(path, "a surface");
    const bool whole = text.ends_with("</VTKFile>\n");
    DescriptionLines lines(path, "surfaces of the vesicles", whole);
    lines.add("points", first_between(head, "NumberOfPoints=\"", "\""));
    lines.add("triangles", first_between(head, "NumberOfPolys=\"", "\""));
    lines.add("quantities", all_between(first_between(head, "<PointData>", "</PointData>"), "Name=\"", "\""));
    if (!whole)
        lines.add("truncated",
                  fmt::format("{} is all that is left", readable_bytes(static_cast<double>(text.size()))));
    return lines.description();
}

FileDescription describe_surface_index(const Path& path) {
    const std::string text = read_whole_file(path);
    if (text.find("type=\"Collection\"") == std::string::npos)
        refuse(path, "a series of surfaces");
    std::vector<std::string> missing;
    for (const auto& file : all_between(text, "file=\"", "\""))
        if (!std::filesystem::exists(path.parent_path() / file))
            missing.push_back(file);
    DescriptionLines lines(path, "series of surfaces for ParaView", missing.empty());
    lines.add("times", readable_steps(numbers_of(all_between(text, "timestep=\"", "\""))));
    lines.add("missing", missing);
    return lines.description();
}

} // namespace vesica
