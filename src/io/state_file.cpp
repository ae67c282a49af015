#include "io/state_file.hpp"

#include "core/input_error.hpp"
#include "io/hdf5_array.hpp"
#include "io/posix_file.hpp"
#include "parallel/communicator.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <functional>
#include <span>
#include <type_traits>

namespace vesica {
namespace {

using Path = std::filesystem::path;

/// Takes a part of an array of the whole box to its place in the file.
class PartWriter {
public:
    PartWriter() = default;
    PartWriter(const PartWriter&) = delete;
    PartWriter& operator=(const PartWriter&) = delete;
    virtual ~PartWriter() = default;

    virtual void write(std::uint64_t offset, std::span<const double> values) = 0;
    virtual void write(std::uint64_t offset, std::span<const float> values) = 0;
    virtual void write(std::uint64_t offset, std::span<const std::uint8_t> values) = 0;
    virtual void finish() = 0;
};

/// The whole box by plain writes.
class WholeWriter final : public PartWriter {
public:
    explicit WholeWriter(const StateFile& file)
        : target_(file.target), file_(open_file(file.temporary, O_WRONLY, "cannot write")) {}

    void write(std::uint64_t offset, std::span<const double> values) override { put(offset, values); }
    void write(std::uint64_t offset, std::span<const float> values) override { put(offset, values); }
    void write(std::uint64_t offset, std::span<const std::uint8_t> values) override { put(offset, values); }
    void finish() override {}

private:
    template <class T>
    void put(std::uint64_t offset, std::span<const T> values) {
        write_at(file_, offset, {reinterpret_cast<const char*>(values.data()), values.size_bytes()}, target_);
    }

    const Path& target_;
    FileDescriptor file_;
};

/// MPI's own collective writes, which gather what lies scattered in the file. Failures are remembered, for
/// all ranks must go through to the end.
class CollectiveWriter final : public PartWriter {
public:
    CollectiveWriter(const StateFile& file, const EngineState& part, const Ranks& ranks)
        : box_(part.size), part_(part.part) {
        note(MPI_File_open(ranks.communicator()->handle, file.temporary.c_str(), MPI_MODE_WRONLY,
                           MPI_INFO_NULL, &file_));
        if (ranks.any(!failure_.empty()) && file_ != MPI_FILE_NULL)
            MPI_File_close(&file_); // nobody writes unless all can
    }
    ~CollectiveWriter() override {
        if (file_ != MPI_FILE_NULL)
            MPI_File_close(&file_);
    }

    void write(std::uint64_t offset, std::span<const double> values) override {
        put(offset, values.data(), MPI_DOUBLE);
    }
    void write(std::uint64_t offset, std::span<const float> values) override {
        put(offset, values.data(), MPI_FLOAT);
    }
    void write(std::uint64_t offset, std::span<const std::uint8_t> values) override {
        put(offset, values.data(), MPI_UINT8_T);
    }
    void finish() override {
        if (file_ == MPI_FILE_NULL)
            return;
        note(MPI_File_sync(file_));
        note(MPI_File_close(&file_));
        file_ = MPI_FILE_NULL;
    }

    const std::string& failure() const { return failure_; }

private:
    void put(std::uint64_t offset, const void* values, MPI_Datatype number) {
        if (file_ == MPI_FILE_NULL)
            return;
        const int whole[3] = {box_.z, box_.y, box_.x};
        const int sizes[3] = {part_.size.z, part_.size.y, part_.size.x};
        const int begins[3] = {part_.begin.z, part_.begin.y, part_.begin.x};
        MPI_Datatype place = MPI_DATATYPE_NULL;
        MPI_Type_create_subarray(3, whole, sizes, begins, MPI_ORDER_C, number, &place);
        MPI_Type_commit(&place);
        note(MPI_File_set_view(file_, static_cast<MPI_Offset>(offset), number, place, "native",
                               MPI_INFO_NULL));
        MPI_Status status;
        note(MPI_File_write_all(file_, values, static_cast<int>(part_.volume()), number, &status));
        int written = 0;
        MPI_Get_count(&status, number, &written);
        if (failure_.empty() && written != part_.volume())
            failure_ = "not all could be written";
        MPI_Type_free(&place);
    }

    void note(int code) {
        if (code == MPI_SUCCESS || !failure_.empty())
            return;
        char text[MPI_MAX_ERROR_STRING] = {};
        int length = 0;
        MPI_Error_string(code, text, &length);
        failure_ = text;
    }

    Vec3<int> box_;
    CellBox part_;
    MPI_File file_ = MPI_FILE_NULL;
    std::string failure_;
};

void write_reals(PartWriter& writer, std::uint64_t offset, const std::vector<double>& values,
                 bool as_floats) {
    if (as_floats)
        writer.write(offset, std::span<const float>(std::vector<float>(values.begin(), values.end())));
    else
        writer.write(offset, std::span<const double>(values));
}

void write_arrays(PartWriter& writer, const StateFile& file, const EngineState& part) {
    const std::uint64_t cells = static_cast<std::uint64_t>(CellBox{{}, part.size}.volume());
    const std::uint64_t width = file.float_populations ? sizeof(float) : sizeof(double);
    for (std::size_t i = 0; i < part.populations.size(); ++i)
        write_reals(writer, file.populations + i * cells * width, part.populations[i],
                    file.float_populations);
    write_reals(writer, file.minority, part.minority, file.float_minority);
    writer.write(file.band, std::span<const std::uint8_t>(part.band));
    writer.finish();
}

} // namespace

void write_state(const StateFile& file, const EngineState& part, const Ranks& ranks) {
    if (ranks.count() == 1) {
        WholeWriter writer(file);
        write_arrays(writer, file, part);
        return;
    }
    CollectiveWriter writer(file, part, ranks);
    write_arrays(writer, file, part);
    const auto reasons = ranks.gather(std::as_bytes(std::span(writer.failure())));
    for (std::size_t rank = 0; rank < reasons.size(); ++rank)
        if (!reasons[rank].empty())
            throw RunError(fmt::format(
                "{}: cannot write: {} (rank {})", file.target.string(),
                std::string(reinterpret_cast<const char*>(reasons[rank].data()), reasons[rank].size()),
                rank));
}

namespace {

/// The part of row `row` of an array of box-shaped rows, or of an array that is one such row.
template <class T>
std::vector<T> read_part(hid_t array, hid_t type, std::size_t row, const Vec3<int>& box, const CellBox& part,
                         const Path& path) {
    std::vector<T> values(static_cast<std::size_t>(part.volume()));
    const auto at = [&](int y, int z) {
        return (static_cast<hsize_t>(part.begin.z + z) * static_cast<hsize_t>(box.y) +
                static_cast<hsize_t>(part.begin.y + y)) *
                   static_cast<hsize_t>(box.x) +
               static_cast<hsize_t>(part.begin.x);
    };
    const bool whole_rows = part.size.x == box.x;
    const bool whole_planes = whole_rows && part.size.y == box.y;
    const auto plane = static_cast<std::size_t>(part.size.x) * static_cast<std::size_t>(part.size.y);
    // As much at once as lies in one piece.
    if (whole_planes) {
        read_run(array, type, row, at(0, 0), values.size(), values.data(), path);
    } else if (whole_rows) {
        for (int z = 0; z < part.size.z; ++z)
            read_run(array, type, row, at(0, z), plane, values.data() + static_cast<std::size_t>(z) * plane,
                     path);
    } else {
        const auto length = static_cast<std::size_t>(part.size.x);
        T* into = values.data();
        for (int z = 0; z < part.size.z; ++z)
            for (int y = 0; y < part.size.y; ++y, into += length)
                read_run(array, type, row, at(y, z), length, into, path);
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
