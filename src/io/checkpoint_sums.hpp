#pragma once

#include "core/cell_box.hpp"
#include "io/placed_arrays.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace vesica {

/// The sums of averages that were under way, in a checkpoint's group "sums": arrays over a box, of which each
/// rank has a part.
struct CheckpointSums {
    struct Array {
        std::string name;
        Vec3<int> count{}; ///< elements along each axis
        int components = 1;
    };
    std::vector<Array> arrays;
    /// Has them written where the file has their places, by all ranks.
    std::function<void(const PlacedArrays&)> write;
};

/// A part of one of them. Throws RunError if it is not of this size.
std::vector<double> read_sums(const std::filesystem::path& checkpoint, const std::string& name,
                              const Vec3<int>& count, const CellBox& part, int components);

} // namespace vesica
