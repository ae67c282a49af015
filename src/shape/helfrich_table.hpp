#pragma once

#include "case/parameters.hpp"

#include <span>

namespace vesica {

/// One tabulated minimiser of the bending energy at C0 = 0: psi(s) = pi s/L + sum_k a_k sin(n_k pi s/L) with
/// n_k = stride (k + 1), lengths in units of R_A = (A/4 pi)^(1/2).
struct HelfrichEntry {
    double reduced_volume = 0.0;
    double length = 0.0; ///< L, of the meridian from pole to pole
    std::span<const double> coefficients;
};

struct HelfrichBranchTable {
    int stride = 1; ///< 2 for shapes with a mirror plane across the axis: even harmonics only
    std::span<const HelfrichEntry> entries; ///< by falling reduced volume
};

HelfrichBranchTable helfrich_table(HelfrichBranch branch);

} // namespace vesica
