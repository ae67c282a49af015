#pragma once

#include "case/solid_voxels.hpp"
#include "core/vec3.hpp"
#include "measure/snapshot.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace vesica {

/// Where centres lie.
struct PairBox {
    Vec3<int> size{};                       ///< cells
    Vec3<bool> periodic{true, true, true};  ///< per axis
    std::optional<SlidingImages> sliding{}; ///< a periodic axis whose images slide
    const SolidVoxels* solids = nullptr;    ///< null: none
};

/// Pairs of centres about as far apart as each other.
struct PairBin {
    double distance = 0.0; ///< of the bin's middle, cells
    std::int64_t pairs = 0;
    /// g: pairs over those of as many points that lie anywhere in the fluid with equal probability; solids
    /// and walls take from the shell round a centre what they take. NaN where no fluid is so far away.
    double distribution = 0.0;
    /// Mean over the pairs of 2 e_along e_across, e the direction from one to the other: -1 for pairs along
    /// the compression of a shear flow, 1 along its extension. NaN without pairs or an axis across.
    double shear_moment = 0.0;
};

/// Bins of `width` up to half of the shortest periodic length; without one, of the longest. Each pair counts
/// once, between its nearest images. `across` may be -1: none.
std::vector<PairBin> pair_statistics(const std::vector<Vec3<double>>& centres, const PairBox& box,
                                     double width, int along, int across);

/// Mean distance from each centre to the one nearest to it; NaN for fewer than two.
double nearest_neighbour(const std::vector<Vec3<double>>& centres, const PairBox& box);

} // namespace vesica
