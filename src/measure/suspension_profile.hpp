#pragma once

#include "case/dense_field.hpp"
#include "case/parameters.hpp"
#include "case/solid_voxels.hpp"

#include <cstdint>
#include <vector>

namespace vesica {

/// Cells of fluid at about the same place across a flow, one cell thick.
struct ProfileBin {
    double position = 0.0; ///< of the bin's middle along the axis, or from the box's middle line
    std::int64_t cells = 0;
    double haematocrit = 0.0;
    double velocity = 0.0;       ///< mean, along the flow, cells per step
    double inner_velocity = 0.0; ///< of what is inside vesicles; NaN where nothing is
};

/// What a suspension looks like at one time.
struct SuspensionProfile {
    std::vector<ProfileBin> bins; ///< those with fluid
    double haematocrit = 0.0;     ///< of all fluid
    double velocity = 0.0;        ///< mean, along the flow
    /// What part of the volume that flows is inside vesicles; NaN where nothing flows.
    double discharge_haematocrit = 0.0;
    /// Mean distance from walls, or obstacles around a tube, to the first membrane on the way across from
    /// there; NaN without either.
    double cell_free_layer = 0.0;
};

/// From the fields "phase" and "velocity" of the whole box. `solids` may be null.
SuspensionProfile suspension_profile(const DenseField& phase, const DenseField& velocity,
                                     const SolidVoxels* solids, const ProfileOutput& output,
                                     bool walls_across);

} // namespace vesica
