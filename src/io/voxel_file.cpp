#include "io/voxel_file.hpp"

#include "core/input_error.hpp"
#include "io/hdf5_array.hpp"
#include "io/posix_file.hpp"
#include "io/vti_format.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>
#include <cctype>
#include <cstdint>
#include <string_view>
#include <system_error>
#include <vector>

namespace vesica {
namespace {

using Path = std::filesystem::path;

[[noreturn]] void refuse(const Path& file, const std::string& message) {
    throw InputError(SourcePlace{file.string(), 0, 0}, message);
}

/// Rows of cells in the order of a file, x fastest, from plane `first` on.
template <class Values>
void add_planes(SolidVoxels& solid, int first, const Values& values) {
    const Vec3<int>& size = solid.size();
    std::size_t k = 0;
    for (int z = first; k < values.size(); ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                if (values[k++] != 0)
                    solid.set({x, y, z});
}

SolidVoxels read_raw(const Path& file, const Vec3<int>& size) {
    std::error_code error;
    const std::uintmax_t bytes = std::filesystem::file_size(file, error);
    const std::uintmax_t cells = std::uintmax_t(size.x) * std::uintmax_t(size.y) * std::uintmax_t(size.z);
    if (!error && bytes != cells)
        refuse(file,
               fmt::format("the file has {} bytes; expected {}, one for each of {} x {} x {} cells; try "
                           "8-bit values without a header, x fastest, or change the lattice's size",
                           bytes, cells, size.x, size.y, size.z));
    const std::string content = read_whole_file(file);
    if (content.size() != cells)
        refuse(file, fmt::format("only {} of {} bytes could be read; try again when nobody writes the file",
                                 content.size(), cells));
    SolidVoxels solid(size);
    add_planes(solid, 0, content);
    return solid;
}

/// A data set, or nothing if there is none of that name.
Hdf5Dataset find_array(const Hdf5File& file, const std::string& name) {
    return Hdf5Dataset(H5Dopen2(file, name.c_str(), H5P_DEFAULT));
}

/// The only data set at the root that has three dimensions.
std::string name_of_only_array(const Hdf5File& file, const Path& path) {
    std::vector<std::string> found;
    for (const std::string& name : names_in(file, path))
        if (const Hdf5Dataset array = find_array(file, name);
            array.valid() && shape_of(array, path).size() == 3)
            found.push_back(name);
    if (found.empty())
        refuse(path, "no data set at the root has three dimensions; expected one of shape (nz, ny, nx); try "
                     "to name a data set inside a group");
    if (found.size() > 1)
        refuse(path, fmt::format("the data sets {} have three dimensions; expected one; try to name the one "
                                 "that marks solid cells",
                                 fmt::join(found, ", ")));
    return found.front();
}

void check_shape(const std::vector<hsize_t>& shape, const Vec3<int>& size, const std::string& name,
                 const Path& path) {
    const std::vector<hsize_t> expected{hsize_t(size.z), hsize_t(size.y), hsize_t(size.x)};
    if (shape == expected)
        return;
    const bool reversed = std::equal(shape.rbegin(), shape.rend(), expected.begin(), expected.end());
    refuse(path,
           fmt::format("the data set {} has the shape ({}); expected ({}), which is (nz, ny, nx); try {}",
                       name, fmt::join(shape, ", "), fmt::join(expected, ", "),
                       reversed ? "to write its transpose: its first index seems to be that of x"
                                : "an array with one value for each cell of the lattice"));
}

void check_type(const Hdf5Dataset& array, const std::string& name, const Path& path) {
    const Hdf5Type type(hdf5_checked(H5Dget_type(array), path, "cannot read"));
    const H5T_class_t kind = H5Tget_class(type);
    if (kind != H5T_INTEGER && kind != H5T_ENUM)
        refuse(path,
               fmt::format("the data set {} holds {}; expected integers or booleans; try to write it as "
                           "8-bit integers, 1 where it is solid and 0 elsewhere",
                           name, kind == H5T_FLOAT ? "real numbers" : "no numbers"));
}

SolidVoxels read_hdf5(const Path& path, const Vec3<int>& size, const std::string& dataset) {
    const QuietHdf5 quiet;
    const Hdf5File file = open_hdf5(path);
    const std::string name = dataset.empty() ? name_of_only_array(file, path) : dataset;
    const Hdf5Dataset array = find_array(file, name);
    if (!array.valid())
        refuse(path,
               fmt::format("there is no data set {}; expected one of shape (nz, ny, nx); the root holds: "
                           "{}",
                           name, fmt::join(names_in(file, path), ", ")));
    check_shape(shape_of(array, path), size, name, path);
    check_type(array, name, path);

    // HDF5 clips what does not fit: in 64 bits with a sign every other integer stays what it is, or not zero.
    constexpr std::size_t at_once = std::size_t{4} << 20;
    const std::size_t plane = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    const int planes = static_cast<int>(std::clamp<std::size_t>(at_once / plane, 1, std::size_t(size.z)));
    SolidVoxels solid(size);
    std::vector<std::int64_t> values;
    for (int z = 0; z < size.z; z += planes) {
        const int count = std::min(planes, size.z - z);
        values.resize(plane * static_cast<std::size_t>(count));
        read_rows(array, H5T_NATIVE_INT64, hsize_t(z), hsize_t(count), values.data(), path);
        add_planes(solid, z, values);
    }
    return solid;
}

std::string ending_of(const Path& file) {
    std::string ending = file.extension().string();
    for (char& c : ending)
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return ending;
}

} // namespace

SolidVoxels read_voxels(const Path& file, const Vec3<int>& size, const std::string& dataset) {
    assert(size.x > 0 && size.y > 0 && size.z > 0);
    constexpr std::string_view kinds = "a .raw, .h5, .hdf5 or .vti file";
    const std::string ending = ending_of(file);
    if (ending != ".raw" && ending != ".h5" && ending != ".hdf5" && ending != ".vti")
        refuse(file,
               fmt::format("the ending \"{}\" is of no kind known for voxels; expected {}", ending, kinds));
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (!std::filesystem::exists(status))
        refuse(file,
               fmt::format("the voxel file does not exist; expected {}; try a path relative to the case "
                           "file's folder or an absolute one",
                           kinds));
    if (!std::filesystem::is_regular_file(status))
        refuse(file, fmt::format("this is not a file; expected {}", kinds));
    if (ending == ".raw" && !dataset.empty())
        refuse(file,
               fmt::format("the data set {} is asked for; expected none, for a .raw file holds one array "
                           "without a name; leave the name away",
                           dataset));
    try {
        if (ending == ".raw")
            return read_raw(file, size);
        if (ending == ".vti")
            return parse_vti(read_whole_file(file), size, dataset, file.string());
        return read_hdf5(file, size, dataset);
    } catch (const RunError& error_of_file) { // it names the file and the reason
        throw InputError(
            fmt::format("{}; expected {} that can be read; check its permissions, or write it anew",
                        error_of_file.what(), kinds));
    }
}

} // namespace vesica
