#include "io/step_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace vesica {

std::string step_name(std::string_view prefix, std::int64_t step, std::string_view suffix) {
    return fmt::format("{}{:09}{}", prefix, step, suffix);
}

std::optional<std::int64_t> parse_step_name(std::string_view name, std::string_view prefix,
                                            std::string_view suffix) {
    if (!name.starts_with(prefix) || !name.ends_with(suffix))
        return std::nullopt;
    if (name.size() < prefix.size() + 9 + suffix.size())
        return std::nullopt;
    const std::string_view digits = name.substr(prefix.size(), name.size() - prefix.size() - suffix.size());
    if (!std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; }))
        return std::nullopt;
    std::int64_t step = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), step);
    if (error != std::errc{})
        return std::nullopt;
    return step;
}

std::vector<std::int64_t> list_steps(const std::filesystem::path& directory, std::string_view prefix,
                                     std::string_view suffix) {
    std::vector<std::int64_t> steps;
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator(directory, none)) {
        const auto step = parse_step_name(entry.path().filename().string(), prefix, suffix);
        if (step)
            steps.push_back(*step);
    }
    std::sort(steps.begin(), steps.end());
    return steps;
}

} // namespace vesica
