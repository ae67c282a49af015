#pragma once

#include "measure/snapshot.hpp"

#include <optional>

namespace vesica {

/// int H dA over phi = 0, cells; 4 pi R for a sphere. NaN when no cell has geometry.
double mean_curvature_integral(const VesicleSnapshot& vesicle, std::optional<double> known_area = {});

/// (kappa/2) int (2H - C0)^2 dA over 8 pi kappa (Helfrich 1973): 1 for a sphere with C0 = 0. kappa drops out,
/// so that a drop has one too. NaN when no cell has geometry.
double bending_energy(const VesicleSnapshot& vesicle, std::optional<double> known_area = {});

} // namespace vesica
