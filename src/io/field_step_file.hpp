#pragma once

#include "io/field_samples.hpp"
#include "parallel/ranks.hpp"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace vesica {

/// What the picture of a series needs to know of one step's file.
struct FieldStep {
    std::int64_t step = 0;
    double time = 0.0;
    Vec3<int> count{};
    Vec3<double> origin{};
    double spacing = 1.0;
    struct Array {
        std::string name;
        int components = 1;
    };
    std::vector<Array> arrays;
};

/// How the ranks write it.
struct FieldWriting {
    Vec3<int> count{};   ///< samples of all ranks together
    CellBox part{};      ///< this rank's
    int compression = 1; ///< deflate level after a byte shuffle, 1..9; 0: none
    int threads = 1;
};

/// Writes one HDF5 file, whole or not at all, by all ranks together, each of which has its part of the
/// samples: single precision, arrays [z][y][x] or [z][y][x][component] in the root group, and links to them
/// in a group VTKHDF, by which VTK opens the file as an image whose points are the samples' centres. The same
/// bytes however many ranks there are.
///
/// Without compression each rank writes its part by itself. Compressed chunks have to go through HDF5 and so
/// through the rank that leads, share by share; it is the compressing that takes the time, and all take part.
///
/// On the rank that leads `geometry` holds step, time, origin and spacing as they shall stand in the file;
/// its count and arrays are filled in from the fields and returned. Throws RunError, on all ranks.
FieldStep write_field_step(const std::filesystem::path& path, FieldStep geometry, const FieldWriting& writing,
                           std::span<const SampledField> fields, const Ranks& ranks);

/// Reads all but the values. Throws RunError.
FieldStep read_field_step(const std::filesystem::path& path);

} // namespace vesica
