#pragma once

#include "lattice/band.hpp"
#include "simulation/layer_reach.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vesica {

/// One of a cell's colours.
template <class Real>
struct CellColour {
    std::int32_t label = -1;
    Real chi = Real(0);
    bool in_core = false; ///< as the band was laid out
};

/// Instead of the compact address of a tile's colours.
inline constexpr std::int32_t outside_bands = -1;
constexpr bool is_shared(std::int32_t slot) {
    return slot < outside_bands;
}

/// The tiles with several colours: those that the bands of several vesicles have, and those that the band of
/// one has inside another.
class SharedTiles {
public:
    struct Colour {
        static constexpr std::int32_t pure = -1;
        static constexpr std::int32_t no_force = -1;

        std::int32_t label = 0;
        std::int32_t slot = pure;      ///< compact address; pure: what the other colours leave
        std::int32_t tile = -1;        ///< index in the band
        std::int32_t force = no_force; ///< where its forces begin
    };
    struct Range {
        std::int32_t begin = 0; ///< of its colours, in ascending order of labels
        std::int32_t end = 0;
    };
    /// A tile on which several membranes push: their sum has an address of its own.
    struct Force {
        std::int64_t tile = 0;
        std::int32_t slot = 0;
        std::int32_t begin = 0; ///< of the addresses that add up
        std::int32_t end = 0;
    };

    void clear() {
        ranges_.clear();
        colours_.clear();
        forces_.clear();
        force_slots_.clear();
    }
    /// A tile of the grid, with all its colours. Where several push, their sum begins at `free`. Returns how
    /// many addresses it takes.
    std::int32_t add(std::int64_t tile, const std::vector<Colour>& colours, std::int32_t free) {
        const auto begin = static_cast<std::int32_t>(colours_.size());
        colours_.insert(colours_.end(), colours.begin(), colours.end());
        ranges_.push_back({begin, static_cast<std::int32_t>(colours_.size())});
        const auto first = static_cast<std::int32_t>(force_slots_.size());
        for (const Colour& colour : colours)
            if (colour.force != Colour::no_force)
                force_slots_.push_back(colour.force);
        const auto last = static_cast<std::int32_t>(force_slots_.size());
        if (last - first > 1) {
            forces_.push_back({tile, free, first, last});
            return Grid::tile;
        }
        force_slots_.resize(static_cast<std::size_t>(first));
        return 0;
    }

    bool empty() const { return ranges_.empty(); }
    std::int64_t count() const { return static_cast<std::int64_t>(ranges_.size()); }
    /// In place of the last one's address, for a tile's colours.
    std::int32_t last_slot() const { return -1 - static_cast<std::int32_t>(ranges_.size()); }

    /// body(colour) for those of a tile, by its shared slot.
    template <class Body>
    void for_each_colour(std::int32_t shared_slot, const Body& body) const {
        const Range& range = ranges_[static_cast<std::size_t>(-2 - shared_slot)];
        for (std::int32_t k = range.begin; k < range.end; ++k)
            body(colours_[static_cast<std::size_t>(k)]);
    }
    const Range& range(std::int64_t index) const { return ranges_[static_cast<std::size_t>(index)]; }
    const Colour& colour(std::int32_t index) const { return colours_[static_cast<std::size_t>(index)]; }

    const std::vector<Force>& forces() const { return forces_; }
    std::int32_t force_slot(std::int32_t index) const {
        return force_slots_[static_cast<std::size_t>(index)];
    }

    std::size_t bytes() const {
        return ranges_.capacity() * sizeof(Range) + colours_.capacity() * sizeof(Colour) +
               forces_.capacity() * sizeof(Force) + force_slots_.capacity() * sizeof(std::int32_t);
    }

private:
    std::vector<Range> ranges_;
    std::vector<Colour> colours_;
    std::vector<Force> forces_;
    std::vector<std::int32_t> force_slots_;
};

} // namespace vesica
