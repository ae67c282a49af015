#include "io/state_file.hpp"

#include "core/input_error.hpp"
#include "io/hdf5_array.hpp"
#include "io/posix_file.hpp"
#include "parallel/agreement.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <type_traits>

namespace vesica {
namespace {

using Path = std::filesystem::path;

/// Takes a rank's part of an array to its places in the file, plane by plane, by plain writes. MPI's own
/// collective writes are not to be trusted with this: Open MPI's have been seen to report success where a
/// rank could not write.
class PartWriter {
public:
    PartWriter(const StateFile& file, const StateHead& head)
        : target_(file.target),
          box_(head.size),
          part_(head.part),
          plane_(static_cast<std::size_t>(part_.size.x) * static_cast<std::size_t>(part_.size.y)),
          file_(open_file(file.temporary, O_WRONLY, "cannot write", file.target)) {}

    template <class Stored, class Value, class CopyPlane>
    void write(std::uint64_t offset, const CopyPlane& copy_plane) const {
        std::vector<Value> values(plane_);
        std::vector<Stored> stored(std::is_same_v<Stored, Value> ? 0 : plane_);
        for (int z = 0; z < part_.size.z; ++z) {
            copy_plane(z, std::span(values));
            if constexpr (std::is_same_v<Stored, Value>) {
                write_plane<Stored>(offset, z, values);
            } else {
                std::transform(values.begin(), values.end(), stored.begin(),
                               [](Value value) { return static_cast<Stored>(value); });
                write_plane<Stored>(offset, z, stored);
            }
        }
        start_writeback(file_);
    }

    void synchronise() const { vesica::synchronise(file_, target_); }

private:
    /// As much at once as lies in one piece.
    template <class T>
    void write_plane(std::uint64_t offset, int z, std::span<const T> plane) const {
        const bool whole = part_.size.x == box_.x;
        const int pieces = whole ? 1 : part_.size.y;
        const std::size_t length = whole ? plane.size() : static_cast<std::size_t>(part_.size.x);
        for (int y = 0; y < pieces; ++y) {
            const std::int64_t first =
                (std::int64_t{part_.begin.z + z} * box_.y + part_.begin.y + y) * box_.x + part_.begin.x;
            const auto piece = plane.subspan(static_cast<std::size_t>(y) * length, length);
            write_at(file_, offset + static_cast<std::uint64_t>(first) * sizeof(T),
                     {reinterpret_cast<const char*>(piece.data()), piece.size_bytes()}, target_);
        }
    }

    const Path& target_;
    Vec3<int> box_;
    CellBox part_;
    std::size_t plane_;
    FileDescriptor file_;
};

template <class CopyPlane>
void write_reals(const PartWriter& writer, std::uint64_t offset, bool as_floats,
                 const CopyPlane& copy_plane) {
    if (as_floats)
        writer.write<float, double>(offset, copy_plane);
    else
        writer.write<double, double>(offset, copy_plane);
}

} // namespace

void write_state(const StateFile& file, const StatePlanes& part, const Ranks& ranks) {
    agree(ranks, [&] {
        const PartWriter writer(file, part.head());
        const std::uint64_t cells = static_cast<std::uint64_t>(CellBox{{}, part.head().size}.volume());
        const std::uint64_t width = file.floats ? sizeof(float) : sizeof(double);
        for (std::size_t i = 0; i < part.population_count(); ++i)
            write_reals(writer, file.populations + i * cells * width, file.floats,
                        [&](int z, std::span<double> plane) { part.population(i, z, plane); });
        for (std::size_t slot = 0; slot < part.slots(); ++slot) {
            write_reals(writer, file.minority + slot * cells * width, file.floats,
                        [&](int z, std::span<double> plane) { part.minority(slot, z, plane); });
            writer.write<std::uint8_t, std::uint8_t>(
                file.band + slot * cells,
                [&](int z, std::span<std::uint8_t> plane) { part.band(slot, z, plane); });
            if (part.is_labelled())
                writer.write<std::int32_t, std::int32_t>(
                    file.label + slot * cells * sizeof(std::int32_t),
                    [&](int z, std::span<std::int32_t> plane) { part.label(slot, z, plane); });
        }
        writer.synchronise();
    });
}

namespace {

/// The part of row `row` of an array of box-shaped rows, or of an array that is one such row.
template <class T>
std::vector<T> read_part(hid_t array, hid_t type, std::size_t row, const Vec3<int>& box, const CellBox& part,
                         const Path& path) {
    std::vector<T> values(static_cast<std::size_t>(part.volume()));
    T* into = values.data();
    for (int z = 0; z < part.size.z; ++z) {
        const std::int64_t first =
            (std::int64_t{part.begin.z + z} * box.y + part.begin.y) * box.x + part.begin.x;
        Hdf5Runs rows;
        rows.first = static_cast<hsize_t>(first);
        rows.stride = static_cast<hsize_t>(box.x);
        rows.count = static_cast<hsize_t>(part.size.y);
        rows.length = static_cast<hsize_t>(part.size.x);
        read_runs(array, type, row, rows, into, path);
        into += rows.count * rows.length;
    }
    return values;
}

Vec3<int> box_of(hid_t file, const Path& path) {
    return {static_cast<int>(read_integer_attribute(file, "size_x", path)),
            static_cast<int>(read_integer_attribute(file, "size_y", path)),
            static_cast<int>(read_integer_attribute(file, "size_z", path))};
}

/// The array has one number per cell, or rows of them.
Hdf5Dataset open_cells(hid_t file, const char* name, const Vec3<int>& box, const Path& path) {
    Hdf5Dataset array = open_array(file, name, path);
    const auto shape = shape_of(array, path);
    if (shape.empty() || shape.back() != static_cast<hsize_t>(CellBox{{}, box}.volume()))
        throw RunError(fmt::format("{}: the array {} is not of a box of {} x {} x {} cells", path.string(),
                                   name, box.x, box.y, box.z));
    return array;
}

/// The part of every row, one behind the other.
template <class T>
std::vector<T> read_rows_of_part(hid_t array, hid_t type, const Vec3<int>& box, const CellBox& part,
                                 const Path& path) {
    const auto shape = shape_of(array, path);
    std::vector<T> values;
    for (std::size_t row = 0; row < (shape.size() > 1 ? shape.front() : 1); ++row) {
        const std::vector<T> more = read_part<T>(array, type, row, box, part, path);
        values.insert(values.end(), more.begin(), more.end());
    }
    return values;
}

} // namespace

EngineState read_state(const Path& path, const CellBox& part) {
    const QuietHdf5 quiet;
    const Hdf5File file = open_hdf5(path);
    EngineState state;
    state.step = read_integer_attribute(file, "step", path);
    state.precision = read_integer_attribute(file, "precision_bits", path) == 32
                          ? Precision::single_precision
                          : Precision::double_precision;
    state.size = box_of(file, path);
    state.part = part;
    const Hdf5Dataset populations = open_cells(file, "populations", state.size, path);
    const std::size_t rows = shape_of(populations, path).front();
    for (std::size_t i = 0; i < rows; ++i)
        state.populations.push_back(
            read_part<double>(populations, H5T_NATIVE_DOUBLE, i, state.size, part, path));
    state.minority = read_rows_of_part<double>(open_cells(file, "minority", state.size, path),
                                               H5T_NATIVE_DOUBLE, state.size, part, path);
    state.band = read_rows_of_part<std::uint8_t>(open_cells(file, "band", state.size, path), H5T_NATIVE_UINT8,
                                                 state.size, part, path);
    if (has_link(file, "label", path))
        state.label = read_rows_of_part<std::int32_t>(open_cells(file, "label", state.size, path),
                                                      H5T_NATIVE_INT32, state.size, part, path);
    const Hdf5Dataset controllers = open_array(file, "controllers", path);
    state.controllers.resize(shape_of(controllers, path).front());
    read_rows(controllers, H5T_NATIVE_DOUBLE, 0, state.controllers.size(), state.controllers.data(), path);
    return state;
}

std::vector<std::uint8_t> read_band(const Path& path, const CellBox& part) {
    const QuietHdf5 quiet;
    const Hdf5File file = open_hdf5(path);
    const Vec3<int> box = box_of(file, path);
    const auto slots = read_rows_of_part<std::uint8_t>(open_cells(file, "band", box, path), H5T_NATIVE_UINT8,
                                                       box, part, path);
    const auto cells = static_cast<std::size_t>(part.volume());
    std::vector<std::uint8_t> band(cells, 0);
    for (std::size_t at = 0; at < slots.size(); ++at)
        band[at % cells] = static_cast<std::uint8_t>(band[at % cells] | slots[at]);
    return band;
}

Digest Colleagues::digest(const Path& file, std::uint64_t offset, std::uint64_t length, const Path& target) {
    return digest_of_file(open_file(file, O_RDONLY, "cannot read", target), offset, length, target);
}

} // namespace vesica
