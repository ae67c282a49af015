#include "io/field_step_file.hpp"

#include "core/input_error.hpp"
#include "io/atomic_file.hpp"
#include "io/hdf5_array.hpp"

#include <fmt/format.h>

#include <array>
#include <cassert>

namespace vesica {
namespace {

using Path = std::filesystem::path;

/// The sampled values of one field, in single precision: pictures need no more.
std::vector<float> sample(const NamedField& named, const FieldSampling& sampling) {
    const DenseField& field = *named.field;
    const auto width = static_cast<std::size_t>(field.components);
    const auto nx = static_cast<std::size_t>(field.size.x), ny = static_cast<std::size_t>(field.size.y);
    std::vector<float> values;
    const Vec3<int> count = sampling.count();
    values.reserve(static_cast<std::size_t>(count.x) * static_cast<std::size_t>(count.y) *
                   static_cast<std::size_t>(count.z) * width);
    for (int z = sampling.begin.z; z < sampling.end.z; z += sampling.stride) {
        for (int y = sampling.begin.y; y < sampling.end.y; y += sampling.stride) {
            const std::size_t row = (static_cast<std::size_t>(z) * ny + static_cast<std::size_t>(y)) * nx;
            for (int x = sampling.begin.x; x < sampling.end.x; x += sampling.stride) {
                const double* value = &field.values[(row + static_cast<std::size_t>(x)) * width];
                for (std::size_t c = 0; c < width; ++c)
                    values.push_back(static_cast<float>(named.factor * value[c]));
            }
        }
    }
    return values;
}

void write_field(hid_t file, const NamedField& named, const FieldSampling& sampling, int level,
                 const Path& path) {
    const Vec3<int> count = sampling.count();
    std::vector<hsize_t> shape = {static_cast<hsize_t>(count.z), static_cast<hsize_t>(count.y),
                                  static_cast<hsize_t>(count.x)};
    if (named.field->components > 1)
        shape.push_back(static_cast<hsize_t>(named.field->components));
    const Hdf5Dataset array = create_array(file, named.name, H5T_IEEE_F32LE, shape, level, path);
    const std::vector<float> values = sample(named, sampling);
    write_rows(array, H5T_NATIVE_FLOAT, 0, shape.front(), values.data(), path);
    write_attribute(array, "unit", named.unit.empty() ? "lattice" : named.unit, path);
}

std::uint64_t bytes_needed(const FieldSampling& sampling, std::span<const NamedField> fields) {
    const Vec3<int> count = sampling.count();
    std::uint64_t components = 0;
    for (const auto& named : fields)
        components += static_cast<std::uint64_t>(named.field->components);
    return components * sizeof(float) * static_cast<std::uint64_t>(count.x) *
               static_cast<std::uint64_t>(count.y) * static_cast<std::uint64_t>(count.z) +
           65536;
}

} // namespace

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

FieldStep write_field_step(const Path& path, FieldStep geometry, const FieldSampling& sampling,
                           std::span<const NamedField> fields, int level) {
    const QuietHdf5 quiet;
    // How much compression saves is not known before.
    if (level == 0)
        require_space(path.parent_path(), bytes_needed(sampling, fields));
    geometry.count = sampling.count();
    geometry.arrays.clear();
    const Hdf5File file = create_hdf5_in_memory(path);
    write_attribute(file, "step", geometry.step, path);
    write_attribute(file, "time", std::array{geometry.time}, path);
    write_attribute(file, "origin", std::array{geometry.origin.x, geometry.origin.y, geometry.origin.z},
                    path);
    write_attribute(file, "spacing", std::array{geometry.spacing}, path);
    for (const NamedField& named : fields) {
        assert(named.field->values.size() == static_cast<std::size_t>(named.field->size.x) *
                                                 static_cast<std::size_t>(named.field->size.y) *
                                                 static_cast<std::size_t>(named.field->size.z) *
                                                 static_cast<std::size_t>(named.field->components));
        write_field(file, named, sampling, level, path);
        geometry.arrays.push_back({named.name, named.field->components});
    }
    write_atomically(path, hdf5_bytes(file, path));
    return geometry;
}

FieldStep read_field_step(const Path& path) {
    const QuietHdf5 quiet;
    const Hdf5File file = open_hdf5(path);
    FieldStep found;
    found.step = read_integer_attribute(file, "step", path);
    const auto time = read_real_attribute(file, "time", path);
    const auto origin = read_real_attribute(file, "origin", path);
    const auto spacing = read_real_attribute(file, "spacing", path);
    if (time.size() != 1 || origin.size() != 3 || spacing.size() != 1)
        throw RunError(fmt::format("{}: is not a file of fields of Vesica", path.string()));
    found.time = time[0];
    found.origin = {origin[0], origin[1], origin[2]};
    found.spacing = spacing[0];
    for (const std::string& name : names_in(file, path)) {
        const auto shape = shape_of(open_array(file, name, path), path);
        if (shape.size() < 3)
            throw RunError(fmt::format("{}: {} is not a field", path.string(), name));
        found.count = {static_cast<int>(shape[2]), static_cast<int>(shape[1]), static_cast<int>(shape[0])};
        found.arrays.push_back({name, shape.size() == 4 ? static_cast<int>(shape[3]) : 1});
    }
    return found;
}

} // namespace vesica
