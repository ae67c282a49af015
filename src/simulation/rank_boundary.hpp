#pragma once

#include "boundary/population_halo.hpp"
#include "parallel/for_each.hpp"
#include "parallel/neighbourhood.hpp"

#include <vector>

namespace vesica {

/// The boundary between blocks of different processes: the populations that cross it travel while the inner
/// cells are worked on.
template <class Real>
class RankBoundary {
public:
    RankBoundary(const Neighbourhood& neighbourhood, const PopulationView<Real>& f, const Grid& grid)
        : neighbourhood_(neighbourhood), halo_(f, grid, neighbourhood.block()), messages_(neighbourhood) {
        std::vector<std::size_t> outgoing;
        std::vector<std::size_t> incoming;
        for (const Neighbourhood::Neighbour& neighbour : neighbourhood.linked_neighbours()) {
            outgoing.push_back(place(neighbour.outgoing, outgoing.size(), outgoing_));
            incoming.push_back(place(neighbour.incoming, incoming.size(), incoming_));
        }
        messages_.resize(outgoing, incoming);
    }

    const Vec3<bool>& divided() const { return neighbourhood_.block().divided; }
    const Messages& messages() const { return messages_; }

    /// The cells along the boundary have done their step.
    template <Streaming streaming>
    void start(int threads) {
        for_each_index(static_cast<std::int64_t>(outgoing_.size()), threads, [&](std::int64_t k) {
            const Piece& piece = outgoing_[static_cast<std::size_t>(k)];
            Real* const message = reinterpret_cast<Real*>(messages_.outgoing(piece.neighbour) + piece.offset);
            if constexpr (streaming == Streaming::arrived)
                halo_.pack_to_publish(neighbourhood_.parts()[piece.part], message);
            else
                halo_.pack_to_collect(neighbourhood_.parts()[piece.part], message);
        });
        messages_.start();
    }

    void progress() { messages_.progress(); }

    template <Streaming streaming>
    void finish(int threads) {
        messages_.finish();
        for_each_index(static_cast<std::int64_t>(incoming_.size()), threads, [&](std::int64_t k) {
            const Piece& piece = incoming_[static_cast<std::size_t>(k)];
            const Real* const message =
                reinterpret_cast<const Real*>(messages_.incoming(piece.neighbour) + piece.offset);
            if constexpr (streaming == Streaming::arrived)
                halo_.unpack_published(neighbourhood_.parts()[piece.part], message);
            else
                halo_.unpack_collected(neighbourhood_.parts()[piece.part], message);
        });
    }

private:
    /// Where a part lies in the messages.
    struct Piece {
        std::size_t part = 0;
        std::size_t neighbour = 0;
        std::size_t offset = 0; ///< bytes
    };

    /// One behind the other; returns the length of the message.
    std::size_t place(const std::vector<std::size_t>& parts, std::size_t neighbour,
                      std::vector<Piece>& pieces) const {
        std::size_t offset = 0;
        for (const std::size_t part : parts) {
            pieces.push_back({part, neighbour, offset});
            offset += static_cast<std::size_t>(halo_.numbers(neighbourhood_.parts()[part])) * sizeof(Real);
        }
        return offset;
    }

    const Neighbourhood& neighbourhood_;
    PopulationHalo<Real> halo_;
    Messages messages_;
    std::vector<Piece> outgoing_;
    std::vector<Piece> incoming_;
};

} // namespace vesica
