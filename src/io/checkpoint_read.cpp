#include "core/input_error.hpp"
#include "io/checkpoint.hpp"
#include "io/checkpoint_seal.hpp"
#include "io/hdf5_array.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace vesica {
namespace {

using Path = std::filesystem::path;

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

std::string read_text(hid_t parent, const std::string& name, const Path& path) {
    const auto bytes = read_vector<char>(parent, name, H5T_NATIVE_UINT8, path);
    return {bytes.begin(), bytes.end()};
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
    state.part = {{}, state.size};
}

} // namespace

Checkpoint read_checkpoint_notes(const Path& path, Colleagues& colleagues) {
    verify_seal(path, colleagues);
    const QuietHdf5 quiet;
    const Hdf5File file = open_hdf5(path);
    Checkpoint checkpoint;
    read_header(file, checkpoint.engine, path);
    checkpoint.program_version = read_text_attribute(file, "program_version", path);
    checkpoint.case_text = read_text(file, "case", path);
    const Hdf5Group notes(hdf5_checked(H5Gopen2(file, "notes", H5P_DEFAULT), path, "cannot read the notes"));
    for (const std::string& name : names_in(notes, path))
        checkpoint.notes[name] = read_vector<double>(notes, name, H5T_NATIVE_DOUBLE, path);
    return checkpoint;
}

Checkpoint read_checkpoint(const Path& path) {
    Colleagues nobody;
    Checkpoint checkpoint = read_checkpoint_notes(path, nobody);
    checkpoint.engine = read_state(path, {{}, checkpoint.engine.size});
    return checkpoint;
}

CheckpointSummary summarise_checkpoint(const Path& path) {
    Colleagues nobody;
    const CheckpointSeal found = verify_seal(path, nobody);
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
    for (const char* name : {"populations", "minority", "band", "label", "controllers"})
        if (has_link(file, name, path))
            summary.arrays.push_back(
                fmt::format("{} [{}]", name, fmt::join(shape_of(open_array(file, name, path), path), ", ")));
    const Hdf5Group notes(hdf5_checked(H5Gopen2(file, "notes", H5P_DEFAULT), path, "cannot read the notes"));
    for (const std::string& name : names_in(notes, path))
        summary.arrays.push_back(fmt::format("notes/{} [{}]", name,
                                             fmt::join(shape_of(open_array(notes, name, path), path), ", ")));
    if (has_link(file, "sums", path)) {
        const Hdf5Group sums = open_group(file, "sums", path);
        for (const std::string& name : names_in(sums, path))
            summary.arrays.push_back(fmt::format(
                "sums/{} [{}]", name, fmt::join(shape_of(open_array(sums, name, path), path), ", ")));
    }
    return summary;
}

} // namespace vesica
