#include "io/field_step_file.hpp"

#include "core/input_error.hpp"
#include "io/atomic_file.hpp"
#include "io/compressed_chunks.hpp"
#include "io/hdf5_array.hpp"
#include "io/placed_arrays.hpp"
#include "parallel/agreement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <numeric>
#include <optional>

namespace vesica {
namespace {

using Path = std::filesystem::path;

constexpr const char* vtk_group = "VTKHDF";
constexpr std::uint64_t bytes_of_structure = std::uint64_t{1} << 16;

std::size_t width_of(const SampledField& field) {
    return static_cast<std::size_t>(field.components);
}

/// Slowest first, as HDF5 has it; components only where there are several.
std::vector<hsize_t> shape_of(const Vec3<int>& size, const SampledField& field) {
    std::vector<hsize_t> shape;
    for (const int axis : {2, 1, 0})
        shape.push_back(static_cast<hsize_t>(size[axis]));
    if (field.components > 1)
        shape.push_back(static_cast<hsize_t>(field.components));
    return shape;
}

/// A file that grows on the rank that leads, while the others only have values for it.
class StepFile {
public:
    StepFile(const Path& path, std::uint64_t bytes) : target_(path) {
        require_space(path.parent_path(), bytes);
        target_.try_space(bytes);
        file_ = create_hdf5(target_.temporary(), 0, path);
        target_.reserve(bytes);
    }

    hid_t id() const { return file_; }
    const Path& temporary() const { return target_.temporary(); }
    const FileDescriptor& descriptor() const { return target_.descriptor(); }
    void close() { close_hdf5(file_, target_.target()); }
    void commit() { target_.commit(); }

private:
    AtomicFile target_;
    Hdf5File file_;
};

/// What scripts read.
void describe(hid_t file, const FieldStep& geometry, const Path& path) {
    write_attribute(file, "step", geometry.step, path);
    write_attribute(file, "time", std::array{geometry.time}, path);
    write_attribute(file, "origin", std::array{geometry.origin.x, geometry.origin.y, geometry.origin.z},
                    path);
    write_attribute(file, "spacing", std::array{geometry.spacing}, path);
}

/// What vtkHDFReader reads. Its version of VTK 9.1 cannot read values of cells.
void describe_to_vtk(hid_t file, const FieldStep& geometry, const Path& path) {
    const Hdf5Group image = create_group(file, vtk_group, path);
    const auto last = [&](int axis) {
        return std::int64_t{geometry.count[axis]} - 1;
    };
    const double d = geometry.spacing;
    const Vec3<double> first = geometry.origin + Vec3<double>{0.5 * d, 0.5 * d, 0.5 * d};
    write_attribute(image, "Version", std::array<std::int64_t, 2>{1, 0}, path);
    write_attribute(image, "Type", std::string("ImageData"), path);
    write_attribute(image, "WholeExtent", std::array<std::int64_t, 6>{0, last(0), 0, last(1), 0, last(2)},
                    path);
    write_attribute(image, "Origin", std::array{first.x, first.y, first.z}, path);
    write_attribute(image, "Spacing", std::array{d, d, d}, path);
    write_attribute(image, "Direction", std::array{1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}, path);
    const Hdf5Group values = create_group(image, "PointData", path);
    for (const FieldStep::Array& array : geometry.arrays)
        hdf5_checked(
            H5Lcreate_hard(file, array.name.c_str(), values, array.name.c_str(), H5P_DEFAULT, H5P_DEFAULT),
            path, "cannot write");
}

void write_unit(hid_t array, const SampledField& field, const Path& path) {
    write_attribute(array, "unit", field.unit.empty() ? std::string("lattice") : field.unit, path);
}

void write_plainly(const Path& path, const FieldStep& geometry, const FieldWriting& writing,
                   std::span<const SampledField> fields, const Ranks& ranks) {
    std::optional<StepFile> file;
    PlacedArrays places;
    agree(ranks, [&] {
        if (!ranks.leads())
            return;
        std::uint64_t bytes = bytes_of_structure;
        for (const SampledField& field : fields)
            bytes += static_cast<std::uint64_t>(CellBox{{}, writing.count}.volume()) * width_of(field) *
                     sizeof(float);
        file.emplace(path, bytes);
        describe(file->id(), geometry, path);
        places = {file->temporary(), path, {}};
        for (const SampledField& field : fields) {
            places.offsets.push_back(
                place_array(file->id(), field.name, H5T_IEEE_F32LE, shape_of(writing.count, field), path));
            write_unit(open_array(file->id(), field.name, path), field, path);
        }
        describe_to_vtk(file->id(), geometry, path);
        file->close();
        synchronise(file->descriptor(), path); // for those who write it on other machines
    });
    places = broadcast(ranks, places);
    fill_placed(places, ranks, [&](const FileDescriptor& into, std::size_t array) {
        write_part(into, places.offsets[array], writing.count, writing.part,
                   width_of(fields[array]) * sizeof(float), std::as_bytes(std::span(fields[array].values)),
                   places.target);
    });
    agree(ranks, [&] {
        if (file)
            file->commit();
    });
}

void write_compressed(const Path& path, const FieldStep& geometry, const FieldWriting& writing,
                      std::span<const SampledField> fields, const Ranks& ranks) {
    std::vector<CompressedChunks> compressed;
    std::uint64_t bytes = 0;
    for (const SampledField& field : fields) {
        compressed.emplace_back(writing.count, width_of(field), sizeof(float), writing.part,
                                std::as_bytes(std::span(field.values)), writing.compression, writing.threads,
                                ranks);
        constexpr std::uint64_t page = 4096; // which chunks begin at
        bytes += compressed.back().bytes() + page * compressed.back().own_count();
    }
    ranks.sum({&bytes, 1});
    std::optional<StepFile> file;
    std::vector<Hdf5Dataset> arrays;
    agree(ranks, [&] {
        if (!ranks.leads())
            return;
        file.emplace(path, bytes + bytes_of_structure);
        describe(file->id(), geometry, path);
        for (std::size_t k = 0; k < fields.size(); ++k) {
            arrays.push_back(create_chunked_array(
                file->id(), fields[k].name, H5T_IEEE_F32LE, shape_of(writing.count, fields[k]),
                shape_of(compressed[k].layout().edges(), fields[k]), writing.compression, path));
            write_unit(arrays.back(), fields[k], path);
        }
        describe_to_vtk(file->id(), geometry, path);
    });
    for (std::size_t k = 0; k < fields.size(); ++k)
        agree(ranks, [&] {
            compressed[k].gather(ranks, [&](std::int64_t chunk, std::string_view deflated) {
                std::vector<hsize_t> begin = shape_of(compressed[k].layout().begin(chunk), fields[k]);
                begin.resize(3);
                if (fields[k].components > 1)
                    begin.push_back(0);
                write_chunk(arrays[k], begin, deflated, path);
            });
        });
    agree(ranks, [&] {
        if (!file)
            return;
        for (Hdf5Dataset& array : arrays)
            hdf5_checked(array.close(), path, "cannot write");
        file->close();
        file->commit();
    });
}

} // namespace

FieldStep write_field_step(const Path& path, FieldStep geometry, const FieldWriting& writing,
                           std::span<const SampledField> fields, const Ranks& ranks) {
    const QuietHdf5 quiet;
    geometry.count = writing.count;
    geometry.arrays.clear();
    for (const SampledField& field : fields) {
        assert(field.values.size() == static_cast<std::size_t>(writing.part.volume()) * width_of(field));
        geometry.arrays.push_back({field.name, field.components});
    }
    // In the order in which they are found again.
    std::sort(geometry.arrays.begin(), geometry.arrays.end(),
              [](const FieldStep::Array& a, const FieldStep::Array& b) { return a.name < b.name; });
    (writing.compression > 0 ? write_compressed : write_plainly)(path, geometry, writing, fields, ranks);
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
        if (name == vtk_group)
            continue;
        const auto shape = vesica::shape_of(open_array(file, name, path), path);
        if (shape.size() < 3)
            throw RunError(fmt::format("{}: {} is not a field", path.string(), name));
        found.count = {static_cast<int>(shape[2]), static_cast<int>(shape[1]), static_cast<int>(shape[0])};
        found.arrays.push_back({name, shape.size() == 4 ? static_cast<int>(shape[3]) : 1});
    }
    return found;
}

} // namespace vesica
