#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace vesica {

/// Appends the shortest decimal text that reads back as the same double (`nan`, `inf`, `-inf` where it is not
/// a number). Whole numbers below 1e15 are written without an exponent, so that steps look like steps.
void append_number(std::string& text, double value);

/// The number that `text` spells in full, or nothing.
std::optional<double> parse_number(std::string_view text);

} // namespace vesica
