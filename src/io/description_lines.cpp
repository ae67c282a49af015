#include "io/description_lines.hpp"

#include "io/number_text.hpp"

#include <fmt/format.h>

namespace vesica {

DescriptionLines::DescriptionLines(const std::filesystem::path& path, std::string_view heading)
    : text_(fmt::format("{}: {}\n", path.string(), heading)) {}

DescriptionLines::DescriptionLines(const std::filesystem::path& path, std::string_view heading, bool intact)
    : DescriptionLines(path, fmt::format("{}, {}", heading, intact ? "intact" : "NOT INTACT")) {
    intact_ = intact;
}

void DescriptionLines::add(std::string_view name, std::string_view value) {
    text_ += fmt::format("  {:<12}{}\n", name, value);
}

void DescriptionLines::add(std::string_view name, std::span<const std::string> values) {
    for (const auto& value : values)
        add(&value == values.data() ? name : "", value);
}

std::string readable_bytes(double bytes) {
    if (bytes < 1e3)
        return fmt::format("{:.0f} bytes", bytes);
    if (bytes < 1e6)
        return fmt::format("{:.1f} kB", bytes / 1e3);
    if (bytes < 1e9)
        return fmt::format("{:.1f} MB", bytes / 1e6);
    return fmt::format("{:.1f} GB", bytes / 1e9);
}

std::string readable_steps(std::span<const double> steps) {
    if (steps.empty())
        return "none";
    std::string first, last;
    append_number(first, steps.front());
    append_number(last, steps.back());
    if (steps.size() == 1)
        return "1, at " + first;
    return fmt::format("{}, from {} to {}", steps.size(), first, last);
}

} // namespace vesica
