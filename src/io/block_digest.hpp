#pragma once

#include "io/posix_file.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace vesica {

/// XXH3-128 in canonical (big-endian) form: it finds damage, it does not resist forgery.
using Digest = std::array<unsigned char, 16>;

/// Files are digested in blocks of this size: digest = XXH3-128(XXH3-128(block 0), XXH3-128(block 1), ...).
/// So several ranks can digest one file, each its share of the blocks, with the same result.
inline constexpr std::uint64_t digest_block_bytes = std::uint64_t{4} << 20;

Digest digest_of(std::string_view bytes);

/// Digest of the blocks' digests in order.
Digest combine_digests(std::span<const Digest> blocks);

/// How many blocks there are in so many bytes.
constexpr std::uint64_t digest_blocks(std::uint64_t length) {
    return (length + digest_block_bytes - 1) / digest_block_bytes;
}

/// Digests of blocks [first, last) of the `length` bytes of a file from `offset`, by plain reads. Throws
/// RunError when they cannot be read.
std::vector<Digest> digests_of_blocks(const FileDescriptor& file, std::uint64_t offset, std::uint64_t length,
                                      std::uint64_t first, std::uint64_t last,
                                      const std::filesystem::path& path);

/// Digest of `length` bytes of a file from `offset`, by plain reads. Throws RunError when they cannot be
/// read.
Digest digest_of_file(const FileDescriptor& file, std::uint64_t offset, std::uint64_t length,
                      const std::filesystem::path& path);

} // namespace vesica
