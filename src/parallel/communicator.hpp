#pragma once

#include "parallel/ranks.hpp"

#include <mpi.h>

namespace vesica {

/// MPI's own handle, for the few files that call MPI.
struct Ranks::Communicator {
    MPI_Comm handle = MPI_COMM_NULL;
    mutable double seconds_summing = 0.0;

    explicit Communicator(MPI_Comm owned) : handle(owned) {}
    Communicator(const Communicator&) = delete;
    Communicator& operator=(const Communicator&) = delete;
    ~Communicator() {
        if (handle != MPI_COMM_NULL)
            MPI_Comm_free(&handle);
    }
};

} // namespace vesica
