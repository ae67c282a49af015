#include "io/hdf5_array.hpp"
#include "voxel_samples.hpp"

#include <limits>

using namespace voxel_samples;

namespace {

template <class Value>
void put_array(hid_t file, const std::string& name, hid_t type, const std::vector<Value>& values,
               const std::vector<hsize_t>& shape, int level = 0) {
    const auto array = create_array(file, name, type, shape, level, "sample");
    write_rows(array, type, 0, shape.front(), values.data(), "sample");
}

const std::vector<hsize_t> shape{3, 4, 5};

} // namespace

TEST_CASE("Bytes without a header are read with x fastest") {
    CHECK(expected().count() > 10);
    CHECK(read("cells.raw", bytes_of(values_of<std::uint8_t>(1))) == expected());
    CHECK(read("cells.RAW", bytes_of(values_of<std::uint8_t>(255))) == expected());
}

TEST_CASE("Files that are not there, of an unknown kind or of a wrong length are refused") {
    const std::string kinds = "a .raw, .h5, .hdf5 or .vti file";
    CHECK(complaint_of<InputError>([] { read_voxels("no/such/rock.raw", size); }) ==
          "no/such/rock.raw: the voxel file does not exist; expected " + kinds +
              "; try a path relative to the case file's folder or an absolute one");
    CHECK(complaint_of<InputError>([] { read_voxels("rock.tif", size); }) ==
          "rock.tif: the ending \".tif\" is of no kind known for voxels; expected " + kinds);
    const ScratchDirectory scratch;
    std::filesystem::create_directory(scratch / "folder.raw");
    CHECK_THROWS_WITH(read_voxels(scratch / "folder.raw", size),
                      Catch::EndsWith("/folder.raw: this is not a file; expected " + kinds));
    CHECK(refusal("short.raw", std::string(59, '\0')) ==
          " the file has 59 bytes; expected 60, one for each of 5 x 4 x 3 cells; try 8-bit values without a "
          "header, x fastest, or change the lattice's size");
    CHECK(refusal("named.raw", std::string(60, '\0'), "solid") ==
          " the data set solid is asked for; expected none, for a .raw file holds one array without a name; "
          "leave the name away");
}

TEST_CASE("Integers of every kind and booleans are read from HDF5") {
    const ScratchDirectory scratch;
    const auto path = scratch / "rock.h5";
    {
        Hdf5File file = create_hdf5(path, 0, path);
        put_array(file, "bytes", H5T_NATIVE_UINT8, values_of<std::uint8_t>(200), shape);
        put_array(file, "negative", H5T_NATIVE_INT32, values_of<std::int32_t>(-1), shape, 4);
        put_array(file, "large", H5T_NATIVE_UINT64, values_of(std::numeric_limits<std::uint64_t>::max()),
                  shape);
        put_array(file, "short", H5T_NATIVE_INT16, values_of<std::int16_t>(256), shape);
        const auto group = create_group(file, "rock", path);
        put_array(group, "big_endian", H5T_STD_I32BE, values_of<std::int32_t>(1 << 24), shape);
        const Hdf5Type boolean(H5Tenum_create(H5T_NATIVE_INT8)); // as h5py writes it
        const std::int8_t no = 0, yes = 1;
        H5Tenum_insert(boolean, "FALSE", &no);
        H5Tenum_insert(boolean, "TRUE", &yes);
        put_array(file, "boolean", boolean, values_of<std::int8_t>(1), shape);
        close_hdf5(file, path);
    }
    for (const char* name : {"bytes", "negative", "large", "short", "rock/big_endian", "/boolean"}) {
        INFO(name);
        CHECK(read_voxels(path, size, name) == expected());
    }
}

TEST_CASE("The only data set with three dimensions need not be named") {
    const ScratchDirectory scratch;
    const auto path = scratch / "rock.hdf5";
    Hdf5File file = create_hdf5(path, 0, path);
    put_array(file, "solid", H5T_NATIVE_UINT8, values_of<std::uint8_t>(1), shape);
    put_array(file, "spacing", H5T_NATIVE_DOUBLE, std::vector<double>{1.0, 1.0, 1.0}, {3});
    create_group(file, "notes", path);
    H5Lcreate_soft("/nowhere", file, "dangling", H5P_DEFAULT, H5P_DEFAULT);
    close_hdf5(file, path);
    CHECK(read_voxels(path, size) == expected());
}

TEST_CASE("What HDF5 holds instead is told") {
    const ScratchDirectory scratch;
    const auto path = scratch / "rock.h5";
    Hdf5File file = create_hdf5(path, 0, path);
    const auto complaint = [&](const std::string& name) {
        H5Fflush(file, H5F_SCOPE_LOCAL);
        return complaint_of<InputError>([&] { read_voxels(path, size, name); }).substr(path.string().size());
    };
    put_array(file, "list", H5T_NATIVE_UINT8, std::vector<std::uint8_t>(60), {60});
    CHECK(complaint("") == ": no data set at the root has three dimensions; expected one of shape (nz, ny, "
                           "nx); try to name a data set inside a group");
    put_array(file, "other", H5T_NATIVE_UINT8, std::vector<std::uint8_t>(24), {2, 3, 4});
    put_array(file, "reversed", H5T_NATIVE_UINT8, std::vector<std::uint8_t>(60), {5, 4, 3});
    put_array(file, "real", H5T_NATIVE_DOUBLE, values_of(1.0), shape);
    CHECK(complaint("") ==
          ": the data sets other, real, reversed have three dimensions; expected one; try to "
          "name the one that marks solid cells");
    CHECK(complaint("solid") == ": there is no data set solid; expected one of shape (nz, ny, nx); the root "
                                "holds: list, other, real, reversed");
    CHECK(complaint("other") ==
          ": the data set other has the shape (2, 3, 4); expected (3, 4, 5), which is (nz, ny, nx); try an "
          "array with one value for each cell of the lattice");
    CHECK(
        complaint("reversed") ==
        ": the data set reversed has the shape (5, 4, 3); expected (3, 4, 5), which is (nz, ny, nx); try to "
        "write its transpose: its first index seems to be that of x");
    CHECK(complaint("list") ==
          ": the data set list has the shape (60); expected (3, 4, 5), which is (nz, ny, "
          "nx); try an array with one value for each cell of the lattice");
    CHECK(complaint("real") ==
          ": the data set real holds real numbers; expected integers or booleans; try to "
          "write it as 8-bit integers, 1 where it is solid and 0 elsewhere");
    CHECK(refusal("text.h5", "this is no HDF5") ==
          " cannot open as HDF5: file signature not found; expected a .raw, .h5, .hdf5 or .vti file that can "
          "be read; check its permissions, or write it anew");
}
