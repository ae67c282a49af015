#pragma once

#include "measure/snapshot.hpp"

#include <optional>

namespace vesica {

/// The layer's own area, sum (beta/2)(1 - phi^2), cells^2: too large by some 4 pi (1 - genus) <s^2>.
double raw_area(const VesicleSnapshot& vesicle);

/// int K dA, from the curvature of each cell's own parallel surface, which needs no correction for the layer:
/// 4 pi (1 - genus). Its deviation from that tells how well the shape is resolved. NaN when no cell has
/// geometry.
double gaussian_curvature_integral(const VesicleSnapshot& vesicle, std::optional<double> known_area = {});

/// The area of phi = 0: the raw area without the excess that LayerMoments states, with int K dA rounded to a
/// multiple of 4 pi (Gauss-Bonnet). When no cell has geometry, the raw area.
double area(const VesicleSnapshot& vesicle);

} // namespace vesica
