#include "io/block_digest.hpp"

#include "core/input_error.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

namespace vesica {

Digest digest_of(std::string_view bytes) {
    XXH128_canonical_t canonical;
    XXH128_canonicalFromHash(&canonical, XXH3_128bits(bytes.data(), bytes.size()));
    Digest digest;
    static_assert(sizeof(canonical.digest) == std::tuple_size_v<Digest>);
    std::memcpy(digest.data(), canonical.digest, digest.size());
    return digest;
}

Digest combine_digests(std::span<const Digest> blocks) {
    return digest_of({reinterpret_cast<const char*>(blocks.data()), blocks.size_bytes()});
}

std::vector<Digest> digests_of_blocks(const FileDescriptor& file, std::uint64_t offset, std::uint64_t length,
                                      std::uint64_t first, std::uint64_t last,
                                      const std::filesystem::path& path) {
    std::vector<Digest> blocks;
    std::string buffer(static_cast<std::size_t>(std::min(length, digest_block_bytes)), '\0');
    for (std::uint64_t block = first; block < last; ++block) {
        const std::uint64_t begin = block * digest_block_bytes;
        const auto count = static_cast<std::size_t>(std::min(length - begin, digest_block_bytes));
        if (read_at(file, offset + begin, buffer.data(), count, path) != count)
            throw RunError(fmt::format("{}: became shorter while it was read", path.string()));
        blocks.push_back(digest_of({buffer.data(), count}));
    }
    return blocks;
}

Digest digest_of_file(const FileDescriptor& file, std::uint64_t offset, std::uint64_t length,
                      const std::filesystem::path& path) {
    return combine_digests(digests_of_blocks(file, offset, length, 0, digest_blocks(length), path));
}

} // namespace vesica
