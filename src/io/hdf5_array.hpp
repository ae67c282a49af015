#pragma once

#include "io/hdf5_handle.hpp"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Arrays, texts and numbers in HDF5, as far as Vesica's files need them. Every function throws RunError that
/// names `path`, the file in whose name it works.
namespace vesica {

/// Creates a file at `location` (a temporary name) with `user_block` free bytes in front. The same content
/// gives the same bytes: no times are kept.
Hdf5File create_hdf5(const std::filesystem::path& location, std::uint64_t user_block,
                     const std::filesystem::path& path);

/// The same in memory, for small files: HDF5 does not recover from a disk that fills up under it.
Hdf5File create_hdf5_in_memory(const std::filesystem::path& path);

/// The bytes of a file in memory, as they shall stand on the disk.
std::string hdf5_bytes(const Hdf5File& file, const std::filesystem::path& path);

Hdf5File open_hdf5(const std::filesystem::path& path);

/// Closes and reports what could not be written.
void close_hdf5(Hdf5File& file, const std::filesystem::path& path);

Hdf5Group create_group(hid_t parent, const std::string& name, const std::filesystem::path& path);
Hdf5Group open_group(hid_t parent, const std::string& name, const std::filesystem::path& path);

/// `level` 0: contiguous; 1..9: in chunks of whole x-y planes of about 1 MB, shuffled and deflated.
Hdf5Dataset create_array(hid_t parent, const std::string& name, hid_t stored_type,
                         const std::vector<hsize_t>& shape, int level, const std::filesystem::path& path);

/// In chunks of this shape, shuffled and deflated, which are written one by one.
Hdf5Dataset create_chunked_array(hid_t parent, const std::string& name, hid_t stored_type,
                                 const std::vector<hsize_t>& shape, const std::vector<hsize_t>& chunk,
                                 int level, const std::filesystem::path& path);
/// Writes the chunk that begins there, as its filters have left it.
void write_chunk(hid_t dataset, const std::vector<hsize_t>& begin, std::string_view bytes,
                 const std::filesystem::path& path);

/// Creates an array without values and returns where in the file they belong, in one piece, in C order.
std::uint64_t place_array(hid_t parent, const std::string& name, hid_t stored_type,
                          const std::vector<hsize_t>& shape, const std::filesystem::path& path);

/// Fills rows [first, first + count) of the slowest index.
void write_rows(hid_t dataset, hid_t memory_type, hsize_t first, hsize_t count, const void* values,
                const std::filesystem::path& path);
void read_rows(hid_t dataset, hid_t memory_type, hsize_t first, hsize_t count, void* values,
               const std::filesystem::path& path);

/// `count` runs of `length` numbers each, `stride` apart.
struct Hdf5Runs {
    hsize_t first = 0;
    hsize_t stride = 1;
    hsize_t count = 0;
    hsize_t length = 0;
};

/// Reads them from a vector, or from row `row` of an array of rows.
void read_runs(hid_t dataset, hid_t memory_type, hsize_t row, const Hdf5Runs& runs, void* values,
               const std::filesystem::path& path);

bool has_link(hid_t parent, const std::string& name, const std::filesystem::path& path);

Hdf5Dataset open_array(hid_t parent, const std::string& name, const std::filesystem::path& path);
std::vector<hsize_t> shape_of(hid_t dataset, const std::filesystem::path& path);
/// The names of what a group holds, in alphabetical order.
std::vector<std::string> names_in(hid_t group, const std::filesystem::path& path);

void write_attribute(hid_t object, const char* name, std::int64_t value, const std::filesystem::path& path);
void write_attribute(hid_t object, const char* name, std::span<const std::int64_t> values,
                     const std::filesystem::path& path);
void write_attribute(hid_t object, const char* name, std::span<const double> values,
                     const std::filesystem::path& path);
void write_attribute(hid_t object, const char* name, const std::string& text,
                     const std::filesystem::path& path);

std::int64_t read_integer_attribute(hid_t object, const char* name, const std::filesystem::path& path);
std::vector<double> read_real_attribute(hid_t object, const char* name, const std::filesystem::path& path);
std::string read_text_attribute(hid_t object, const char* name, const std::filesystem::path& path);

} // namespace vesica
