#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace vesica {

/// The first `count` bytes of a text in base64 (RFC 4648, section 4); fewer where the text ends before. White
/// space is skipped, and padding may stand in the middle, where encoded texts were joined. Nothing if other
/// characters or half a group are met.
std::optional<std::string> decode_base64(std::string_view text, std::size_t count);

/// The bytes in base64, padded, without line breaks.
std::string encode_base64(std::string_view bytes);

} // namespace vesica
