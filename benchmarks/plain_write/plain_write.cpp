// plain_write FILE BYTES: writes so many bytes by parallel HDF5, each rank its part, collectively; closes,
// syncs and prints megabytes per second of the whole. What any checkpoint is measured against.
#include <fcntl.h>
#include <hdf5.h>
#include <mpi.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <vector>

namespace {

bool write(const char* path, hsize_t count, int rank, int ranks) {
    const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
    H5Pset_fapl_mpio(access, MPI_COMM_WORLD, MPI_INFO_NULL);
    const hid_t file = H5Fcreate(path, H5F_ACC_TRUNC, H5P_DEFAULT, access);
    const hid_t space = H5Screate_simple(1, &count, nullptr);
    const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_fill_time(creation, H5D_FILL_TIME_NEVER);
    const hid_t array =
        H5Dcreate2(file, "numbers", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, creation, H5P_DEFAULT);
    const hsize_t begin = count * static_cast<hsize_t>(rank) / static_cast<hsize_t>(ranks);
    const hsize_t length = count * static_cast<hsize_t>(rank + 1) / static_cast<hsize_t>(ranks) - begin;
    std::vector<double> part(length);
    for (hsize_t k = 0; k < length; ++k)
        part[k] = 1e-3 * static_cast<double>(begin + k);
    MPI_Barrier(MPI_COMM_WORLD);
    const double started = MPI_Wtime();
    H5Sselect_hyperslab(space, H5S_SELECT_SET, &begin, nullptr, &length, nullptr);
    const hid_t memory = H5Screate_simple(1, &length, nullptr);
    const hid_t transfer = H5Pcreate(H5P_DATASET_XFER);
    H5Pset_dxpl_mpio(transfer, H5FD_MPIO_COLLECTIVE);
    const bool written = H5Dwrite(array, H5T_NATIVE_DOUBLE, memory, space, transfer, part.data()) >= 0;
    H5Pclose(transfer);
    H5Sclose(memory);
    H5Dclose(array);
    H5Pclose(creation);
    H5Sclose(space);
    const bool closed = H5Fclose(file) >= 0;
    H5Pclose(access);
    if (rank == 0) {
        const int descriptor = open(path, O_RDONLY | O_CLOEXEC);
        fsync(descriptor);
        close(descriptor);
    }
    MPI_Barrier(MPI_COMM_WORLD);
    if (rank == 0)
        std::printf("%.1f MB/s\n", 8e-6 * static_cast<double>(count) / (MPI_Wtime() - started));
    return written && closed;
}

} // namespace

int main(int argument_count, char** arguments) {
    if (argument_count != 3) {
        std::fprintf(stderr, "usage: %s FILE BYTES\n", arguments[0]);
        return 2;
    }
    MPI_Init(&argument_count, &arguments);
    int rank = 0;
    int ranks = 1;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    const bool good =
        write(arguments[1], static_cast<hsize_t>(std::atoll(arguments[2])) / sizeof(double), rank, ranks);
    MPI_Finalize();
    return good ? 0 : 1;
}
