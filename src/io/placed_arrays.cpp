#include "io/placed_arrays.hpp"

#include "parallel/agreement.hpp"

#include <fcntl.h>

namespace vesica {

PlacedArrays broadcast(const Ranks& ranks, const PlacedArrays& arrays) {
    PlacedArrays all;
    all.temporary = ranks.broadcast(arrays.temporary.string());
    all.target = ranks.broadcast(arrays.target.string());
    std::uint64_t count = arrays.offsets.size();
    ranks.broadcast(std::as_writable_bytes(std::span(&count, 1)));
    all.offsets = arrays.offsets;
    all.offsets.resize(count);
    ranks.broadcast(std::as_writable_bytes(std::span(all.offsets)));
    return all;
}

void write_part(const FileDescriptor& file, std::uint64_t offset, const Vec3<int>& whole, const CellBox& part,
                std::size_t width, std::span<const std::byte> bytes, const std::filesystem::path& target) {
    if (part.volume() == 0)
        return;
    // As much at once as lies in one piece.
    const bool rows = part.size.x == whole.x;
    const bool planes = rows && part.size.y == whole.y;
    const Vec3<int> pieces{1, rows ? 1 : part.size.y, planes ? 1 : part.size.z};
    const std::size_t length = bytes.size() / static_cast<std::size_t>(pieces.y * std::int64_t{pieces.z});
    for (int z = 0; z < pieces.z; ++z)
        for (int y = 0; y < pieces.y; ++y) {
            const std::size_t first = CellBox{{}, whole}.index_of(part.begin + Vec3<int>{0, y, z});
            write_at(file, offset + first * width, {reinterpret_cast<const char*>(bytes.data()), length},
                     target);
            bytes = bytes.subspan(length);
        }
}

void fill_placed(const PlacedArrays& arrays, const Ranks& ranks,
                 const std::function<void(const FileDescriptor&, std::size_t)>& put) {
    agree(ranks, [&] {
        const FileDescriptor file = open_file(arrays.temporary, O_WRONLY, "cannot write", arrays.target);
        for (std::size_t array = 0; array < arrays.offsets.size(); ++array)
            put(file, array);
        synchronise(file, arrays.target);
    });
}

} // namespace vesica
