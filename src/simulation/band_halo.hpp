#pragma once

#include "lattice/band.hpp"
#include "parallel/for_each.hpp"
#include "parallel/neighbourhood.hpp"

#include <initializer_list>
#include <span>
#include <vector>

namespace vesica {

/// What neighbouring blocks tell each other of a band: the values of compact arrays in the cells of which the
/// other has ghosts, and nothing else.
template <class Real>
class BandHalo {
public:
    using Arrays = std::initializer_list<std::span<Real>>;

    explicit BandHalo(const Neighbourhood& neighbourhood)
        : neighbourhood_(neighbourhood),
          messages_(neighbourhood),
          cells_(neighbourhood.linked_neighbours().size()) {}

    const Messages& messages() const { return messages_; }

    /// The band has been laid out anew.
    void follow(const Band& band) {
        for (std::size_t k = 0; k < cells_.size(); ++k) {
            const Neighbourhood::Neighbour& neighbour = neighbourhood_.linked_neighbours()[k];
            cells_[k].rim.clear();
            cells_[k].ghosts.clear();
            for (const std::size_t part : neighbour.outgoing)
                append(band.part_cells()[part].rim, cells_[k].rim);
            for (const std::size_t part : neighbour.incoming)
                append(band.part_cells()[part].ghosts, cells_[k].ghosts);
        }
    }

    /// Core cells of the neighbours that lie near enough to this block to matter; what each is sent is cut in
    /// the same way.
    std::vector<ForeignSeed> exchange_seeds(const std::vector<BandSeed>& own, const Grid& grid) const;

    void start(Arrays arrays, int threads) {
        outgoing_.clear();
        incoming_.clear();
        for (const Band::PartCells& cells : cells_) {
            outgoing_.push_back(cells.rim.size() * arrays.size() * sizeof(Real));
            incoming_.push_back(cells.ghosts.size() * arrays.size() * sizeof(Real));
        }
        messages_.resize(outgoing_, incoming_);
        for_each_value(&Band::PartCells::rim, arrays, threads, [&](std::size_t k) {
            return [message = reinterpret_cast<Real*>(messages_.outgoing(k))](std::size_t at, Real& value) {
                message[at] = value;
            };
        });
        messages_.start();
    }

    void finish(Arrays arrays, int threads) {
        messages_.finish();
        for_each_value(&Band::PartCells::ghosts, arrays, threads, [&](std::size_t k) {
            return [message = reinterpret_cast<const Real*>(messages_.incoming(k))](std::size_t at,
                                                                                    Real& value) {
                value = message[at];
            };
        });
    }

private:
    static void append(const std::vector<std::int32_t>& more, std::vector<std::int32_t>& list) {
        list.insert(list.end(), more.begin(), more.end());
    }

    /// copy_of(neighbour)(place in its message, value), array by array; each thread has a share of every
    /// message.
    template <class CopyOf>
    void for_each_value(std::vector<std::int32_t> Band::PartCells::*list, Arrays arrays, int threads,
                        const CopyOf& copy_of) const {
        const auto shares = static_cast<std::size_t>(threads);
        for_each_block(threads, threads, [&](int thread, std::int64_t, std::int64_t) {
            const auto self = static_cast<std::size_t>(thread);
            for (std::size_t neighbour = 0; neighbour < cells_.size(); ++neighbour) {
                const std::vector<std::int32_t>& cells = cells_[neighbour].*list;
                const auto copy = copy_of(neighbour);
                std::size_t array_begin = 0;
                for (const std::span<Real>& array : arrays) {
                    for (std::size_t k = cells.size() * self / shares; k < cells.size() * (self + 1) / shares;
                         ++k)
                        copy(array_begin + k, array[static_cast<std::size_t>(cells[k])]);
                    array_begin += cells.size();
                }
            }
        });
    }

    const Neighbourhood& neighbourhood_;
    Messages messages_;
    std::vector<Band::PartCells> cells_; ///< per linked neighbour
    std::vector<std::size_t> outgoing_;  ///< bytes of the messages under way
    std::vector<std::size_t> incoming_;
};

template <class Real>
std::vector<ForeignSeed> BandHalo<Real>::exchange_seeds(const std::vector<BandSeed>& own,
                                                        const Grid& grid) const {
    const Block& block = neighbourhood_.block();
    std::vector<std::vector<std::byte>> outgoing;
    for (const Neighbourhood::Neighbour& neighbour : neighbourhood_.neighbours()) {
        std::vector<ForeignSeed> near;
        for (const BandSeed& seed : own) {
            const Vec3<int> first = grid.tile_origin(seed.tile) + block.own.begin;
            if (matters_to(neighbour.block, first))
                near.push_back({first, seed.bits, seed.label});
        }
        const auto bytes = std::as_bytes(std::span(near));
        outgoing.emplace_back(bytes.begin(), bytes.end());
    }
    std::vector<ForeignSeed> foreign;
    for (const std::vector<std::byte>& bytes : neighbourhood_.exchange(outgoing)) {
        std::vector<ForeignSeed> seeds(bytes.size() / sizeof(ForeignSeed));
        std::copy(bytes.begin(), bytes.end(), std::as_writable_bytes(std::span(seeds)).begin());
        foreign.insert(foreign.end(), seeds.begin(), seeds.end());
    }
    return foreign;
}

} // namespace vesica
