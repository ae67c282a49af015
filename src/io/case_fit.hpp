#pragma once

#include "case/parameters.hpp"

namespace vesica {

/// Half the vesicle's width along each lattice axis in cells, or a lower bound of it where the exact shape is
/// known to the shapes only (Helfrich minimisers: from their tabulated sizes); 0 for a mesh. Without
/// perturbations.
Vec3<double> least_half_widths(const VesicleParameters& vesicle);

} // namespace vesica
