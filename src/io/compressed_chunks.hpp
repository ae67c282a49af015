#pragma once

#include "io/chunk_layout.hpp"
#include "parallel/ranks.hpp"

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vesica {

/// An array that several ranks have parts of, compressed by all of them: each takes its share of the chunks,
/// gets what lies in them from the others, and shuffles and deflates them as HDF5's filters would.
class CompressedChunks {
public:
    /// `part` of the box is this rank's, `bytes` its elements, z slowest, then y, x, each of width numbers of
    /// `number` bytes. By all ranks together.
    CompressedChunks(const Vec3<int>& box, std::size_t width, std::size_t number, const CellBox& part,
                     std::span<const std::byte> bytes, int level, int threads, const Ranks& ranks);

    const ChunkLayout& layout() const { return layout_; }
    /// Of this rank's share.
    std::size_t bytes() const;
    std::size_t own_count() const { return own_.size(); }
    /// To the rank that leads: take(chunk, its bytes), in order. What `take` throws is thrown once all have
    /// come, so that the others can let go of theirs. By all ranks together.
    void gather(const Ranks& ranks, const std::function<void(std::int64_t, std::string_view)>& take) const;

private:
    std::vector<std::vector<std::byte>> exchanged(std::size_t element, const CellBox& part,
                                                  std::span<const std::byte> bytes, const Ranks& ranks) const;

    ChunkLayout layout_;
    std::vector<std::string> own_; ///< this rank's share, in order
};

/// What HDF5's shuffle and deflate filters make of a chunk of numbers.
std::string shuffled_and_deflated(std::span<const std::byte> chunk, std::size_t number, int level);

} // namespace vesica
