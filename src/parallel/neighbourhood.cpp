#include "parallel/neighbourhood.hpp"

#include "core/input_error.hpp"
#include "parallel/communicator.hpp"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <limits>
#include <map>
#include <optional>
#include <utility>

namespace vesica {

/// Without a group it has one node, whose messages to itself are copied.
struct Neighbourhood::Graph {
    std::optional<Ranks::Communicator> group;
};

struct Messages::Request {
    MPI_Request handle = MPI_REQUEST_NULL;
};

namespace {

int modulo(int a, int n) {
    return ((a % n) + n) % n;
}

MPI_Comm cartesian(MPI_Comm group, const Vec3<int>& blocks) {
    const int dimensions[3] = {blocks.z, blocks.y, blocks.x};
    const int periodic[3] = {1, 1, 1};
    MPI_Comm grid = MPI_COMM_NULL;
    MPI_Cart_create(group, 3, dimensions, periodic, 0,
                    &grid); // not renumbered: the first rank speaks for all
    return grid;
}

Vec3<int> place_of(MPI_Comm grid, int rank) {
    int place[3] = {};
    MPI_Cart_coords(grid, rank, 3, place);
    return {place[2], place[1], place[0]};
}

int rank_at(MPI_Comm grid, const Vec3<int>& place) {
    const int coordinates[3] = {place.z, place.y, place.x};
    int rank = 0;
    MPI_Cart_rank(grid, coordinates, &rank);
    return rank;
}

} // namespace

Neighbourhood::Neighbourhood(const Ranks& ranks, const BlockLayout& layout) : ranks_(ranks) {
    assert(ranks.count() == layout.count());
    if (ranks.count() == 1) {
        block_ = layout.block({});
        parts_ = halo_parts(block_);
        if (!parts_.empty())
            meet_oneself();
        return;
    }
    const Vec3<int> blocks = layout.blocks();
    const Ranks::Communicator grid(cartesian(ranks.communicator()->handle, blocks));
    const Vec3<int> here = place_of(grid.handle, ranks.rank());
    block_ = layout.block(here);
    parts_ = halo_parts(block_);

    const auto rank_towards = [&](const Vec3<int>& link) {
        Vec3<int> place = here + link;
        for (int a = 0; a < 3; ++a)
            place[a] = modulo(place[a], blocks[a]);
        return rank_at(grid.handle, place);
    };
    std::map<int, Neighbour> by_rank;
    for (int k = 0; k < 27; ++k) {
        const Vec3<int> link{k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1};
        if (const int rank = rank_towards(link); rank != ranks.rank())
            by_rank[rank];
    }
    for (std::size_t part = 0; part < parts_.size(); ++part)
        by_rank[rank_towards(parts_[part].link)].incoming.push_back(part);
    // The receiver's links are the sender's, the other way round.
    for (std::size_t part = parts_.size(); part-- > 0;)
        by_rank[rank_towards(parts_[part].link)].outgoing.push_back(part);
    for (auto& [rank, neighbour] : by_rank) {
        neighbour.rank = rank;
        neighbour.block = layout.block(place_of(grid.handle, rank));
        neighbours_.push_back(std::move(neighbour));
    }
    std::stable_partition(neighbours_.begin(), neighbours_.end(),
                          [](const Neighbour& neighbour) { return !neighbour.outgoing.empty(); });
    make_graphs(grid);
}

void Neighbourhood::meet_oneself() {
    Neighbour self{ranks_.rank(), block_, {}, {}};
    for (std::size_t part = 0; part < parts_.size(); ++part) {
        self.incoming.push_back(part);
        self.outgoing.push_back(parts_.size() - 1 - part);
    }
    neighbours_.push_back(std::move(self));
    linked_count_ = 1;
    linked_ = all_ = std::make_shared<Graph>();
}

void Neighbourhood::make_graphs(const Ranks::Communicator& grid) {
    const auto graph_of_first = [&](std::size_t count) {
        std::vector<int> ranks;
        for (std::size_t k = 0; k < count; ++k)
            ranks.push_back(neighbours_[k].rank);
        const int degree = static_cast<int>(count);
        MPI_Comm graph = MPI_COMM_NULL;
        MPI_Dist_graph_create_adjacent(grid.handle, degree, ranks.data(), MPI_UNWEIGHTED, degree,
                                       ranks.data(), MPI_UNWEIGHTED, MPI_INFO_NULL, 0, &graph);
        auto made = std::make_shared<Graph>();
        made->group.emplace(graph);
        return made;
    };
    const auto corner = std::find_if(neighbours_.begin(), neighbours_.end(),
                                     [](const Neighbour& neighbour) { return neighbour.outgoing.empty(); });
    linked_count_ = static_cast<std::size_t>(corner - neighbours_.begin());
    linked_ = graph_of_first(linked_count_);
    all_ = graph_of_first(neighbours_.size());
}

std::vector<std::vector<std::byte>>
Neighbourhood::exchange(const std::vector<std::vector<std::byte>>& outgoing) const {
    std::vector<std::vector<std::byte>> incoming(neighbours_.size());
    if (!all_)
        return incoming;
    assert(outgoing.size() == neighbours_.size());
    std::vector<std::uint64_t> lengths;
    for (const auto& message : outgoing)
        lengths.push_back(message.size());
    std::vector<std::uint64_t> lengths_coming(lengths.size());
    if (all_->group)
        MPI_Neighbor_alltoall(lengths.data(), 1, MPI_UINT64_T, lengths_coming.data(), 1, MPI_UINT64_T,
                              all_->group->handle);
    else
        lengths_coming = lengths;
    Messages messages(all_);
    messages.resize(std::vector<std::size_t>(lengths.begin(), lengths.end()),
                    std::vector<std::size_t>(lengths_coming.begin(), lengths_coming.end()));
    for (std::size_t k = 0; k < outgoing.size(); ++k)
        std::copy(outgoing[k].begin(), outgoing[k].end(), messages.outgoing(k));
    messages.start();
    messages.finish();
    for (std::size_t k = 0; k < incoming.size(); ++k)
        incoming[k].assign(messages.incoming(k), messages.incoming(k) + lengths_coming[k]);
    return incoming;
}

Messages::Messages() : request_(std::make_unique<Request>()) {}
Messages::Messages(const Neighbourhood& neighbourhood) : Messages(neighbourhood.linked_) {}
Messages::Messages(std::shared_ptr<Neighbourhood::Graph> graph)
    : graph_(std::move(graph)), request_(std::make_unique<Request>()) {}
Messages::Messages(Messages&&) noexcept = default;
Messages& Messages::operator=(Messages&&) noexcept = default;
Messages::~Messages() = default;

void Messages::lay_out(Direction& direction, std::span<const std::size_t> sizes) {
    direction.counts.clear();
    direction.offsets.clear();
    std::size_t offset = 0;
    for (const std::size_t size : sizes) {
        direction.counts.push_back(static_cast<int>(size));
        direction.offsets.push_back(static_cast<int>(offset));
        offset += (size + 63) / 64 * 64;
        if (offset > static_cast<std::size_t>(std::numeric_limits<int>::max()))
            throw RunError("a message to neighbouring ranks has more than 2 GB; try more ranks");
    }
    if (direction.bytes.size() < offset)
        direction.bytes.resize(offset);
}

void Messages::resize(std::span<const std::size_t> outgoing, std::span<const std::size_t> incoming) {
    lay_out(outgoing_, outgoing);
    lay_out(incoming_, incoming);
}

void Messages::start() {
    if (!graph_)
        return;
    if (!graph_->group) {
        assert(outgoing_.counts == incoming_.counts);
        for (std::size_t k = 0; k < outgoing_.counts.size(); ++k)
            std::copy_n(outgoing_.bytes.begin() + outgoing_.offsets[k], outgoing_.counts[k],
                        incoming_.bytes.begin() + incoming_.offsets[k]);
        return;
    }
    MPI_Ineighbor_alltoallv(outgoing_.bytes.data(), outgoing_.counts.data(), outgoing_.offsets.data(),
                            MPI_BYTE, incoming_.bytes.data(), incoming_.counts.data(),
                            incoming_.offsets.data(), MPI_BYTE, graph_->group->handle, &request_->handle);
    for (const int count : outgoing_.counts) {
        messages_sent_ += count > 0 ? 1 : 0;
        bytes_sent_ += count;
    }
}

void Messages::progress() {
    int done = 0;
    if (graph_ && graph_->group)
        MPI_Test(&request_->handle, &done, MPI_STATUS_IGNORE);
}

void Messages::finish() {
    if (!graph_ || !graph_->group)
        return;
    const auto begin = std::chrono::steady_clock::now();
    MPI_Wait(&request_->handle, MPI_STATUS_IGNORE);
    seconds_waiting_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

} // namespace vesica
