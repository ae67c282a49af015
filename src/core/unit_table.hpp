#pragma once

#include "core/quantity.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace vesica::detail {

/// One unit: how many SI base units it is worth, and of which dimension.
struct Unit {
    double factor = 1.0;
    Dimension dimension;
};

/// The unit of that symbol, with or without a prefix ("um", "mPa", "min"); nothing when it is not known.
std::optional<Unit> find_unit(std::string_view symbol);

/// The symbol somebody meant who wrote `word` ("sec" -> "s", "micron" -> "um", "pa" -> "Pa"); empty if
/// unclear.
std::string meant_unit(std::string_view word);

/// The units that are known, for messages.
std::string_view known_units();

} // namespace vesica::detail
