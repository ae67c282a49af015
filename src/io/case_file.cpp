#include "io/case_file.hpp"

#include "io/case_build.hpp"
#include "io/case_check.hpp"
#include "io/case_units.hpp"
#include "io/toml_override.hpp"
#include "io/toml_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <system_error>

namespace vesica {
namespace {

constexpr std::size_t largest_file = 4U << 20U;

[[noreturn]] void refuse_file(const std::string& name, const std::string& message, int line = 0,
                              int column = 0) {
    throw InputError(SourcePlace{name, line, column}, message);
}

std::string read_text(const std::filesystem::path& file) {
    const std::string name = file.string();
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (!std::filesystem::exists(status))
        refuse_file(name, "the file does not exist; expected a case file; try vesica new -o case.toml");
    if (std::filesystem::is_directory(status))
        refuse_file(name, "this is a directory; expected a case file; try the case.toml in it");
    std::ifstream stream(file, std::ios::binary);
    if (!stream)
        refuse_file(name, "the file cannot be opened; expected a readable case file; try its permissions");
    // One more than allowed tells whether there is more, also where a size is not known (a pipe).
    std::string text(largest_file + 1, '\0');
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (stream.bad())
        refuse_file(name, "the file cannot be read; expected a readable case file");
    text.resize(static_cast<std::size_t>(stream.gcount()));
    return text;
}

/// Index of the first byte that is not part of well-formed UTF-8 (RFC 3629), or the size.
std::size_t first_invalid_byte(const std::string& text) {
    const auto byte = [&](std::size_t i) {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
    };
    const auto continues = [&](std::size_t i) {
        return (byte(i) & 0xC0U) == 0x80U;
    };
    std::size_t i = 0;
    while (i < text.size()) {
        const unsigned lead = byte(i);
        const unsigned second = byte(i + 1);
        if (lead < 0x80U) {
            i += 1;
        } else if (lead >= 0xC2U && lead <= 0xDFU && continues(i + 1)) {
            i += 2;
        } else if (lead >= 0xE0U && lead <= 0xEFU && continues(i + 1) && continues(i + 2) &&
                   !(lead == 0xE0U && second < 0xA0U) && !(lead == 0xEDU && second > 0x9FU)) {
            i += 3;
        } else if (lead >= 0xF0U && lead <= 0xF4U && continues(i + 1) && continues(i + 2) &&
                   continues(i + 3) && !(lead == 0xF0U && second < 0x90U) &&
                   !(lead == 0xF4U && second > 0x8FU)) {
            i += 4;
        } else {
            return i;
        }
    }
    return i;
}

void check_text(const std::string& text, const std::string& name) {
    if (text.size() > largest_file)
        refuse_file(name,
                    fmt::format("the file has more than {} MiB; expected a case file; try a smaller one",
                                largest_file >> 20U));
    const auto zero = text.find('\0');
    const auto invalid = first_invalid_byte(text);
    if (zero != std::string::npos || invalid < text.size()) {
        const auto at = static_cast<std::ptrdiff_t>(std::min(zero, invalid));
        const auto line = std::count(text.begin(), text.begin() + at, '\n') + 1;
        const auto line_start = text.rfind('\n', static_cast<std::size_t>(at));
        const auto column =
            static_cast<std::size_t>(at) - (line_start == std::string::npos ? 0 : line_start + 1) + 1;
        refuse_file(name,
                    "the text is binary or not UTF-8; expected a case file in UTF-8; try saving it as UTF-8",
                    static_cast<int>(line), static_cast<int>(column));
    }
    if (text.find_first_not_of(" \t\r\n") == std::string::npos)
        refuse_file(name, "the file is empty; expected a case; try vesica new");
}

void record_places(const CaseValues& values, Case& result) {
    for (const auto& [path, place] : values.table_places) {
        if (!path.empty())
            result.places[path] = place;
    }
    for (const auto& [path, value] : values.values) {
        if (value.given)
            result.places[path] = value.place;
    }
}

/// What lattice density and viscosity are is decided by the units as a whole, not by converting one number.
void settle_fluid(CaseValues& values, const CaseUnits& units) {
    const auto settle = [&](const std::string& path, double lattice) {
        if (const auto found = values.values.find(path); found != values.values.end())
            found->second.items.front().value = lattice;
    };
    settle("fluid.density", units.density);
    settle("fluid.kinematic_viscosity", units.kinematic_viscosity);
}

} // namespace

Case read_case(const std::filesystem::path& file, std::span<const std::string> overrides) {
    return read_case_text(read_text(file), file.string(), overrides);
}

Case read_case_text(std::string text, std::string name, std::span<const std::string> overrides) {
    check_text(text, name);
    TomlNode root = parse_toml(text, name);
    for (const std::string& override_ : overrides)
        apply_override(root, parse_override(override_));

    CaseValues values = check_case(root, name);
    check_references(values);
    const CaseUnits units = close_units(values);
    settle_fluid(values, units);
    convert_to_lattice(values, units.scales);

    Case result;
    build_case(values, units, std::filesystem::path(name).parent_path(), result);
    record_places(values, result);
    result.warnings = std::move(values.warnings);
    result.source_file = std::move(name);
    result.source_text = std::move(text);
    result.overrides.assign(overrides.begin(), overrides.end());
    return result;
}

} // namespace vesica
