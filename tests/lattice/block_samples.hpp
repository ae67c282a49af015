#pragma once

#include "lattice/block.hpp"

#include <vector>

namespace vesica::test {

/// A periodic box cut into blocks at these places of each axis; the ends are understood.
struct CutBox {
    Vec3<int> box{};
    std::vector<int> cuts[3];

    Vec3<int> blocks() const {
        return {static_cast<int>(cuts[0].size()) + 1, static_cast<int>(cuts[1].size()) + 1,
                static_cast<int>(cuts[2].size()) + 1};
    }
    int count() const { return blocks().x * blocks().y * blocks().z; }
    Vec3<int> place(int index) const {
        return {index % blocks().x, index / blocks().x % blocks().y, index / blocks().x / blocks().y};
    }
    int index(Vec3<int> place) const {
        for (int a = 0; a < 3; ++a)
            place[a] = (place[a] + blocks()[a]) % blocks()[a];
        return place.x + blocks().x * (place.y + blocks().y * place.z);
    }
    Block block(int index) const {
        Block block;
        block.box = box;
        for (int a = 0; a < 3; ++a) {
            const int k = place(index)[a];
            const auto at = [&](int cut) {
                return cut == 0             ? 0
                       : cut == blocks()[a] ? box[a]
                                            : cuts[a][static_cast<std::size_t>(cut - 1)];
            };
            block.own.begin[a] = at(k);
            block.own.size[a] = at(k + 1) - at(k);
            block.divided[a] = blocks()[a] > 1;
        }
        return block;
    }
    int neighbour(int index, const Vec3<int>& link) const { return this->index(place(index) + link); }
};

/// Blocks of ten cells and more, cut along one axis, two and all three, evenly and not, within tiles.
inline const std::vector<CutBox>& cut_boxes() {
    static const std::vector<CutBox> boxes = {
        {{24, 21, 33}, {{12}, {10}, {10, 20}}}, {{41, 12, 11}, {{10, 27}, {}, {}}},
        {{13, 9, 34}, {{}, {}, {11, 24}}},      {{9, 40, 3}, {{}, {10, 20, 30}, {}}},
        {{30, 5, 22}, {{10}, {}, {11}}},        {{17, 20, 20}, {{}, {10}, {10}}},
        {{48, 30, 10}, {{11, 31}, {19}, {}}},
    };
    return boxes;
}

/// The part at the opposite link among a neighbour's.
inline std::size_t opposite_part(const std::vector<HaloPart>& parts, const Vec3<int>& link) {
    for (std::size_t k = 0; k < parts.size(); ++k)
        if (parts[k].link == -link)
            return k;
    return parts.size();
}

} // namespace vesica::test
