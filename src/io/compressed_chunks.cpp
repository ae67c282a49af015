#include "io/compressed_chunks.hpp"

#include "core/input_error.hpp"
#include "parallel/agreement.hpp"
#include "parallel/for_each_task.hpp"

#include <zlib.h>

#include <cstring>
#include <exception>
#include <numeric>

namespace vesica {
namespace {

struct Share {
    std::int64_t begin;
    std::int64_t end;
};

Share share_of(std::int64_t chunks, int rank, int ranks) {
    return {chunks * rank / ranks, chunks * (rank + 1) / ranks};
}

/// body(first byte in `whole`, first byte in `part`, bytes) for the rows of `part`, which lies in `whole`.
template <class Body>
void for_each_row(const CellBox& whole, const CellBox& part, std::size_t element, const Body& body) {
    const std::size_t row = static_cast<std::size_t>(part.size.x) * element;
    std::size_t at = 0;
    for (int z = 0; z < part.size.z; ++z)
        for (int y = 0; y < part.size.y; ++y, at += row)
            body(whole.index_of(part.begin + Vec3<int>{0, y, z}) * element, at, row);
}

} // namespace

std::string shuffled_and_deflated(std::span<const std::byte> chunk, std::size_t number, int level) {
    // The numbers' first bytes, then their second bytes, ...: neighbours differ in the last ones only.
    const std::size_t count = chunk.size() / number;
    std::vector<std::byte> shuffled(chunk.size());
    for (std::size_t byte = 0; byte < number; ++byte)
        for (std::size_t k = 0; k < count; ++k)
            shuffled[byte * count + k] = chunk[k * number + byte];
    uLongf length = compressBound(static_cast<uLong>(shuffled.size()));
    std::string deflated(length, '\0');
    if (compress2(reinterpret_cast<Bytef*>(deflated.data()), &length,
                  reinterpret_cast<const Bytef*>(shuffled.data()), static_cast<uLong>(shuffled.size()),
                  level) != Z_OK)
        throw RunError("zlib cannot compress");
    deflated.resize(length);
    deflated.shrink_to_fit();
    return deflated;
}

CompressedChunks::CompressedChunks(const Vec3<int>& box, std::size_t width, std::size_t number,
                                   const CellBox& part, std::span<const std::byte> bytes, int level,
                                   int threads, const Ranks& ranks)
    : layout_(box, width * number) {
    const std::size_t element = width * number;
    const std::vector<CellBox> parts = ranks.gather_all(part);
    const std::vector<std::vector<std::byte>> arrived = exchanged(element, part, bytes, ranks);
    agree(ranks, [&] {
        const Share share = share_of(layout_.count(), ranks.rank(), ranks.count());
        own_.resize(static_cast<std::size_t>(share.end - share.begin));
        // Where in what each rank has sent a chunk's elements begin.
        std::vector<std::vector<std::size_t>> places(own_.size(), std::vector<std::size_t>(parts.size()));
        for (std::size_t from = 0; from < parts.size(); ++from) {
            std::size_t at = 0;
            for (std::int64_t chunk = share.begin; chunk < share.end; ++chunk) {
                places[static_cast<std::size_t>(chunk - share.begin)][from] = at;
                at +=
                    static_cast<std::size_t>(common(layout_.elements(chunk), parts[from]).volume()) * element;
            }
        }
        for_each_task(static_cast<std::int64_t>(own_.size()), threads, [&](std::int64_t k) {
            const auto own = static_cast<std::size_t>(k);
            const std::int64_t chunk = share.begin + k;
            std::vector<std::byte> whole(layout_.bytes());
            for (std::size_t from = 0; from < parts.size(); ++from)
                for_each_row(
                    {layout_.begin(chunk), layout_.edges()}, common(layout_.elements(chunk), parts[from]),
                    element, [&](std::size_t to, std::size_t at, std::size_t length) {
                        std::memcpy(whole.data() + to, arrived[from].data() + places[own][from] + at, length);
                    });
            own_[own] = shuffled_and_deflated(whole, number, level);
        });
    });
}

/// What lies in this rank's share of the chunks, by the ranks it comes from: chunk by chunk, row by row.
std::vector<std::vector<std::byte>> CompressedChunks::exchanged(std::size_t element, const CellBox& part,
                                                                std::span<const std::byte> bytes,
                                                                const Ranks& ranks) const {
    std::vector<std::vector<std::byte>> leaving(static_cast<std::size_t>(ranks.count()));
    for (int to = 0; to < ranks.count(); ++to) {
        std::vector<std::byte>& parcel = leaving[static_cast<std::size_t>(to)];
        const Share share = share_of(layout_.count(), to, ranks.count());
        for (std::int64_t chunk = share.begin; chunk < share.end; ++chunk)
            for_each_row(part, common(layout_.elements(chunk), part), element,
                         [&](std::size_t from, std::size_t, std::size_t length) {
                             const auto row = bytes.subspan(from, length);
                             parcel.insert(parcel.end(), row.begin(), row.end());
                         });
    }
    return ranks.exchange(std::move(leaving));
}

std::size_t CompressedChunks::bytes() const {
    return std::accumulate(own_.begin(), own_.end(), std::size_t{0},
                           [](std::size_t sum, const std::string& chunk) { return sum + chunk.size(); });
}

void CompressedChunks::gather(const Ranks& ranks,
                              const std::function<void(std::int64_t, std::string_view)>& take) const {
    // Lengths first, then the bytes.
    std::string parcel;
    parcel.reserve(bytes() + own_.size() * sizeof(std::uint64_t));
    for (const std::string& chunk : own_) {
        const std::uint64_t length = chunk.size();
        parcel.append(reinterpret_cast<const char*>(&length), sizeof(length));
    }
    for (const std::string& chunk : own_)
        parcel += chunk;
    std::exception_ptr failure;
    ranks.gather(std::as_bytes(std::span(parcel)), [&](int rank, std::span<const std::byte> arrived) {
        if (failure)
            return;
        const Share share = share_of(layout_.count(), rank, ranks.count());
        const auto* const text = reinterpret_cast<const char*>(arrived.data());
        std::size_t at = static_cast<std::size_t>(share.end - share.begin) * sizeof(std::uint64_t);
        for (std::int64_t chunk = share.begin; chunk < share.end; ++chunk) {
            std::uint64_t length = 0;
            std::memcpy(&length, text + static_cast<std::size_t>(chunk - share.begin) * sizeof(length),
                        sizeof(length));
            try {
                take(chunk, {text + at, length});
            } catch (...) {
                failure = std::current_exception();
                return;
            }
            at += length;
        }
    });
    if (failure)
        std::rethrow_exception(failure);
}

} // namespace vesica
