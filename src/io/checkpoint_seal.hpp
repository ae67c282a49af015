#pragma once

#include "io/atomic_file.hpp"
#include "io/block_digest.hpp"
#include "io/state_file.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace vesica {

/// The first 4096 bytes of a checkpoint, which HDF5 leaves alone (its user block):
///
///   0  8 bytes   magic
///   8  uint32    version of the format, little-endian like all numbers here
///  12  uint32    bytes of this seal, 4096
///  16  uint64    bytes after the seal
///  24  uint64    bytes of one digest block
///  32  16 bytes  digest of everything after the seal
///  48  16 bytes  digest of the seal itself with these 16 bytes zero
///  64            a line of text for whoever looks at it with a pager, then zeros
///
/// So every bit of the file is under a digest, and both are verified with plain reads before HDF5 sees the
/// file.
struct CheckpointSeal {
    std::uint32_t format_version = 0;
    std::uint64_t payload_bytes = 0;
    std::string text;
};

inline constexpr std::uint64_t seal_bytes = 4096;
inline constexpr std::uint32_t checkpoint_format_version = 1;

/// Digests what stands behind the seal and writes the seal.
void seal(AtomicFile& file, std::string_view text, Colleagues& colleagues);

/// Reads and verifies the seal and every byte behind it. Throws RunError naming the file and what is wrong
/// with it: no checkpoint, truncated, damaged, or of another version of the format.
CheckpointSeal verify_seal(const std::filesystem::path& path, Colleagues& colleagues);

/// Whether the file begins like a checkpoint, intact or not.
bool looks_like_checkpoint(const std::filesystem::path& path);

} // namespace vesica
