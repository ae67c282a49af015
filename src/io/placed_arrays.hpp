#pragma once

#include "core/cell_box.hpp"
#include "io/posix_file.hpp"
#include "parallel/ranks.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <vector>

namespace vesica {

/// Arrays of box-shaped contents in a file under construction: HDF5 has laid it out, and whoever has a part
/// of them puts it in its place by plain writes.
struct PlacedArrays {
    std::filesystem::path temporary;    ///< the name the file has so far
    std::filesystem::path target;       ///< in whose name errors are told
    std::vector<std::uint64_t> offsets; ///< array by array, bytes from the beginning of the file
};

/// As the rank that leads has them, to all.
PlacedArrays broadcast(const Ranks& ranks, const PlacedArrays& arrays);

/// Writes a part of an array of whole.x * whole.y * whole.z elements of `width` bytes each, z slowest, then
/// y, x. `bytes` are the part's elements in that order. Throws RunError.
void write_part(const FileDescriptor& file, std::uint64_t offset, const Vec3<int>& whole, const CellBox& part,
                std::size_t width, std::span<const std::byte> bytes, const std::filesystem::path& target);

/// All ranks write their parts, by put(file, place of the array in the list), and wait until they are on the
/// device. If one of them cannot, all throw its RunError.
void fill_placed(const PlacedArrays& arrays, const Ranks& ranks,
                 const std::function<void(const FileDescriptor&, std::size_t)>& put);

} // namespace vesica
