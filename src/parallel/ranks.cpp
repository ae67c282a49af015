#include "parallel/ranks.hpp"

#include "core/input_error.hpp"
#include "parallel/communicator.hpp"

#include <algorithm>
#include <bit>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <numeric>

namespace vesica {

namespace {

/// Messages longer than an int counts go in pieces.
constexpr std::size_t piece = std::size_t{1} << 30;
constexpr int gather_tag = 1;
constexpr int exchange_tag = 2;

struct Launcher {
    const char* size;
    const char* rank;
};

/// mpirun before the resource manager that may have started it.
constexpr Launcher launchers[] = {{"OMPI_COMM_WORLD_SIZE", "OMPI_COMM_WORLD_RANK"},
                                  {"MV2_COMM_WORLD_SIZE", "MV2_COMM_WORLD_RANK"},
                                  {"PMI_SIZE", "PMI_RANK"},
                                  {"SLURM_STEP_NUM_TASKS", "SLURM_PROCID"}};

/// What the first launcher that is there says; 0 without one.
int told_by_launcher(const char* Launcher::*variable) {
    for (const Launcher& launcher : launchers)
        if (std::getenv(launcher.size) != nullptr) {
            const char* const text = std::getenv(launcher.*variable);
            return text != nullptr ? std::atoi(text) : 0;
        }
    return 0;
}

template <class Body>
void for_each_piece(std::size_t bytes, const Body& body) {
    for (std::size_t begin = 0; begin < bytes; begin += piece)
        body(begin, static_cast<int>(std::min(piece, bytes - begin)));
}

} // namespace

int MpiSession::promised() {
    return std::max(1, told_by_launcher(&Launcher::size));
}

int MpiSession::promised_rank() {
    return told_by_launcher(&Launcher::rank);
}

MpiSession::MpiSession() {
    if (promised() == 1)
        return;
    int provided = 0;
    int by_others = 0;
    MPI_Initialized(&by_others); // mpi4py; then it is theirs to end
    if (by_others != 0) {
        MPI_Query_thread(&provided);
    } else {
        MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
        begun_ = true;
    }
    if (provided < MPI_THREAD_FUNNELED)
        throw RunError("this MPI library does not allow threads; expected one built with their support");
}

MpiSession::~MpiSession() {
    if (begun_)
        MPI_Finalize();
}

Ranks Ranks::all() {
    Ranks ranks;
    int begun = 0;
    MPI_Initialized(&begun);
    if (begun == 0)
        return ranks;
    MPI_Comm_size(MPI_COMM_WORLD, &ranks.count_);
    MPI_Comm_rank(MPI_COMM_WORLD, &ranks.rank_);
    if (ranks.count_ == 1)
        return ranks;
    MPI_Comm own = MPI_COMM_NULL;
    MPI_Comm_dup(MPI_COMM_WORLD, &own);
    ranks.communicator_ = std::make_shared<Communicator>(own);
    return ranks;
}

void Ranks::sum(std::span<std::uint64_t> values) const {
    if (!communicator_)
        return;
    const auto begin = std::chrono::steady_clock::now();
    MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_UINT64_T, MPI_SUM,
                  communicator_->handle);
    communicator_->seconds_summing +=
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

double Ranks::seconds_summing() const {
    return communicator_ ? communicator_->seconds_summing : 0.0;
}

bool Ranks::any(bool here) const {
    std::uint64_t votes = here ? 1 : 0;
    sum({&votes, 1});
    return votes != 0;
}

void Ranks::broadcast(std::span<std::byte> bytes) const {
    if (communicator_)
        for_each_piece(bytes.size(), [&](std::size_t begin, int count) {
            MPI_Bcast(bytes.data() + begin, count, MPI_BYTE, 0, communicator_->handle);
        });
}

std::string Ranks::broadcast(const std::string& text) const {
    std::uint64_t length = text.size();
    broadcast(std::as_writable_bytes(std::span(&length, 1)));
    std::string copy = leads() ? text : std::string(length, '\0');
    broadcast(std::as_writable_bytes(std::span(copy)));
    return copy;
}

void Ranks::gather(std::span<const std::byte> bytes,
                   const std::function<void(int, std::span<const std::byte>)>& take) const {
    if (!communicator_) {
        take(0, bytes);
        return;
    }
    const MPI_Comm group = communicator_->handle;
    const std::uint64_t length = bytes.size();
    std::vector<std::uint64_t> lengths(leads() ? static_cast<std::size_t>(count_) : 0);
    MPI_Gather(&length, 1, MPI_UINT64_T, lengths.data(), 1, MPI_UINT64_T, 0, group);
    if (!leads()) {
        for_each_piece(bytes.size(), [&](std::size_t begin, int count) {
            MPI_Send(bytes.data() + begin, count, MPI_BYTE, 0, gather_tag, group);
        });
        return;
    }
    take(0, bytes);
    std::vector<std::byte> part;
    for (int from = 1; from < count_; ++from) {
        part.resize(lengths[static_cast<std::size_t>(from)]);
        for_each_piece(part.size(), [&](std::size_t begin, int count) {
            MPI_Recv(part.data() + begin, count, MPI_BYTE, from, gather_tag, group, MPI_STATUS_IGNORE);
        });
        take(from, part);
    }
}

std::vector<std::vector<std::byte>> Ranks::exchange(std::vector<std::vector<std::byte>> parts) const {
    if (!communicator_)
        return parts;
    const MPI_Comm group = communicator_->handle;
    const auto own = static_cast<std::size_t>(rank_);
    std::vector<std::uint64_t> leaving, coming(parts.size());
    for (const auto& part : parts)
        leaving.push_back(part.size());
    MPI_Alltoall(leaving.data(), 1, MPI_UINT64_T, coming.data(), 1, MPI_UINT64_T, group);
    std::vector<std::vector<std::byte>> arrived(parts.size());
    std::vector<MPI_Request> requests;
    for (std::size_t from = 0; from < parts.size(); ++from) {
        if (from == own)
            continue;
        arrived[from].resize(coming[from]);
        for_each_piece(coming[from], [&](std::size_t begin, int count) {
            MPI_Irecv(arrived[from].data() + begin, count, MPI_BYTE, static_cast<int>(from), exchange_tag,
                      group, &requests.emplace_back());
        });
    }
    for (std::size_t to = 0; to < parts.size(); ++to)
        if (to != own)
            for_each_piece(parts[to].size(), [&](std::size_t begin, int count) {
                MPI_Isend(parts[to].data() + begin, count, MPI_BYTE, static_cast<int>(to), exchange_tag,
                          group, &requests.emplace_back());
            });
    arrived[own] = std::move(parts[own]);
    MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
    return arrived;
}

std::vector<std::byte> Ranks::gather_to_all(std::span<const std::byte> bytes) const {
    if (!communicator_)
        return {bytes.begin(), bytes.end()};
    std::vector<std::byte> all(bytes.size() * static_cast<std::size_t>(count_));
    const int length = static_cast<int>(bytes.size());
    MPI_Allgather(bytes.data(), length, MPI_BYTE, all.data(), length, MPI_BYTE, communicator_->handle);
    return all;
}

int Ranks::share_of_processors(std::span<const std::uint64_t> mask) const {
    const auto processors = [](std::span<const std::uint64_t> bits) {
        return std::accumulate(bits.begin(), bits.end(), 0,
                               [](int sum, std::uint64_t word) { return sum + std::popcount(word); });
    };
    const int own = processors(mask);
    if (!communicator_)
        return std::max(own, 1);
    // Ranks may be bound to processors of their own, or share some, or all.
    MPI_Comm machine = MPI_COMM_NULL;
    MPI_Comm_split_type(communicator_->handle, MPI_COMM_TYPE_SHARED, rank_, MPI_INFO_NULL, &machine);
    std::vector<std::uint64_t> all(mask.size());
    int wanted = 0;
    MPI_Allreduce(mask.data(), all.data(), static_cast<int>(mask.size()), MPI_UINT64_T, MPI_BOR, machine);
    MPI_Allreduce(&own, &wanted, 1, MPI_INT, MPI_SUM, machine);
    MPI_Comm_free(&machine);
    return std::max(own * processors(all) / std::max(wanted, 1), 1);
}

void Ranks::abandon(int status, const std::exception& reason) const {
    std::cerr << "vesica: rank " << rank_ << ": " << words_of(reason) << std::endl;
    if (communicator_)
        MPI_Abort(communicator_->handle, status);
    std::_Exit(status);
}

} // namespace vesica
