#pragma once

#include "core/exact_sum.hpp"
#include "core/vec3.hpp"
#include "parallel/ranks.hpp"
#include "simulation/flow_drive.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace vesica {

/// What a wall gives the fluid in a step, per axis; exact sums.
using WallForce = std::array<ExactSum, 3>;

/// Of all ranks together: per axis the lower and the upper wall.
inline std::array<std::array<Vec3<double>, 2>, 3> sums_over(const Ranks& ranks,
                                                            const std::vector<WallForce>& own) {
    using Words = std::array<std::array<std::uint64_t, 3>, 3 * FlowDrive::wall_count>;
    Words words{};
    for (std::size_t k = 0; k < words.size(); ++k)
        words[k] = own[k / 3][k % 3].words();
    std::array<ExactSum, 3 * FlowDrive::wall_count> sums;
    for (const Words& rank : ranks.gather_all(words))
        for (std::size_t k = 0; k < sums.size(); ++k)
            sums[k] += ExactSum::from_words(rank[k]);
    std::array<std::array<Vec3<double>, 2>, 3> forces{};
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t side = 0; side < 2; ++side)
            for (std::size_t a = 0; a < 3; ++a)
                forces[axis][side][static_cast<int>(a)] = sums[3 * (1 + 2 * axis + side) + a].value();
    return forces;
}

} // namespace vesica
