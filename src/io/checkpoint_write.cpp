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

/// A small array whose place in the file HDF5 has decided and whose bytes are still to be written. HDF5
/// writes only the structure: it does not recover from a disk that fills up under it, and plain writes at
/// known places are what several ranks can share.
struct PlacedArray {
    std::uint64_t offset = 0;
    std::string bytes;
};

class Structure {
public:
    Structure(hid_t file, const Path& path) : file_(file), path_(path) {}

    /// The state's arrays, in one piece each; whoever has their parts fills them.
    StateFile add_state(const StatePlanes& state) {
        const StateHead& head = state.head();
        const auto cells = static_cast<hsize_t>(CellBox{{}, head.size}.volume());
        const std::size_t count = state.population_count();
        StateFile places;
        places.floats = head.precision == Precision::single_precision && state.all_floats();
        const hid_t reals = places.floats ? H5T_IEEE_F32LE : H5T_IEEE_F64LE;
        // With one vesicle a cell has one number, else as many as colours.
        const std::vector<hsize_t> colours =
            state.is_labelled() ? std::vector<hsize_t>{state.slots(), cells} : std::vector<hsize_t>{cells};
        places.band = place(file_, "band", H5T_STD_U8LE, colours);
        places.populations = place(file_, "populations", reals, {count, count == 0 ? 0 : cells});
        places.minority = place(file_, "minority", reals, colours);
        if (state.is_labelled())
            places.label = place(file_, "label", H5T_STD_I32LE, colours);
        add_reals(file_, "controllers", head.controllers);
        return places;
    }
    void add_reals(hid_t parent, const std::string& name, Row values) {
        const std::uint64_t offset = place(parent, name, H5T_IEEE_F64LE, {values.size()});
        small_.push_back({offset, {reinterpret_cast<const char*>(values.data()), values.size_bytes()}});
    }
    void add_text(const std::string& name, const std::string& text) {
        small_.push_back({place(file_, name, H5T_STD_U8LE, {text.size()}), text});
    }
    /// Where the sums of averages belong; whoever has their parts fills them.
    std::vector<std::uint64_t> add_sums(const CheckpointSums& sums) {
        std::vector<std::uint64_t> offsets;
        if (sums.arrays.empty())
            return offsets;
        const Hdf5Group group = create_group(file_, "sums", path_);
        for (const CheckpointSums::Array& array : sums.arrays)
            offsets.push_back(place(group, array.name, H5T_IEEE_F64LE, {numbers_of(array)}));
        return offsets;
    }
    const std::vector<PlacedArray>& small() const { return small_; }
    static hsize_t numbers_of(const CheckpointSums::Array& array) {
        return static_cast<hsize_t>(CellBox{{}, array.count}.volume()) *
               static_cast<hsize_t>(array.components);
    }

private:
    std::uint64_t place(hid_t parent, const std::string& name, hid_t type,
                        const std::vector<hsize_t>& shape) {
        return place_array(parent, name, type, shape, path_);
    }

    hid_t file_;
    const Path& path_;
    std::vector<PlacedArray> small_;
};

std::uint64_t bytes_needed(const CheckpointNotes& checkpoint, const StatePlanes& state) {
    const std::uint64_t cells = static_cast<std::uint64_t>(CellBox{{}, state.head().size}.volume());
    const std::uint64_t width = state.head().precision == Precision::single_precision ? 4 : 8;
    const std::uint64_t colour = width + 1 + (state.is_labelled() ? sizeof(std::int32_t) : 0);
    std::uint64_t bytes = cells * (state.population_count() * width + state.slots() * colour);
    for (const auto& [name, values] : checkpoint.notes)
        bytes += values.size() * sizeof(double);
    for (const CheckpointSums::Array& array : checkpoint.sums.arrays)
        bytes += Structure::numbers_of(array) * sizeof(double);
    return bytes + checkpoint.case_text.size() + (std::uint64_t{1} << 20);
}

} // namespace

void write_checkpoint(const Path& path, const Checkpoint& checkpoint) {
    Colleagues nobody;
    write_checkpoint(path, checkpoint, PlanesOfState(checkpoint.engine), nobody);
}

void write_checkpoint(const Path& path, const CheckpointNotes& checkpoint, const StatePlanes& state,
                      Colleagues& colleagues) {
    const QuietHdf5 quiet;
    const StateHead& head = state.head();
    const bool single = head.precision == Precision::single_precision;
    const std::uint64_t needed = bytes_needed(checkpoint, state);
    require_space(path.parent_path(), needed);

    AtomicFile target(path);
    target.try_space(needed);
    Hdf5File file = create_hdf5(target.temporary(), seal_bytes, path);
    write_attribute(file, "step", head.step, path);
    write_attribute(file, "precision_bits", std::int64_t{single ? 32 : 64}, path);
    write_attribute(file, "size_x", std::int64_t{head.size.x}, path);
    write_attribute(file, "size_y", std::int64_t{head.size.y}, path);
    write_attribute(file, "size_z", std::int64_t{head.size.z}, path);
    write_attribute(file, "program_version", checkpoint.program_version, path);
    Structure structure(file, path);
    structure.add_text("case", checkpoint.case_text);
    StateFile places = structure.add_state(state);
    places.temporary = target.temporary();
    places.target = path;
    {
        const Hdf5Group notes = create_group(file, "notes", path);
        for (const auto& [name, values] : checkpoint.notes)
            structure.add_reals(notes, name, values);
    }
    const PlacedArrays sums{target.temporary(), path, structure.add_sums(checkpoint.sums)};
    close_hdf5(file, path);
    for (const PlacedArray& array : structure.small())
        target.write_at(array.offset, array.bytes);
    synchronise(target.descriptor(), path); // for those who digest it on other machines
    colleagues.write_state(places, state);
    if (!sums.offsets.empty())
        checkpoint.sums.write(sums);
    seal(target,
         fmt::format("Vesica {} checkpoint of step {}, HDF5 after {} bytes\n", checkpoint.program_version,
                     head.step, seal_bytes),
         colleagues);
    target.commit();
}

} // namespace vesica
