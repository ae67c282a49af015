#include "io/case_file.hpp"
#include "io/case_keys.hpp"
#include "io/case_units.hpp"

#include <fmt/format.h>

namespace vesica {
namespace {

std::string cell(std::string text) {
    for (std::size_t at = text.find('|'); at != std::string::npos; at = text.find('|', at + 2))
        text.insert(at, "\\");
    return text.empty() ? "-" : text;
}

std::string kind_words(const CaseKey& key) {
    switch (key.kind) {
    case KeyKind::text:
        return "text";
    case KeyKind::choice:
        return joined_choices(key.choices, "or", true);
    case KeyKind::choice_or_table:
        return choices_or_table(key);
    case KeyKind::names:
        return "array of " + joined_choices(key.choices, "and", true);
    case KeyKind::boolean:
        return "true or false";
    case KeyKind::integer:
        return "whole number";
    case KeyKind::steps:
        return "whole number of steps, or time";
    case KeyKind::number:
        return "number";
    case KeyKind::cells:
        return "three whole numbers";
    case KeyKind::point:
        return "three numbers";
    case KeyKind::direction:
        return "three numbers, not all zero";
    case KeyKind::degree:
        return "whole number, or [lowest, highest]";
    case KeyKind::region:
        return "[[x, y, z], [x, y, z]], whole numbers";
    }
    return {};
}

std::string power_words(std::string_view unit, int exponent) {
    return exponent == 1 ? std::string(unit) : fmt::format("{}^{}", unit, exponent);
}

/// Both units in which the key is understood; lattice mass is density times cell^3.
std::string unit_words(const CaseKey& key) {
    const Dimension& d = key.dimension;
    if (d == dimension::none)
        return {};
    const std::string si = si_unit(d);
    if (key.si)
        return si + ", always with a unit";
    std::string lattice;
    const Dimension by_density{d.length + 3 * d.mass, d.time, 0};
    if (d.mass != 0)
        lattice = power_words("density", d.mass);
    if (by_density.length != 0)
        lattice += (lattice.empty() ? "" : " ") + power_words("cell", by_density.length);
    if (by_density.time != 0)
        lattice += (lattice.empty() ? "" : " ") + power_words("step", by_density.time);
    return fmt::format("{}; {}", lattice, si);
}

std::string need_words(const CaseKey& key) {
    std::string words = key.need == Need::required      ? "yes"
                        : key.need == Need::optional    ? "no"
                        : key.need == Need::at_most_one ? "at most one way to state " + key.group
                                                        : "exactly one way to state " + key.group;
    if (!key.condition.sibling.empty())
        words += fmt::format("; only with {} = {}", key.condition.sibling,
                             joined_choices(key.condition.values, "or", key.condition.sibling != "l"));
    return words;
}

std::string row(const CaseKey& key) {
    const std::string shown = key.default_value.empty() ? "" : "`" + key.default_value + "`";
    std::string range = range_text(key);
    if (!key.reason.empty())
        range += ", " + key.reason;
    std::string meaning = key.meaning;
    if (!key.example.empty())
        meaning += fmt::format(". Example: `{}`", key.example);
    return fmt::format("| `{}` | {} | {} | {} | {} | {} | {} |\n", key.leaf(), cell(kind_words(key)),
                       cell(unit_words(key)), cell(shown), cell(need_words(key)), cell(range), cell(meaning));
}

/// Optional for the reader, who fills in no defaults there; but a case needs at least one.
bool is_needed_once(const std::string& path) {
    return path == "vesicle_type.*" || path == "vesicle[]";
}

std::string table_title(const std::string& path) {
    if (path.empty())
        return "Top level";
    std::string name = path;
    if (const auto star = name.find('*'); star != std::string::npos)
        name.replace(star, 1, "NAME");
    if (!name.ends_with("[]"))
        return "`[" + name + "]`";
    for (auto at = name.find("[]"); at != std::string::npos; at = name.find("[]"))
        name.erase(at, 2);
    return "`[[" + name + "]]`";
}

} // namespace

std::string case_file_reference() {
    std::string page = R"(# The case file

A case file is TOML 1.0. Numbers are in lattice units: the cell, the step and the fluid's density are 1. A value may also
be a string with a unit (`"3.9 um"`, `"2e-19 J"`, `"100 1/s"`, `"1.2 mPa s"`, also inside arrays), if there are
`[units]`. Each thing is stated in exactly one way: two keys that say the same, or one that is missing, is an error, and
so is a key that is not known. `vesica run --set path=value` overrides a key, with paths such as
`fluid.kinematic_viscosity`, `vesicle[0].radius` or `vesicle_type.rbc.bending.modulus`.

Units are m, s, kg, g, N, Pa, J, Hz, L, P, dyn and erg with a prefix (a f p n u µ m c d k M G T), min and h; products by a
space or `*`, quotients by `/`, powers by `^`.

This page is generated from the declarations that the reader itself uses.
)";
    for (const CaseTable& table : case_tables()) {
        std::string rows;
        for (const CaseKey& key : case_keys()) {
            if (key.table() == table.path)
                rows += row(key);
        }
        if (rows.empty())
            continue;
        page += fmt::format("\n## {}\n\n{}{}\n\n", table_title(table.path), table.meaning,
                            table.optional && !is_needed_once(table.path) ? " Optional." : "");
        page += "| key | type | unit | default | required | range | meaning |\n"
                "| --- | --- | --- | --- | --- | --- | --- |\n" +
                rows;
        if (table.path == "units")
            page += "\n" + units_explanation();
    }
    page += "\n## Not available yet\n\n`device = \"cuda\"` is refused.\n";
    return page;
}

} // namespace vesica
