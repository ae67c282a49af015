#include "io/hdf5_array.hpp"

#include "core/input_error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace vesica {
namespace {

constexpr const char* cannot_write = "cannot write";
constexpr const char* cannot_read = "cannot read";

void write_attribute_of(hid_t object, const char* name, hid_t stored, hid_t memory, hid_t space,
                        const void* values, const std::filesystem::path& path) {
    const Hdf5Attribute attribute(
        hdf5_checked(H5Acreate2(object, name, stored, space, H5P_DEFAULT, H5P_DEFAULT), path, cannot_write));
    hdf5_checked(H5Awrite(attribute, memory, values), path, cannot_write);
}

Hdf5Attribute open_attribute(hid_t object, const char* name, const std::filesystem::path& path) {
    const hid_t id = H5Aopen(object, name, H5P_DEFAULT);
    if (id < 0)
        throw RunError(fmt::format("{}: lacks the attribute {}", path.string(), name));
    return Hdf5Attribute(id);
}

/// Selects rows of the file's space; returns the matching space in memory.
Hdf5Space select_rows(hid_t file_space, hsize_t first, hsize_t count, const std::filesystem::path& path) {
    const int rank = H5Sget_simple_extent_ndims(file_space);
    std::vector<hsize_t> extent(static_cast<std::size_t>(std::max(rank, 1)));
    hdf5_checked(H5Sget_simple_extent_dims(file_space, extent.data(), nullptr), path, cannot_read);
    std::vector<hsize_t> start(extent.size(), 0);
    start.front() = first;
    extent.front() = count;
    hdf5_checked(
        H5Sselect_hyperslab(file_space, H5S_SELECT_SET, start.data(), nullptr, extent.data(), nullptr), path,
        cannot_read);
    return Hdf5Space(hdf5_checked(H5Screate_simple(rank, extent.data(), nullptr), path, cannot_read));
}

Hdf5Properties access_properties() {
    Hdf5Properties access(H5Pcreate(H5P_FILE_ACCESS));
    // Some parallel file systems know no locks; the lock of the output directory already keeps others away.
    H5Pset_file_locking(access, true, true);
    return access;
}

Hdf5Properties creation_properties(std::uint64_t user_block, const std::filesystem::path& path) {
    Hdf5Properties creation(H5Pcreate(H5P_FILE_CREATE));
    if (user_block > 0)
        hdf5_checked(H5Pset_userblock(creation, user_block), path, cannot_write);
    hdf5_checked(H5Pset_obj_track_times(creation, false), path, cannot_write);
    return creation;
}

Hdf5Dataset create_dataset(hid_t parent, const std::string& name, hid_t type,
                           const std::vector<hsize_t>& shape, hid_t creation,
                           const std::filesystem::path& path) {
    hdf5_checked(H5Pset_obj_track_times(creation, false), path, cannot_write);
    const Hdf5Space space(hdf5_checked(
        H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), path, cannot_write));
    const hid_t id = H5Dcreate2(parent, name.c_str(), type, space, H5P_DEFAULT, creation, H5P_DEFAULT);
    return Hdf5Dataset(hdf5_checked(id, path, cannot_write));
}

bool is_empty(const std::vector<hsize_t>& shape) {
    return std::find(shape.begin(), shape.end(), hsize_t{0}) != shape.end();
}

} // namespace

Hdf5File create_hdf5(const std::filesystem::path& location, std::uint64_t user_block,
                     const std::filesystem::path& path) {
    // Closing the properties clears HDF5's reasons for a failure: they must outlive the check.
    const Hdf5Properties creation = creation_properties(user_block, path);
    const Hdf5Properties access = access_properties();
    // Large arrays begin at pages: no two share one, and copies are faster.
    constexpr hsize_t large = hsize_t{1} << 16;
    constexpr hsize_t page = 4096;
    hdf5_checked(H5Pset_alignment(access, large, page), path, "cannot create");
    const hid_t id = H5Fcreate(location.c_str(), H5F_ACC_TRUNC, creation, access);
    return Hdf5File(hdf5_checked(id, path, "cannot create"));
}

Hdf5File create_hdf5_in_memory(const std::filesystem::path& path) {
    const Hdf5Properties access = access_properties();
    constexpr std::size_t growth = std::size_t{8} << 20;
    hdf5_checked(H5Pset_fapl_core(access, growth, false), path, cannot_write);
    // The name is never opened, but HDF5 tells open files apart by it.
    const Hdf5Properties creation = creation_properties(0, path);
    const hid_t id = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation, access);
    return Hdf5File(hdf5_checked(id, path, "cannot create"));
}

std::string hdf5_bytes(const Hdf5File& file, const std::filesystem::path& path) {
    hdf5_checked(H5Fflush(file, H5F_SCOPE_LOCAL), path, cannot_write);
    const ssize_t size = hdf5_checked(H5Fget_file_image(file, nullptr, 0), path, cannot_write);
    std::string bytes(static_cast<std::size_t>(size), '\0');
    hdf5_checked(H5Fget_file_image(file, bytes.data(), bytes.size()), path, cannot_write);
    return bytes;
}

Hdf5File open_hdf5(const std::filesystem::path& path) {
    const Hdf5Properties access = access_properties();
    const hid_t id = H5Fopen(path.c_str(), H5F_ACC_RDONLY, access);
    return Hdf5File(hdf5_checked(id, path, "cannot open as HDF5"));
}

void close_hdf5(Hdf5File& file, const std::filesystem::path& path) {
    hdf5_checked(file.close(), path, cannot_write);
}

Hdf5Group create_group(hid_t parent, const std::string& name, const std::filesystem::path& path) {
    const Hdf5Properties creation(H5Pcreate(H5P_GROUP_CREATE));
    hdf5_checked(H5Pset_obj_track_times(creation, false), path, cannot_write);
    const hid_t id = H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, creation, H5P_DEFAULT);
    return Hdf5Group(hdf5_checked(id, path, cannot_write));
}

Hdf5Group open_group(hid_t parent, const std::string& name, const std::filesystem::path& path) {
    const hid_t id = H5Gopen2(parent, name.c_str(), H5P_DEFAULT);
    if (id < 0)
        throw RunError(fmt::format("{}: lacks the group {}", path.string(), name));
    return Hdf5Group(id);
}

Hdf5Dataset create_array(hid_t parent, const std::string& name, hid_t stored_type,
                         const std::vector<hsize_t>& shape, int level, const std::filesystem::path& path) {
    if (level > 0 && !is_empty(shape)) {
        std::vector<hsize_t> chunk = shape;
        hsize_t plane = H5Tget_size(stored_type);
        for (std::size_t i = 1; i < chunk.size(); ++i)
            plane *= chunk[i];
        chunk.front() = std::clamp<hsize_t>((hsize_t{1} << 20) / plane, 1, shape.front());
        return create_chunked_array(parent, name, stored_type, shape, chunk, level, path);
    }
    const Hdf5Properties creation(H5Pcreate(H5P_DATASET_CREATE));
    return create_dataset(parent, name, stored_type, shape, creation, path);
}

Hdf5Dataset create_chunked_array(hid_t parent, const std::string& name, hid_t stored_type,
                                 const std::vector<hsize_t>& shape, const std::vector<hsize_t>& chunk,
                                 int level, const std::filesystem::path& path) {
    const Hdf5Properties creation(H5Pcreate(H5P_DATASET_CREATE));
    hdf5_checked(H5Pset_chunk(creation, static_cast<int>(chunk.size()), chunk.data()), path, cannot_write);
    hdf5_checked(H5Pset_shuffle(creation), path, cannot_write);
    hdf5_checked(H5Pset_deflate(creation, static_cast<unsigned>(level)), path, cannot_write);
    return create_dataset(parent, name, stored_type, shape, creation, path);
}

void write_chunk(hid_t dataset, const std::vector<hsize_t>& begin, std::string_view bytes,
                 const std::filesystem::path& path) {
    constexpr std::uint32_t all_filters = 0;
    hdf5_checked(H5Dwrite_chunk(dataset, H5P_DEFAULT, all_filters, begin.data(), bytes.size(), bytes.data()),
                 path, cannot_write);
}

std::uint64_t place_array(hid_t parent, const std::string& name, hid_t stored_type,
                          const std::vector<hsize_t>& shape, const std::filesystem::path& path) {
    const Hdf5Properties creation(H5Pcreate(H5P_DATASET_CREATE));
    hdf5_checked(H5Pset_layout(creation, H5D_CONTIGUOUS), path, cannot_write);
    hdf5_checked(H5Pset_alloc_time(creation, H5D_ALLOC_TIME_EARLY), path, cannot_write);
    hdf5_checked(H5Pset_fill_time(creation, H5D_FILL_TIME_NEVER), path, cannot_write);
    const Hdf5Dataset array = create_dataset(parent, name, stored_type, shape, creation, path);
    const haddr_t offset = H5Dget_offset(array);
    if (offset != HADDR_UNDEF)
        return offset;
    if (!is_empty(shape))
        fail_hdf5(path, cannot_write);
    return 0;
}

void write_rows(hid_t dataset, hid_t memory_type, hsize_t first, hsize_t count, const void* values,
                const std::filesystem::path& path) {
    if (count == 0)
        return;
    const Hdf5Space space(hdf5_checked(H5Dget_space(dataset), path, cannot_write));
    const Hdf5Space memory = select_rows(space, first, count, path);
    hdf5_checked(H5Dwrite(dataset, memory_type, memory, space, H5P_DEFAULT, values), path, cannot_write);
}

void read_rows(hid_t dataset, hid_t memory_type, hsize_t first, hsize_t count, void* values,
               const std::filesystem::path& path) {
    if (count == 0)
        return;
    const Hdf5Space space(hdf5_checked(H5Dget_space(dataset), path, cannot_read));
    const Hdf5Space memory = select_rows(space, first, count, path);
    hdf5_checked(H5Dread(dataset, memory_type, memory, space, H5P_DEFAULT, values), path, cannot_read);
}

void read_runs(hid_t dataset, hid_t memory_type, hsize_t row, const Hdf5Runs& runs, void* values,
               const std::filesystem::path& path) {
    const hsize_t numbers = runs.count * runs.length;
    if (numbers == 0)
        return;
    const Hdf5Space space(hdf5_checked(H5Dget_space(dataset), path, cannot_read));
    const bool rows = H5Sget_simple_extent_ndims(space) == 2;
    const hsize_t start[2] = {rows ? row : runs.first, runs.first};
    const hsize_t stride[2] = {rows ? 1 : runs.stride, runs.stride};
    const hsize_t count[2] = {rows ? 1 : runs.count, runs.count};
    const hsize_t block[2] = {rows ? 1 : runs.length, runs.length};
    hdf5_checked(H5Sselect_hyperslab(space, H5S_SELECT_SET, start, stride, count, block), path, cannot_read);
    const Hdf5Space memory(hdf5_checked(H5Screate_simple(1, &numbers, nullptr), path, cannot_read));
    hdf5_checked(H5Dread(dataset, memory_type, memory, space, H5P_DEFAULT, values), path, cannot_read);
}

bool has_link(hid_t parent, const std::string& name, const std::filesystem::path& path) {
    return hdf5_checked(H5Lexists(parent, name.c_str(), H5P_DEFAULT), path, cannot_read) > 0;
}

Hdf5Dataset open_array(hid_t parent, const std::string& name, const std::filesystem::path& path) {
    const hid_t id = H5Dopen2(parent, name.c_str(), H5P_DEFAULT);
    if (id < 0)
        throw RunError(fmt::format("{}: lacks the array {}", path.string(), name));
    return Hdf5Dataset(id);
}

std::vector<hsize_t> shape_of(hid_t dataset, const std::filesystem::path& path) {
    const Hdf5Space space(hdf5_checked(H5Dget_space(dataset), path, cannot_read));
    const int rank = hdf5_checked(H5Sget_simple_extent_ndims(space), path, cannot_read);
    std::vector<hsize_t> shape(static_cast<std::size_t>(rank));
    if (rank > 0)
        hdf5_checked(H5Sget_simple_extent_dims(space, shape.data(), nullptr), path, cannot_read);
    return shape;
}

std::vector<std::string> names_in(hid_t group, const std::filesystem::path& path) {
    std::vector<std::string> names;
    const auto keep = [](hid_t, const char* name, const H5L_info_t*, void* list) -> herr_t {
        static_cast<std::vector<std::string>*>(list)->emplace_back(name);
        return 0;
    };
    hdf5_checked(H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, nullptr, keep, &names), path, cannot_read);
    return names;
}

void write_attribute(hid_t object, const char* name, std::int64_t value, const std::filesystem::path& path) {
    const Hdf5Space space(H5Screate(H5S_SCALAR));
    write_attribute_of(object, name, H5T_STD_I64LE, H5T_NATIVE_INT64, space, &value, path);
}

void write_attribute(hid_t object, const char* name, std::span<const std::int64_t> values,
                     const std::filesystem::path& path) {
    const hsize_t count = values.size();
    const Hdf5Space space(H5Screate_simple(1, &count, nullptr));
    write_attribute_of(object, name, H5T_STD_I64LE, H5T_NATIVE_INT64, space, values.data(), path);
}

void write_attribute(hid_t object, const char* name, std::span<const double> values,
                     const std::filesystem::path& path) {
    const hsize_t count = values.size();
    const Hdf5Space space(H5Screate_simple(1, &count, nullptr));
    write_attribute_of(object, name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, space, values.data(), path);
}

void write_attribute(hid_t object, const char* name, const std::string& text,
                     const std::filesystem::path& path) {
    const Hdf5Space space(H5Screate(H5S_SCALAR));
    const Hdf5Type type(H5Tcopy(H5T_C_S1));
    hdf5_checked(H5Tset_size(type, text.size() + 1), path, cannot_write);
    hdf5_checked(H5Tset_cset(type, H5T_CSET_UTF8), path, cannot_write);
    write_attribute_of(object, name, type, type, space, text.c_str(), path);
}

std::int64_t read_integer_attribute(hid_t object, const char* name, const std::filesystem::path& path) {
    const Hdf5Attribute attribute = open_attribute(object, name, path);
    const Hdf5Space space(hdf5_checked(H5Aget_space(attribute), path, cannot_read));
    if (H5Sget_simple_extent_npoints(space) != 1)
        throw RunError(fmt::format("{}: the attribute {} is not one number", path.string(), name));
    std::int64_t value = 0;
    hdf5_checked(H5Aread(attribute, H5T_NATIVE_INT64, &value), path, cannot_read);
    return value;
}

std::vector<double> read_real_attribute(hid_t object, const char* name, const std::filesystem::path& path) {
    const Hdf5Attribute attribute = open_attribute(object, name, path);
    const Hdf5Space space(hdf5_checked(H5Aget_space(attribute), path, cannot_read));
    std::vector<double> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
    hdf5_checked(H5Aread(attribute, H5T_NATIVE_DOUBLE, values.data()), path, cannot_read);
    return values;
}

std::string read_text_attribute(hid_t object, const char* name, const std::filesystem::path& path) {
    const Hdf5Attribute attribute = open_attribute(object, name, path);
    const Hdf5Type type(hdf5_checked(H5Aget_type(attribute), path, cannot_read));
    if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) != 0)
        throw RunError(
            fmt::format("{}: the attribute {} is not a text of fixed length", path.string(), name));
    std::string text(H5Tget_size(type), '\0');
    hdf5_checked(H5Aread(attribute, type, text.data()), path, cannot_read);
    text.resize(text.find('\0') == std::string::npos ? text.size() : text.find('\0'));
    return text;
}

} // namespace vesica
