#pragma once

#include "case/parameters.hpp"
#include "shape/meridian.hpp"

namespace vesica {

struct ReducedVolumeRange {
    double lowest = 0.0;
    double highest = 0.0;
};

/// Where the branch is tabulated: oblates down to where their poles would touch, stomatocytes up to the fold
/// of their branch.
ReducedVolumeRange helfrich_range(HelfrichBranch branch);

/// Meridian of the axisymmetric minimiser of (kappa/2) int (2H)^2 dA at given area and reduced volume
/// (Helfrich 1973; Seifert, Berndl, Lipowsky 1991), in units of R_A = (A/4 pi)^(1/2), centre of volume at
/// the origin. A stomatocyte's mouth opens towards +z. The reduced volume is exact to 1e-10; between the
/// table's entries the energy is within 1e-4 of the minimum. Throws InputError outside `helfrich_range`.
Meridian helfrich_meridian(const HelfrichShape& shape);

} // namespace vesica
