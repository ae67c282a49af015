#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vesica {

/// `PREFIX000001200SUFFIX`: nine digits, so that names sort like steps; more when a step needs them.
std::string step_name(std::string_view prefix, std::int64_t step, std::string_view suffix);

/// The step in such a name; nothing for any other name.
std::optional<std::int64_t> parse_step_name(std::string_view name, std::string_view prefix,
                                            std::string_view suffix);

/// The steps for which `directory` has such a file, ascending. Empty when there is no directory.
std::vector<std::int64_t> list_steps(const std::filesystem::path& directory, std::string_view prefix,
                                     std::string_view suffix);

} // namespace vesica
