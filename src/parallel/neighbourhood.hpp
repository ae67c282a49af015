#pragma once

#include "parallel/block_layout.hpp"
#include "parallel/ranks.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace vesica {

/// The blocks around one's own, corner to corner, and the ranks that hold them. Ranks lie on MPI's Cartesian
/// topology, x fastest; each distinct neighbour is one node of a graph on top of it, so that one message goes
/// each way whatever the number of faces and edges two blocks share. Across sliding faces a block may be its
/// own neighbour.
class Neighbourhood {
public:
    struct Neighbour {
        int rank = 0;
        Block block; ///< what it works on
        /// Which of the block's halo_parts go there and which come from there, in the order in which they lie
        /// in the messages: the receiver's.
        std::vector<std::size_t> outgoing;
        std::vector<std::size_t> incoming;
    };

    /// Alone in the box.
    explicit Neighbourhood(const Vec3<int>& box) : block_(Block::whole(box)) {}
    /// By all ranks together; the layout has a block for each.
    Neighbourhood(const Ranks& ranks, const BlockLayout& layout);

    const Ranks& ranks() const { return ranks_; }
    const Block& block() const { return block_; }
    const std::vector<HaloPart>& parts() const { return parts_; }
    /// All around, corners too: those that share faces or edges first.
    const std::vector<Neighbour>& neighbours() const { return neighbours_; }
    /// Those alone that share faces or edges.
    std::span<const Neighbour> linked_neighbours() const {
        return std::span(neighbours_).first(linked_count_);
    }

    /// Sends each neighbour what is meant for it and returns what they sent, of any length.
    std::vector<std::vector<std::byte>> exchange(const std::vector<std::vector<std::byte>>& outgoing) const;

private:
    friend class Messages;
    struct Graph;

    void meet_oneself();
    void make_graphs(const Ranks::Communicator& grid);

    Ranks ranks_;
    Block block_;
    std::vector<HaloPart> parts_;
    std::vector<Neighbour> neighbours_;
    std::size_t linked_count_ = 0;
    std::shared_ptr<Graph> linked_; ///< across faces and edges; null without neighbours
    std::shared_ptr<Graph> all_;    ///< with the corners
};

/// One packed message to every neighbour across a face or an edge and one from it, over and over. Work can be
/// done between start() and finish().
class Messages {
public:
    Messages();
    explicit Messages(const Neighbourhood& neighbourhood);
    Messages(Messages&&) noexcept;
    Messages& operator=(Messages&&) noexcept;
    ~Messages();

    /// Bytes per linked neighbour of the messages to come; what they hold is lost.
    void resize(std::span<const std::size_t> outgoing, std::span<const std::size_t> incoming);

    std::byte* outgoing(std::size_t neighbour) { return at(outgoing_, neighbour); }
    const std::byte* incoming(std::size_t neighbour) { return at(incoming_, neighbour); }

    void start();
    /// Lets MPI move what it has in hand; cheap.
    void progress();
    void finish();

    /// Since the beginning: what left this rank, and the seconds finish() waited.
    std::int64_t messages_sent() const { return messages_sent_; }
    std::int64_t bytes_sent() const { return bytes_sent_; }
    double seconds_waiting() const { return seconds_waiting_; }

private:
    struct Direction {
        std::vector<int> counts;
        std::vector<int> offsets;
        std::vector<std::byte> bytes;
    };
    struct Request;
    friend class Neighbourhood;
    explicit Messages(std::shared_ptr<Neighbourhood::Graph> graph);

    static std::byte* at(Direction& direction, std::size_t neighbour) {
        return direction.bytes.data() + direction.offsets[neighbour];
    }
    static void lay_out(Direction& direction, std::span<const std::size_t> sizes);

    std::shared_ptr<Neighbourhood::Graph> graph_;
    Direction outgoing_;
    Direction incoming_;
    std::unique_ptr<Request> request_;
    std::int64_t messages_sent_ = 0;
    std::int64_t bytes_sent_ = 0;
    double seconds_waiting_ = 0.0;
};

} // namespace vesica
