#include "io/number_text.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace vesica {

void append_number(std::string& text, double value) {
    if (std::isnan(value)) {
        text += "nan"; // never "-nan": the sign of a NaN means nothing
        return;
    }
    std::array<char, 32> buffer{};
    const bool whole = std::abs(value) < 1e15 && std::trunc(value) == value;
    const auto result = whole ? std::to_chars(buffer.begin(), buffer.end(), value, std::chars_format::fixed)
                              : std::to_chars(buffer.begin(), buffer.end(), value);
    text.append(buffer.data(), static_cast<std::size_t>(result.ptr - buffer.data()));
}

std::optional<double> parse_number(std::string_view text) {
    if (text == "nan")
        return std::numeric_limits<double>::quiet_NaN();
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size())
        return std::nullopt;
    return value;
}

} // namespace vesica
