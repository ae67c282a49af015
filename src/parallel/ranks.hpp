#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace vesica {

/// MPI, for as long as it lives, if a launcher (mpirun, srun, ...) has started this process as one of
/// several; nothing at all otherwise. One per process. Only the thread that made it calls MPI.
class MpiSession {
public:
    MpiSession();
    ~MpiSession();
    MpiSession(const MpiSession&) = delete;
    MpiSession& operator=(const MpiSession&) = delete;

    /// How many processes the launcher says it has started, and which of them this is, by its variables; 1
    /// and 0 without one.
    static int promised();
    static int promised_rank();

private:
    bool begun_ = false;
};

/// The processes that work on a run together. Every call but count, rank and leads must be made by all of
/// them in the same order. A copy means the same group.
class Ranks {
public:
    /// This process alone; needs no MPI.
    Ranks() = default;
    /// All that the launcher started: alone without one. Needs an MpiSession.
    static Ranks all();

    int count() const { return count_; }
    int rank() const { return rank_; }
    /// The first one speaks, reads and writes for all.
    bool leads() const { return rank_ == 0; }

    /// Sums over all ranks, modulo 2^64: the same whatever their order.
    void sum(std::span<std::uint64_t> values) const;
    /// Whether it holds on one of them.
    bool any(bool here) const;

    /// Seconds this process has spent in sums so far, most of them waiting for the slowest.
    double seconds_summing() const;

    /// What the first has, to all.
    void broadcast(std::span<std::byte> bytes) const;
    std::string broadcast(const std::string& text) const;

    /// To the first: take(rank, what it has), one after the other. On the others `take` is not called.
    void gather(std::span<const std::byte> bytes,
                const std::function<void(int, std::span<const std::byte>)>& take) const;

    /// What each has for each of the others, and for itself, to them: parts[rank] goes to `rank`; returned by
    /// the ranks it came from.
    std::vector<std::vector<std::byte>> exchange(std::vector<std::vector<std::byte>> parts) const;

    /// To all: what each has, which must be equally long.
    std::vector<std::byte> gather_to_all(std::span<const std::byte> bytes) const;

    template <class T>
    std::vector<T> gather_all(const T& value) const {
        const std::vector<std::byte> bytes = gather_to_all(std::as_bytes(std::span(&value, 1)));
        std::vector<T> all(bytes.size() / sizeof(T));
        std::copy(bytes.begin(), bytes.end(), std::as_writable_bytes(std::span(all)).begin());
        return all;
    }

    /// How many processors fall to each of the ranks that share this machine, given which of them this one
    /// may use: bit k of the mask for processor k.
    int share_of_processors(std::span<const std::uint64_t> mask) const;

    /// Says why and ends all processes at once, for the sake of one that cannot go on.
    [[noreturn]] void abandon(int status, const std::exception& reason) const;

    struct Communicator;
    const Communicator* communicator() const { return communicator_.get(); } ///< null when alone

private:
    int count_ = 1;
    int rank_ = 0;
    std::shared_ptr<Communicator> communicator_;
};

} // namespace vesica
