#pragma once

#include "case/dense_field.hpp"
#include "core/cell_box.hpp"

#include <string>
#include <vector>

namespace vesica {

/// Which cells are written: i = begin, begin + stride, ... below end, along each axis. Sample k is the k-th
/// of them.
struct FieldSampling {
    Vec3<int> begin{};
    Vec3<int> end{};
    int stride = 1;

    Vec3<int> count() const;
    /// Lower corner of the first sample in cells. A sample stands for a cube as wide as the stride around its
    /// cell's centre, so that with stride 1 cell i spans [i, i + 1).
    Vec3<double> origin() const;
    /// The samples among these cells: a box of samples, of no size where there are none.
    CellBox samples_in(const CellBox& cells) const;
    Vec3<int> cell_of(const Vec3<int>& sample) const { return begin + stride * sample; }
};

/// One field's samples: those of one rank, z slowest, then y, x, components fastest. Pictures need no more
/// than single precision.
struct SampledField {
    std::string name;
    int components = 1;
    std::string unit; ///< of the values; empty: lattice units
    std::vector<float> values;
};

/// The samples that a field has which begins at cell `begin`.
std::vector<double> samples_of(const DenseField& field, const Vec3<int>& begin,
                               const FieldSampling& sampling);

} // namespace vesica
