#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstring>

namespace vesica {

/// A number from the bytes of a file written in the given order. `bytes` need not be aligned.
template <class T>
T from_bytes(const char* bytes, std::endian order) {
    char raw[sizeof(T)];
    std::memcpy(raw, bytes, sizeof(T));
    if (order != std::endian::native)
        std::reverse(raw, raw + sizeof(T));
    T value;
    std::memcpy(&value, raw, sizeof(T));
    return value;
}

} // namespace vesica
