#include "parallel/ranks.hpp"

#include "parallel/communicator.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>

namespace vesica {

namespace {

/// Messages longer than an int counts go in pieces.
constexpr std::size_t piece = std::size_t{1} << 30;
constexpr int gather_tag = 1;

template <class Body>
void for_each_piece(std::size_t bytes, const Body& body) {
    for (std::size_t begin = 0; begin < bytes; begin += piece)
        body(begin, static_cast<int>(std::min(piece, bytes - begin)));
}

} // namespace

bool MpiSession::is_launched() {
    constexpr std::array variables = {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK", "MV2_COMM_WORLD_RANK"};
    return std::any_of(variables.begin(), variables.end(),
                       [](const char* name) { return std::getenv(name) != nullptr; });
}

int MpiSession::promised() {
    constexpr std::array variables = {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "MV2_COMM_WORLD_SIZE",
                                      "SLURM_STEP_NUM_TASKS"};
    int most = 1;
    for (const char* const name : variables)
        if (const char* const text = std::getenv(name))
            most = std::max(most, std::atoi(text));
    return most;
}

MpiSession::MpiSession() {
    if (!is_launched())
        return;
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
    begun_ = true;
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

std::vector<std::vector<std::byte>> Ranks::gather(std::span<const std::byte> bytes) const {
    if (!communicator_)
        return {{bytes.begin(), bytes.end()}};
    const MPI_Comm group = communicator_->handle;
    const std::uint64_t length = bytes.size();
    std::vector<std::uint64_t> lengths(leads() ? static_cast<std::size_t>(count_) : 0);
    MPI_Gather(&length, 1, MPI_UINT64_T, lengths.data(), 1, MPI_UINT64_T, 0, group);
    if (!leads()) {
        for_each_piece(bytes.size(), [&](std::size_t begin, int count) {
            MPI_Send(bytes.data() + begin, count, MPI_BYTE, 0, gather_tag, group);
        });
        return {};
    }
    std::vector<std::vector<std::byte>> all{{bytes.begin(), bytes.end()}};
    for (int from = 1; from < count_; ++from) {
        std::vector<std::byte>& part = all.emplace_back(lengths[static_cast<std::size_t>(from)]);
        for_each_piece(part.size(), [&](std::size_t begin, int count) {
            MPI_Recv(part.data() + begin, count, MPI_BYTE, from, gather_tag, group, MPI_STATUS_IGNORE);
        });
    }
    return all;
}

std::vector<std::byte> Ranks::gather_to_all(std::span<const std::byte> bytes) const {
    if (!communicator_)
        return {bytes.begin(), bytes.end()};
    std::vector<std::byte> all(bytes.size() * static_cast<std::size_t>(count_));
    const int length = static_cast<int>(bytes.size());
    MPI_Allgather(bytes.data(), length, MPI_BYTE, all.data(), length, MPI_BYTE, communicator_->handle);
    return all;
}

std::int64_t Ranks::sum_on_this_machine(std::int64_t value) const {
    if (!communicator_)
        return value;
    MPI_Comm machine = MPI_COMM_NULL;
    MPI_Comm_split_type(communicator_->handle, MPI_COMM_TYPE_SHARED, rank_, MPI_INFO_NULL, &machine);
    MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_INT64_T, MPI_SUM, machine);
    MPI_Comm_free(&machine);
    return value;
}

void Ranks::abandon(int status) const {
    if (communicator_)
        MPI_Abort(communicator_->handle, status);
    std::_Exit(status);
}

} // namespace vesica
