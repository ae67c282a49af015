#include "io/checkpoint_seal.hpp"

#include "core/input_error.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cstring>

namespace vesica {
namespace {

// A byte beyond ASCII, a carriage return and a newline: a transfer in text mode breaks it visibly (as in
// PNG).
constexpr std::string_view magic("\x89VSC\r\n\x1a\n", 8);
constexpr std::size_t version_at = 8, size_at = 12, payload_at = 16, block_at = 24, digest_at = 32;
constexpr std::size_t own_digest_at = 48, text_at = 64;

void put_number(std::string& bytes, std::size_t at, std::uint64_t value, std::size_t width) {
    for (std::size_t i = 0; i < width; ++i)
        bytes[at + i] = static_cast<char>((value >> (8 * i)) & 0xff);
}

std::uint64_t get_number(std::string_view bytes, std::size_t at, std::size_t width) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < width; ++i)
        value |= std::uint64_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
    return value;
}

void put_digest(std::string& bytes, std::size_t at, const Digest& digest) {
    std::memcpy(bytes.data() + at, digest.data(), digest.size());
}

bool has_digest(std::string_view bytes, std::size_t at, const Digest& digest) {
    return std::memcmp(bytes.data() + at, digest.data(), digest.size()) == 0;
}

template <class... Arguments>
[[noreturn]] void refuse(const std::filesystem::path& path, fmt::format_string<Arguments...> reason,
                         Arguments&&... arguments) {
    throw RunError(path.string() + ": " + fmt::format(reason, std::forward<Arguments>(arguments)...));
}

} // namespace

void seal(AtomicFile& file, std::string_view text, Colleagues& colleagues) {
    const std::uint64_t length = length_of(file.descriptor(), file.target());
    assert(length >= seal_bytes && text.size() < seal_bytes - text_at);
    std::string block(seal_bytes, '\0');
    block.replace(0, magic.size(), magic);
    put_number(block, version_at, checkpoint_format_version, 4);
    put_number(block, size_at, seal_bytes, 4);
    put_number(block, payload_at, length - seal_bytes, 8);
    put_number(block, block_at, digest_block_bytes, 8);
    put_digest(block, digest_at,
               colleagues.digest(file.temporary(), seal_bytes, length - seal_bytes, file.target()));
    block.replace(text_at, text.size(), text);
    put_digest(block, own_digest_at, digest_of(block));
    file.write_at(0, block);
}

CheckpointSeal verify_seal(const std::filesystem::path& path, Colleagues& colleagues) {
    const FileDescriptor file = open_file(path, O_RDONLY, "cannot open");
    const std::uint64_t length = length_of(file, path);
    std::string block(seal_bytes, '\0');
    block.resize(read_at(file, 0, block.data(), block.size(), path));
    const std::size_t compared = std::min(block.size(), magic.size());
    if (block.empty())
        refuse(path, "is empty");
    if (block.compare(0, compared, magic.substr(0, compared)) != 0)
        refuse(path, "is not a checkpoint of Vesica");
    if (block.size() < seal_bytes)
        refuse(path, "is truncated: {} bytes are left, its seal alone has {}", block.size(), seal_bytes);

    std::string without_own_digest = block;
    without_own_digest.replace(own_digest_at, sizeof(Digest), sizeof(Digest), '\0');
    if (!has_digest(block, own_digest_at, digest_of(without_own_digest)))
        refuse(path, "is damaged: the first {} bytes do not agree with their digest", seal_bytes);

    CheckpointSeal found;
    found.format_version = static_cast<std::uint32_t>(get_number(block, version_at, 4));
    found.payload_bytes = get_number(block, payload_at, 8);
    found.text = block.c_str() + text_at;
    if (found.format_version != checkpoint_format_version)
        refuse(path, "has version {} of the checkpoint format; this program reads version {}",
               found.format_version, checkpoint_format_version);
    const std::uint64_t promised = found.payload_bytes + seal_bytes;
    if (length < promised)
        refuse(path, "is truncated: {} of {} bytes are left", length, promised);
    if (length > promised)
        refuse(path, "is damaged: {} bytes follow its end", length - promised);
    if (!has_digest(block, digest_at, colleagues.digest(path, seal_bytes, found.payload_bytes, path)))
        refuse(path, "is damaged: its content does not agree with its digest");
    return found;
}

bool looks_like_checkpoint(const std::filesystem::path& path) {
    const FileDescriptor file = open_file(path, O_RDONLY, "cannot open");
    std::string start(magic.size(), '\0');
    start.resize(read_at(file, 0, start.data(), start.size(), path));
    return start == magic;
}

} // namespace vesica
