#pragma once

#include "lattice/block.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace vesica {

/// How a box is cut into blocks: along each axis into slabs, the same for the whole box, so that blocks meet
/// face to face.
class BlockLayout {
public:
    /// Narrower blocks would not hold all that a neighbour's band must know of.
    static constexpr int narrowest = 10;

    BlockLayout() = default;
    /// Slabs of equal width, as far as the cells allow. Each must be `narrowest` at least, where an axis is
    /// cut at all.
    BlockLayout(const Vec3<int>& box, const Vec3<int>& blocks, const std::optional<Slide>& slide = {});

    const Vec3<int>& box() const { return box_; }
    /// Along each axis.
    Vec3<int> blocks() const;
    int count() const;
    /// Where slab k of an axis begins; slab `blocks` begins behind the last cell.
    int cut(int axis, int k) const { return cuts_[axis][static_cast<std::size_t>(k)]; }

    Block block(const Vec3<int>& place) const;

    /// Moves the cuts of an axis so that the heaviest slab is as light as whole planes of cells allow.
    /// `weight` has one number per plane.
    void balance(int axis, const std::vector<double>& weight);

private:
    Vec3<int> box_{};
    std::optional<Slide> slide_;
    std::vector<int> cuts_[3];
};

/// Whether so many blocks fit along each axis of the box; a sliding box has one along its velocity.
bool fits(const Vec3<int>& box, const Vec3<int>& blocks, const std::optional<Slide>& slide = {});

/// The blocks along each axis, `count` in all, whose faces are the cheapest to exchange; nothing if no way of
/// cutting leaves blocks wide enough. Faces across x count twice: their cells lie apart in memory.
std::optional<Vec3<int>> choose_blocks(const Vec3<int>& box, int count,
                                       const std::optional<Slide>& slide = {});

/// The largest number up to `count` that choose_blocks can serve.
int most_blocks(const Vec3<int>& box, int count, const std::optional<Slide>& slide = {});

} // namespace vesica
