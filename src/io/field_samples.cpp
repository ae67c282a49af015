#include "io/field_samples.hpp"

#include <algorithm>

namespace vesica {

Vec3<int> FieldSampling::count() const {
    Vec3<int> result;
    for (int axis = 0; axis < 3; ++axis)
        result[axis] = (end[axis] - begin[axis] + stride - 1) / stride;
    return result;
}

Vec3<double> FieldSampling::origin() const {
    Vec3<double> result;
    for (int axis = 0; axis < 3; ++axis)
        result[axis] = begin[axis] + 0.5 * (1 - stride);
    return result;
}

CellBox FieldSampling::samples_in(const CellBox& cells) const {
    CellBox samples;
    const Vec3<int> all = count();
    for (int axis = 0; axis < 3; ++axis) {
        // The first sample at or behind a cell.
        const auto first = [&](int cell) {
            const int distance = std::max(0, cell - begin[axis]);
            return std::min(all[axis], (distance + stride - 1) / stride);
        };
        samples.begin[axis] = first(cells.begin[axis]);
        samples.size[axis] = first(cells.begin[axis] + cells.size[axis]) - samples.begin[axis];
    }
    return samples;
}

std::vector<double> samples_of(const DenseField& field, const Vec3<int>& begin,
                               const FieldSampling& sampling) {
    const CellBox cells{begin, field.size};
    const CellBox samples = sampling.samples_in(cells);
    const auto width = static_cast<std::size_t>(field.components);
    std::vector<double> values;
    values.reserve(static_cast<std::size_t>(samples.volume()) * width);
    Vec3<int> sample;
    const Vec3<int> end = samples.begin + samples.size;
    for (sample.z = samples.begin.z; sample.z < end.z; ++sample.z)
        for (sample.y = samples.begin.y; sample.y < end.y; ++sample.y)
            for (sample.x = samples.begin.x; sample.x < end.x; ++sample.x) {
                const double* value = &field.values[cells.index_of(sampling.cell_of(sample)) * width];
                values.insert(values.end(), value, value + width);
            }
    return values;
}

} // namespace vesica
