#pragma once

#include "core/cell_box.hpp"
#include "lattice/velocity_set.hpp"

#include <optional>
#include <vector>

namespace vesica {

/// A box whose images above it along one axis slide past it along another (Lees-Edwards).
struct Slide {
    int gradient = 2; ///< axis
    int velocity = 0; ///< axis; no block is cut across it

    friend bool operator==(const Slide&, const Slide&) = default;
};

/// The part of the periodic box that one process works on. Along a divided axis its neighbours belong to
/// other processes; along the others the block is as long as the box, and its own neighbour.
/// Across sliding faces the block meets images in messages only, even its own: the gradient's axis counts as
/// divided.
struct Block {
    Vec3<int> box{}; ///< size of the whole
    CellBox own{};   ///< this part of it
    Vec3<bool> divided{};
    std::optional<Slide> slide{};

    static Block whole(const Vec3<int>& box) { return {box, {{}, box}, {}, {}}; }

    /// Nothing lies beyond it but its own other end: no axis is divided.
    bool is_whole() const { return !divided.x && !divided.y && !divided.z; }

    /// Whether what lies beyond the end of an axis, the lower one or the upper one, slides.
    bool slides_at(int axis, bool upper) const {
        return slide && axis == slide->gradient &&
               (upper ? own.begin[axis] + own.size[axis] == box[axis] : own.begin[axis] == 0);
    }
    bool slides_at(const Vec3<int>& link) const {
        return slide && link[slide->gradient] != 0 && slides_at(slide->gradient, link[slide->gradient] > 0);
    }

    /// Where a cell next to the block, in its own coordinates, lies in it: along undivided axes the block is
    /// its own neighbour.
    Vec3<int> home(Vec3<int> cell) const {
        for (int a = 0; a < 3; ++a)
            if (!divided[a])
                cell[a] += cell[a] < 0 ? own.size[a] : cell[a] >= own.size[a] ? -own.size[a] : 0;
        return cell;
    }
};

/// A piece of a block's surface, in the block's own coordinates: the ghost cells that stand for cells of the
/// neighbour at `link`, and the cells that stand in that neighbour for its ghosts.
struct HaloPart {
    Vec3<int> link{};
    CellBox ghosts{};
    CellBox rim{};
};

/// The pieces along which cells of different processes are linked: towards every combination of divided axes
/// that is a link of the lattice. Along undivided axes they reach over the block's own ghosts. In the order
/// of their links, z slowest; a neighbour's piece at the opposite link fits exactly.
inline std::vector<HaloPart> halo_parts(const Block& block) {
    std::vector<HaloPart> parts;
    const auto may_differ = [&](const Vec3<int>& link) {
        for (int a = 0; a < 3; ++a)
            if (link[a] != 0 && !block.divided[a])
                return false;
        const int axes = link.x * link.x + link.y * link.y + link.z * link.z;
        return axes == 1 || axes == 2;
    };
    for (int dz = -1; dz <= 1; ++dz)
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) {
                HaloPart part;
                part.link = {dx, dy, dz};
                if (!may_differ(part.link))
                    continue;
                for (int a = 0; a < 3; ++a) {
                    const int length = block.own.size[a];
                    const int reach = block.divided[a] ? 0 : 1;
                    const int towards = part.link[a];
                    part.ghosts.begin[a] = towards == 0 ? -reach : towards < 0 ? -1 : length;
                    part.rim.begin[a] = towards == 0 ? -reach : towards < 0 ? 0 : length - 1;
                    part.ghosts.size[a] = part.rim.size[a] = towards == 0 ? length + 2 * reach : 1;
                }
                parts.push_back(part);
            }
    return parts;
}

} // namespace vesica
