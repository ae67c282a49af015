#include "io/base64.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace vesica {
namespace {

constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::uint8_t no_digit = 255;

constexpr std::array<std::uint8_t, 256> values = [] {
    std::array<std::uint8_t, 256> table{};
    table.fill(no_digit);
    for (std::size_t i = 0; i < digits.size(); ++i)
        table[static_cast<unsigned char>(digits[i])] = static_cast<std::uint8_t>(i);
    return table;
}();

bool is_space(char c) {
    return c == ' ' || (c >= '\t' && c <= '\r');
}

} // namespace

std::optional<std::string> decode_base64(std::string_view text, std::size_t count) {
    std::string bytes;
    std::uint32_t bits = 0;
    int length = 0, padding = 0; // characters in the group so far, and how many of them are '='
    for (const char c : text) {
        if (length == 0 && bytes.size() >= count)
            break;
        if (is_space(c))
            continue;
        const std::uint8_t value = values[static_cast<unsigned char>(c)];
        if (c == '=' ? length < 2 : value == no_digit || padding > 0)
            return std::nullopt;
        padding += c == '=' ? 1 : 0;
        bits = bits << 6 | (c == '=' ? 0u : value);
        if (++length < 4)
            continue;
        for (int k = 0; k < 3 - padding; ++k)
            bytes += static_cast<char>(bits >> (16 - 8 * k) & 255u);
        bits = 0;
        length = padding = 0;
    }
    if (length != 0)
        return std::nullopt;
    if (bytes.size() > count)
        bytes.resize(count);
    return bytes;
}

std::string encode_base64(std::string_view bytes) {
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k)
            bits = bits << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k)
            text += k <= count ? digits[bits >> (18 - 6 * k) & 63u] : '=';
    }
    return text;
}

} // namespace vesica
