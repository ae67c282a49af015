# Every library Vesica is built from, in one place. The installed package reads this file too.
find_package(OpenMP REQUIRED COMPONENTS CXX)
find_package(MPI REQUIRED COMPONENTS C)
set(HDF5_PREFER_PARALLEL ON)
find_package(HDF5 REQUIRED COMPONENTS C)
find_package(ZLIB REQUIRED)
find_package(Eigen3 REQUIRED NO_MODULE)
find_package(fmt REQUIRED)
find_package(spdlog REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(meshoptimizer REQUIRED)

# xxHash comes without a CMake package.
if(NOT TARGET xxhash::xxhash)
    find_path(XXHASH_INCLUDE_DIR xxhash.h REQUIRED)
    find_library(XXHASH_LIBRARY xxhash REQUIRED)
    mark_as_advanced(XXHASH_INCLUDE_DIR XXHASH_LIBRARY)
    add_library(xxhash::xxhash UNKNOWN IMPORTED)
    set_target_properties(xxhash::xxhash PROPERTIES
        IMPORTED_LOCATION "${XXHASH_LIBRARY}" INTERFACE_INCLUDE_DIRECTORIES "${XXHASH_INCLUDE_DIR}")
endif()

# Neither does cpp-httplib. Debian compiles it, with everything on; as it comes from its authors it is but a header.
if(NOT TARGET httplib::httplib)
    find_path(HTTPLIB_INCLUDE_DIR httplib.h REQUIRED)
    find_library(HTTPLIB_LIBRARY cpp-httplib)
    mark_as_advanced(HTTPLIB_INCLUDE_DIR HTTPLIB_LIBRARY)
    add_library(httplib::httplib INTERFACE IMPORTED)
    set_target_properties(httplib::httplib PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${HTTPLIB_INCLUDE_DIR}")
    if(HTTPLIB_LIBRARY)
        set_target_properties(httplib::httplib PROPERTIES INTERFACE_LINK_LIBRARIES "${HTTPLIB_LIBRARY}"
            INTERFACE_COMPILE_DEFINITIONS
            "CPPHTTPLIB_OPENSSL_SUPPORT;CPPHTTPLIB_ZLIB_SUPPORT;CPPHTTPLIB_BROTLI_SUPPORT")
    endif()
endif()

set(VESICA_DEPENDENCIES
    OpenMP::OpenMP_CXX MPI::MPI_C hdf5::hdf5 ZLIB::ZLIB Eigen3::Eigen fmt::fmt spdlog::spdlog
    tomlplusplus::tomlplusplus CLI11::CLI11 nlohmann_json::nlohmann_json xxhash::xxhash)
# Needed by a file or two each: linked, and found, but without its definitions in every compilation.
set(VESICA_PRIVATE_DEPENDENCIES meshoptimizer::meshoptimizer httplib::httplib)
# mpi.h, read by the parallel hdf5.h, would otherwise bring MPI's abandoned C++ bindings.
set(VESICA_DEPENDENCY_DEFINITIONS OMPI_SKIP_MPICXX MPICH_SKIP_MPICXX)
