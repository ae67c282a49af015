#pragma once

#include "case/dense_field.hpp"
#include "core/vec3.hpp"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace vesica {

/// One field of one output.
struct NamedField {
    std::string name;
    const DenseField* field = nullptr; ///< the whole box
    double factor = 1.0;               ///< written value / lattice value
    std::string unit;                  ///< of the written value; empty: lattice units
};

/// Which cells are written: i = begin, begin + stride, ... below end, along each axis.
struct FieldSampling {
    Vec3<int> begin{};
    Vec3<int> end{};
    int stride = 1;

    Vec3<int> count() const;
    /// Lower corner of the first sample in cells. A sample stands for a cube as wide as the stride around its
    /// cell's centre, so that with stride 1 cell i spans [i, i + 1).
    Vec3<double> origin() const;
};

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

/// Writes one HDF5 file, whole or not at all: single precision, arrays [z][y][x] or [z][y][x][component] in
/// the root group. `level`: 0 none, 1..9 deflate. `geometry` holds step, time, origin and spacing as they
/// shall stand in the file; its count and arrays are filled in from the fields and returned. Throws RunError.
FieldStep write_field_step(const std::filesystem::path& path, FieldStep geometry,
                           const FieldSampling& sampling, std::span<const NamedField> fields, int level);

/// Reads all but the values. Throws RunError.
FieldStep read_field_step(const std::filesystem::path& path);

} // namespace vesica
