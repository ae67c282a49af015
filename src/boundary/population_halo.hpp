#pragma once

#include "lattice/block.hpp"
#include "lattice/grid.hpp"
#include "lattice/populations.hpp"

#include <algorithm>
#include <cstring>

namespace vesica {

/// The populations that cross between blocks of different processes, between memory and messages: of each
/// part only the slots that move along its link, and of those only where they do cross. As with
/// PeriodicBoundary, after a step on `arrived` populations ghosts need what left the neighbour (publish: its
/// rim goes into our ghosts); after one on `turned` populations what was written into ghosts is the
/// neighbour's (collect: ghosts go into its rim).
template <class Real>
class PopulationHalo {
public:
    PopulationHalo() = default;
    PopulationHalo(const PopulationView<Real>& populations, const Grid& grid, const Block& block)
        : f_(populations), grid_(grid), block_(block) {}

    /// Numbers in the message of a part, either way.
    std::int64_t numbers(const HaloPart& part) const {
        std::int64_t sum = 0;
        for_each_slot(part.link, [&](int i) { sum += crossing(part.ghosts, part.link, i).volume(); });
        return sum;
    }

    void pack_to_publish(const HaloPart& part, Real* message) const {
        for_each_row(part.rim, -part.link, [&](const CellBox& box, int i, int y, int z) {
            // The block's own ghosts may not be there yet: read what they stand for.
            const Vec3<int> first = block_.home({0, y, z});
            const Real* const row = f_.slot(i) + grid_.index(first);
            for (int x = box.begin.x; x < 0; ++x)
                *message++ = row[block_.home({x, y, z}).x];
            const int begin = std::max(box.begin.x, 0);
            const int end = std::min(box.begin.x + box.size.x, grid_.size().x);
            message = copied(row + begin, end - begin, message);
            for (int x = end; x < box.begin.x + box.size.x; ++x)
                *message++ = row[block_.home({x, y, z}).x];
        });
    }
    void unpack_published(const HaloPart& part, const Real* message) const {
        unpack(part.ghosts, part.link, message);
    }
    void pack_to_collect(const HaloPart& part, Real* message) const {
        for_each_row(part.ghosts, part.link, [&](const CellBox& box, int i, int y, int z) {
            message = copied(f_.slot(i) + grid_.index(box.begin.x, y, z), box.size.x, message);
        });
    }
    void unpack_collected(const HaloPart& part, const Real* message) const {
        unpack(part.rim, -part.link, message);
    }

private:
    static Real* copied(const Real* from, int count, Real* to) {
        std::memcpy(to, from, static_cast<std::size_t>(count) * sizeof(Real));
        return to + count;
    }

    void unpack(const CellBox& part, const Vec3<int>& along, const Real* message) const {
        for_each_row(part, along, [&](const CellBox& box, int i, int y, int z) {
            copied(message, box.size.x, f_.slot(i) + grid_.index(box.begin.x, y, z));
            message += box.size.x;
        });
    }

    template <class Body>
    static void for_each_slot(const Vec3<int>& along, const Body& body) {
        for (int i = 0; i < direction_count; ++i) {
            bool moves = true;
            for (int a = 0; a < 3; ++a)
                moves = moves && (along[a] == 0 || velocity(i, a) == along[a]);
            if (moves)
                body(i);
        }
    }

    /// Where along the other axes a slot crosses: beside the block's own cells by its own velocity. What
    /// would come from beyond a divided axis crosses an edge, which is a part of its own.
    CellBox crossing(CellBox box, const Vec3<int>& along, int i) const {
        for (int a = 0; a < 3; ++a) {
            if (along[a] != 0)
                continue;
            const int sideways = velocity(i, a);
            const int length = grid_.size()[a];
            box.begin[a] = block_.divided[a] ? std::max(sideways, 0) : sideways;
            box.size[a] = block_.divided[a] ? length - std::abs(sideways) : length;
        }
        return box;
    }

    /// body(where the slot crosses, slot, y, z), row by row.
    template <class Body>
    void for_each_row(const CellBox& part, const Vec3<int>& along, const Body& body) const {
        for_each_slot(along, [&](int i) {
            const CellBox box = crossing(part, along, i);
            for (int z = box.begin.z; z < box.begin.z + box.size.z; ++z)
                for (int y = box.begin.y; y < box.begin.y + box.size.y; ++y)
                    body(box, i, y, z);
        });
    }

    PopulationView<Real> f_;
    Grid grid_;
    Block block_;
};

} // namespace vesica
