#include "io/checkpoint.hpp"

#include "core/input_error.hpp"
#include "io/atomic_file.hpp"
#include "io/checkpoint_seal.hpp"
#include "io/hdf5_array.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <charconv>

namespace vesica {
namespace {

using Path = std::filesystem::path;

/// Whether storing as float loses nothing, signs of zeros and bits of NaNs included.
bool all_floats(std::span<const double> values) {
    return std::all_of(values.begin(), values.end(), [](double value) {
        return std::bit_cast<std::uint64_t>(static_cast<double>(static_cast<float>(value))) ==
               std::bit_cast<std::uint64_t>(value);
    });
}

void write_reals(hid_t parent, const std::string& name, std::span<const double> values, bool try_float,
                 const Path& path) {
    const hid_t type = try_float && all_floats(values) ? H5T_IEEE_F32LE : H5T_IEEE_F64LE;
    const Hdf5Dataset array = create_array(parent, name, type, {values.size()}, 0, path);
    write_rows(array, H5T_NATIVE_DOUBLE, 0, values.size(), values.data(), path);
}

/// Rows of equal length make one array of two indices; nothing else is needed of a state.
void write_populations(hid_t parent, const EngineState& state, const Path& path) {
    const auto& rows = state.populations;
    const std::size_t length = rows.empty() ? 0 : rows.front().size();
    const bool floats =
        state.precision == Precision::single_precision &&
        std::all_of(rows.begin(), rows.end(), [](const auto& row) { return all_floats(row); });
    const Hdf5Dataset array = create_array(parent, "populations", floats ? H5T_IEEE_F32LE : H5T_IEEE_F64LE,
                                           {rows.size(), length}, 0, path);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        assert(rows[i].size() == length);
        write_rows(array, H5T_NATIVE_DOUBLE, i, length == 0 ? 0 : 1, rows[i].data(), path);
    }
}

void write_text(hid_t parent, const std::string& name, std::string_view text, const Path& path) {
    const Hdf5Dataset array = create_array(parent, name, H5T_STD_U8LE, {text.size()}, 0, path);
    write_rows(array, H5T_NATIVE_UINT8, 0, text.size(), text.data(), path);
}

std::size_t length_of_vector(hid_t array, const char* name, const Path& path) {
    const auto shape = shape_of(array, path);
    if (shape.size() != 1)
        throw RunError(fmt::format("{}: the array {} is not a vector", path.string(), name));
    return static_cast<std::size_t>(shape.front());
}

template <class Value>
std::vector<Value> read_vector(hid_t parent, const std::string& name, hid_t type, const Path& path) {
    const Hdf5Dataset array = open_array(parent, name, path);
    std::vector<Value> values(length_of_vector(array, name.c_str(), path));
    read_rows(array, type, 0, values.size(), values.data(), path);
    return values;
}

/// Each text behind its length, so that it may hold anything.
std::string pack_texts(const std::vector<std::string>& texts) {
    std::string packed;
    for (const auto& text : texts)
        packed += fmt::format("{}:{}", text.size(), text);
    return packed;
}

std::vector<std::string> unpack_texts(std::string_view packed, const Path& path) {
    std::vector<std::string> texts;
    while (!packed.empty()) {
        std::size_t length = 0;
        const auto [end, error] = std::from_chars(packed.data(), packed.data() + packed.size(), length);
        const auto digits = static_cast<std::size_t>(end - packed.data());
        if (error != std::errc{} || digits >= packed.size() || packed.size() - digits - 1 < length)
            throw RunError(fmt::format("{}: holds an unreadable list of overrides", path.string()));
        texts.emplace_back(packed.substr(digits + 1, length));
        packed.remove_prefix(digits + 1 + length);
    }
    return texts;
}

std::string read_text(hid_t parent, const std::string& name, const Path& path) {
    const auto bytes = read_vector<char>(parent, name, H5T_NATIVE_UINT8, path);
    return {bytes.begin(), bytes.end()};
}

std::vector<std::vector<double>> read_populations(hid_t parent, const Path& path) {
    const Hdf5Dataset array = open_array(parent, "populations", path);
    const auto shape = shape_of(array, path);
    if (shape.size() != 2)
        throw RunError(fmt::format("{}: the array populations has no rows", path.string()));
    std::vector<std::vector<double>> rows(shape[0], std::vector<double>(shape[1]));
    for (std::size_t i = 0; i < rows.size(); ++i)
        read_rows(array, H5T_NATIVE_DOUBLE, i, shape[1] == 0 ? 0 : 1, rows[i].data(), path);
    return rows;
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

void read_header(hid_t file, EngineState& state, const Path& path) {
    state.step = read_integer_attribute(file, "step", path);
    const std::int64_t bits = read_integer_attribute(file, "precision_bits", path);
    if (bits != 32 && bits != 64)
        throw RunError(fmt::format("{}: has a precision of {} bits; expected 32 or 64", path.string(), bits));
    state.precision = bits == 32 ? Precision::single_precision : Precision::double_precision;
    state.size = {static_cast<int>(read_integer_attribute(file, "size_x", path)),
                  static_cast<int>(read_integer_attribute(file, "size_y", path)),
                  static_cast<int>(read_integer_attribute(file, "size_z", path))};
}

} // namespace

void write_checkpoint(const Path& path, const Checkpoint& checkpoint) {
    const QuietHdf5 quiet;
    const EngineState& state = checkpoint.engine;
    const bool single = state.precision == Precision::single_precision;
    require_space(path.parent_path(), bytes_needed(checkpoint));

    AtomicFile target(path);
    Hdf5File file = create_hdf5(target.temporary(), seal_bytes, path);
    write_attribute(file, "step", state.step, path);
    write_attribute(file, "precision_bits", std::int64_t{single ? 32 : 64}, path);
    write_attribute(file, "size_x", std::int64_t{state.size.x}, path);
    write_attribute(file, "size_y", std::int64_t{state.size.y}, path);
    write_attribute(file, "size_z", std::int64_t{state.size.z}, path);
    write_attribute(file, "program_version", checkpoint.program_version, path);
    write_text(file, "case", checkpoint.case_text, path);
    write_text(file, "overrides", pack_texts(checkpoint.overrides), path);
    write_populations(file, state, path);
    write_reals(file, "minority", state.minority, single, path);
    write_reals(file, "controllers", state.controllers, false, path);
    {
        const Hdf5Dataset band = create_array(file, "band", H5T_STD_U8LE, {state.band.size()}, 0, path);
        write_rows(band, H5T_NATIVE_UINT8, 0, state.band.size(), state.band.data(), path);
        const Hdf5Group notes = create_group(file, "notes", path);
        for (const auto& [name, values] : checkpoint.notes)
            write_reals(notes, name, values, false, path);
    }
    close_hdf5(file, path);
    seal(target, fmt::format("Vesica {} checkpoint of step {}, HDF5 after {} bytes\n",
                             checkpoint.program_version, state.step, seal_bytes));
    target.commit();
}

Checkpoint read_checkpoint(const Path& path) {
    verify_seal(path);
    const QuietHdf5 quiet;
    const Hdf5File file = open_hdf5(path);
    Checkpoint checkpoint;
    EngineState& state = checkpoint.engine;
    read_header(file, state, path);
    checkpoint.program_version = read_text_attribute(file, "program_version", path);
    checkpoint.case_text = read_text(file, "case", path);
    checkpoint.overrides = unpack_texts(read_text(file, "overrides", path), path);
    state.populations = read_populations(file, path);
    state.minority = read_vector<double>(file, "minority", H5T_NATIVE_DOUBLE, path);
    state.controllers = read_vector<double>(file, "controllers", H5T_NATIVE_DOUBLE, path);
    state.band = read_vector<std::uint8_t>(file, "band", H5T_NATIVE_UINT8, path);
    const Hdf5Group notes(hdf5_checked(H5Gopen2(file, "notes", H5P_DEFAULT), path, "cannot read the notes"));
    for (const std::string& name : names_in(notes, path))
        checkpoint.notes[name] = read_vector<double>(notes, name, H5T_NATIVE_DOUBLE, path);
    return checkpoint;
}

CheckpointSummary summarise_checkpoint(const Path& path) {
    const CheckpointSeal found = verify_seal(path);
    const QuietHdf5 quiet;
    const Hdf5File file = open_hdf5(path);
    EngineState state;
    read_header(file, state, path);
    CheckpointSummary summary;
    summary.step = state.step;
    summary.precision = state.precision;
    summary.size = state.size;
    summary.program_version = read_text_attribute(file, "program_version", path);
    summary.format_version = found.format_version;
    summary.bytes = found.payload_bytes + seal_bytes;
    summary.case_text = read_text(file, "case", path);
    for (const char* name : {"populations", "minority", "band", "controllers"})
        summary.arrays.push_back(
            fmt::format("{} [{}]", name, fmt::join(shape_of(open_array(file, name, path), path), ", ")));
    const Hdf5Group notes(hdf5_checked(H5Gopen2(file, "notes", H5P_DEFAULT), path, "cannot read the notes"));
    for (const std::string& name : names_in(notes, path))
        summary.arrays.push_back(fmt::format("notes/{} [{}]", name,
                                             fmt::join(shape_of(open_array(notes, name, path), path), ", ")));
    return summary;
}

} // namespace vesica
