#pragma once

#include "core/vec3.hpp"
#include "shape/distance_table.hpp"
#include "shape/placed_shape.hpp"
#include "shape/random_numbers.hpp"
#include "shape/solid_distance.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace vesica {

/// One body of a packing: a rigid shape somewhere, its z along an axis.
struct PackedBody {
    std::size_t kind = 0; ///< index into PackingTask::kinds
    Vec3<double> centre{};
    Vec3<double> axis{0.0, 0.0, 1.0};
};

/// What is to be packed and where, in cells.
struct PackingTask {
    Vec3<double> size{}; ///< of the box
    std::array<bool, 3> periodic{true, true, true};
    /// What of the box the bodies may lie in; along axes where this is not all of a periodic box they keep
    /// `end_gaps` from both ends.
    Vec3<double> begin{};
    Vec3<double> end{};
    Vec3<double> end_gaps{};
    std::shared_ptr<const SolidDistance> solids;     ///< null without
    std::vector<std::shared_ptr<const Shape>> kinds; ///< in their own frames
    std::vector<PackedBody> fixed;                   ///< already there
    std::size_t kind = 0;                            ///< of those to be placed
    std::size_t count = 0;
    double gap = 0.0;    ///< between any two surfaces
    bool turning = true; ///< whether bodies may be turned to make room
    /// The axis of a body before it makes room.
    std::function<Vec3<double>(RandomNumbers&)> first_axis;
    std::uint64_t seed = 1;
};

struct PackingResult {
    std::vector<PackedBody> bodies; ///< those placed
    double scale = 0.0;             ///< of their lengths that fits; 1: all fit as they are
};

/// Places bodies at random where nothing overlaps: they start small, at random places, grow, and push each
/// other aside as rigid bodies do (after Lubachevsky and Stillinger 1990, without their speeds). The same
/// task gives the same bits.
PackingResult pack(const PackingTask& task);

} // namespace vesica
