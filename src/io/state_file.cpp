#include "io/state_file.hpp"

#include "core/input_error.hpp"
#include "io/hdf5_array.hpp"
#include "io/posix_file.hpp"
#include "parallel/agreement.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <span>
#include <string_view>

namespace vesica {
namespace {

using Path = std::filesystem::path;

/// A part of a box that lies in memory plane by plane, as runs of cells that lie in one piece in the whole
/// box too: body(first cell in the box, first cell in the part, cells).
template <class Body>
void for_each_run(const Vec3<int>& box, const CellBox& part, const Body& body) {
    const bool whole_rows = part.size.x == box.x;
    const bool whole_planes = whole_rows && part.size.y == box.y;
    const std::int64_t plane = std::int64_t{part.size.x} * part.size.y;
    const auto place = [&](int y, int z) {
        return (std::int64_t{part.begin.z + z} * box.y + part.begin.y + y) * box.x + part.begin.x;
    };
    if (whole_planes) {
        body(place(0, 0), std::int64_t{0}, part.volume());
        return;
    }
    for (int z = 0; z < part.size.z; ++z) {
        if (whole_rows)
            body(place(0, z), z * plane, plane);
        for (int y = 0; y < part.size.y && !whole_rows; ++y)
            body(place(y, z), z * plane + std::int64_t{y} * part.size.x, std::int64_t{part.size.x});
    }
}

/// Takes a rank's part of an array to its places in the file by plain writes. MPI's own collective writes are
/// not to be trusted with this: Open MPI's have been seen to report success where a rank could not write.
class PartWriter {
public:
    PartWriter(const StateFile& file, const EngineState& state)
        : target_(file.target),
          box_(state.size),
          part_(state.part),
          file_(open_file(file.temporary, O_WRONLY, "cannot write")) {}

    template <class T>
    void write(std::uint64_t offset, std::span<const T> values) const {
        for_each_run(box_, part_, [&](std::int64_t place, std::int64_t first, std::int64_t count) {
            const auto run = values.subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(count));
            write_at(file_, offset + static_cast<std::uint64_t>(place) * sizeof(T),
                     {reinterpret_cast<const char*>(run.data()), run.size_bytes()}, target_);
        });
    }

    void write(std::uint64_t offset, const std::vector<double>& values, bool as_floats) const {
        if (as_floats)
            write(offset, std::span<const float>(std::vector<float>(values.begin(), values.end())));
        else
            write(offset, std::span<const double>(values));
    }

    void synchronise() const { vesica::synchronise(file_, target_); }

private:
    const Path& target_;
    Vec3<int> box_;
    CellBox part_;
    FileDescriptor file_;
};

} // namespace

void write_state(const StateFile& file, const EngineState& part, const Ranks& ranks) {
    agree(ranks, [&] {
        const PartWriter writer(file, part);
        const std::uint64_t cells = static_cast<std::uint64_t>(CellBox{{}, part.size}.volume());
        const std::uint64_t width = file.float_populations ? sizeof(float) : sizeof(double);
        for (std::size_t i = 0; i < part.populations.size(); ++i)
            writer.write(file.populations + i * cells * width, part.populations[i], file.float_populations);
        writer.write(file.minority, part.minority, file.float_minority);
        writer.write(file.band, std::span<const std::uint8_t>(part.band));
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
    state.minority = read_part<double>(open_cells(file, "minority", state.size, path), H5T_NATIVE_DOUBLE, 0,
                                       state.size, part, path);
    state.band = read_part<std::uint8_t>(open_cells(file, "band", state.size, path), H5T_NATIVE_UINT8, 0,
                                         state.size, part, path);
    const Hdf5Dataset controllers = open_array(file, "controllers", path);
    state.controllers.resize(shape_of(controllers, path).front());
    read_rows(controllers, H5T_NATIVE_DOUBLE, 0, state.controllers.size(), state.controllers.data(), path);
    return state;
}

std::vector<std::uint8_t> read_band(const Path& path, const CellBox& part) {
    const QuietHdf5 quiet;
    const Hdf5File file = open_hdf5(path);
    const Vec3<int> box = box_of(file, path);
    return read_part<std::uint8_t>(open_cells(file, "band", box, path), H5T_NATIVE_UINT8, 0, box, part, path);
}

Digest Colleagues::digest(const Path& file, std::uint64_t offset, std::uint64_t length, const Path& target) {
    return digest_of_file(open_file(file, O_RDONLY, "cannot read"), offset, length, target);
}

} // namespace vesica
