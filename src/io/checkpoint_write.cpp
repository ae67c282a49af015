#include "core/input_error.hpp"
#include "io/atomic_file.hpp"
#include "io/checkpoint.hpp"
#include "io/checkpoint_seal.hpp"
#include "io/hdf5_array.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <span>

namespace vesica {
namespace {

using Path = std::filesystem::path;
using Row = std::span<const double>;

static_assert(std::endian::native == std::endian::little,
              "the arrays are declared little-endian and written raw");

/// An array whose place in the file HDF5 has decided and whose bytes are still to be written. HDF5 writes
/// only the small structure: it does not recover from a disk that fills up under it, and plain writes at
/// known places are what several ranks can share.
struct PlacedArray {
    std::uint64_t offset = 0;
    std::vector<Row> rows;  ///< of reals
    bool as_floats = false; ///< how they are stored
    std::string bytes;      ///< of anything else
};

/// Whether storing as float loses nothing, signs of zeros and bits of NaNs included.
bool all_floats(Row values) {
    return std::all_of(values.begin(), values.end(), [](double value) {
        return std::bit_cast<std::uint64_t>(static_cast<double>(static_cast<float>(value))) ==
               std::bit_cast<std::uint64_t>(value);
    });
}

class Structure {
public:
    Structure(hid_t file, const Path& path) : file_(file), path_(path) {}

    void add_reals(hid_t parent, const std::string& name, Row values, bool try_float) {
        const bool floats = try_float && all_floats(values);
        place(parent, name, real_type(floats), {values.size()}, {0, {values}, floats, {}});
    }
    void add_populations(const EngineState& state) {
        std::vector<Row> rows(state.populations.begin(), state.populations.end());
        const std::size_t length = rows.empty() ? 0 : rows.front().size();
        assert(std::all_of(rows.begin(), rows.end(), [&](Row row) { return row.size() == length; }));
        const bool floats = state.precision == Precision::single_precision &&
                            std::all_of(rows.begin(), rows.end(), all_floats);
        const std::size_t count = rows.size();
        place(file_, "populations", real_type(floats), {count, length}, {0, std::move(rows), floats, {}});
    }
    void add_bytes(const std::string& name, std::string bytes) {
        const std::size_t count = bytes.size();
        place(file_, name, H5T_STD_U8LE, {count}, {0, {}, false, std::move(bytes)});
    }
    const std::vector<PlacedArray>& arrays() const { return arrays_; }

private:
    static hid_t real_type(bool floats) { return floats ? H5T_IEEE_F32LE : H5T_IEEE_F64LE; }

    void place(hid_t parent, const std::string& name, hid_t type, const std::vector<hsize_t>& shape,
               PlacedArray array) {
        array.offset = place_array(parent, name, type, shape, path_);
        arrays_.push_back(std::move(array));
    }

    hid_t file_;
    const Path& path_;
    std::vector<PlacedArray> arrays_;
};

/// Writes the values as floats, a block at a time.
std::uint64_t write_floats(AtomicFile& file, std::uint64_t offset, Row row) {
    constexpr std::size_t block = std::size_t{1} << 18;
    std::vector<float> buffer;
    for (std::size_t begin = 0; begin < row.size(); begin += block) {
        const Row part = row.subspan(begin, std::min(block, row.size() - begin));
        buffer.resize(part.size());
        std::transform(part.begin(), part.end(), buffer.begin(),
                       [](double v) { return static_cast<float>(v); });
        const std::size_t bytes = buffer.size() * sizeof(float);
        file.write_at(offset, {reinterpret_cast<const char*>(buffer.data()), bytes});
        offset += bytes;
    }
    return offset;
}

void write_values(AtomicFile& file, const PlacedArray& array) {
    std::uint64_t offset = array.offset;
    for (const Row row : array.rows) {
        if (array.as_floats) {
            offset = write_floats(file, offset, row);
        } else {
            file.write_at(offset, {reinterpret_cast<const char*>(row.data()), row.size_bytes()});
            offset += row.size_bytes();
        }
    }
    file.write_at(offset, array.bytes);
}

std::uint64_t bytes_needed(const Checkpoint& checkpoint) {
    const auto& state = checkpoint.engine;
    std::uint64_t reals = state.minority.size() + state.controllers.size();
    for (const auto& row : state.populations)
        reals += row.size();
    for (const auto& [name, values] : checkpoint.notes)
        reals += values.size();
    const std::uint64_t width = state.precision == Precision::single_precision ? 4 : 8;
    return reals * width + state.band.size() + checkpoint.case_text.size() + (std::uint64_t{1} << 20);
}

} // namespace

void write_checkpoint(const Path& path, const Checkpoint& checkpoint) {
    const QuietHdf5 quiet;
    const EngineState& state = checkpoint.engine;
    const bool single = state.precision == Precision::single_precision;
    const std::uint64_t needed = bytes_needed(checkpoint);
    require_space(path.parent_path(), needed);

    AtomicFile target(path);
    target.try_space(needed);
    Hdf5File file = create_hdf5(target.temporary(), seal_bytes, path);
    write_attribute(file, "step", state.step, path);
    write_attribute(file, "precision_bits", std::int64_t{single ? 32 : 64}, path);
    write_attribute(file, "size_x", std::int64_t{state.size.x}, path);
    write_attribute(file, "size_y", std::int64_t{state.size.y}, path);
    write_attribute(file, "size_z", std::int64_t{state.size.z}, path);
    write_attribute(file, "program_version", checkpoint.program_version, path);
    Structure structure(file, path);
    structure.add_bytes("case", checkpoint.case_text);
    structure.add_bytes("band", {state.band.begin(), state.band.end()});
    structure.add_populations(state);
    structure.add_reals(file, "minority", state.minority, single);
    structure.add_reals(file, "controllers", state.controllers, false);
    {
        const Hdf5Group notes = create_group(file, "notes", path);
        for (const auto& [name, values] : checkpoint.notes)
            structure.add_reals(notes, name, values, false);
    }
    close_hdf5(file, path);
    for (const PlacedArray& array : structure.arrays())
        write_values(target, array);
    seal(target, fmt::format("Vesica {} checkpoint of step {}, HDF5 after {} bytes\n",
                             checkpoint.program_version, state.step, seal_bytes));
    target.commit();
}

} // namespace vesica
