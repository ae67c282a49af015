#pragma once

#include "core/exact_sum.hpp"
#include "measure/snapshot.hpp"

namespace vesica {

/// sum of weight * q over all cells of the layer, in exact arithmetic: int q dA plus the layer's second
/// moment. `quantity(cell)` is a double.
template <class Quantity>
double layer_sum(const VesicleSnapshot& vesicle, Quantity quantity) {
    ExactSum sum;
    for (const InterfaceCell& cell : vesicle.cells)
        sum.add(cell.weight * quantity(cell));
    return sum.value();
}

/// sum of weight * q over the cells whose geometry is known.
template <class Quantity>
double geometry_sum(const VesicleSnapshot& vesicle, Quantity quantity) {
    ExactSum sum;
    for (const InterfaceCell& cell : vesicle.cells)
        if (cell.has_geometry)
            sum.add(cell.weight * quantity(cell));
    return sum.value();
}

/// The vesicle's layer moments, or those of a tanh with its layer_moment when it states no more.
LayerMoments layer_moments(const VesicleSnapshot& vesicle);

/// The share of the membrane's area that cells with geometry represent, sum(weight * J) / A: one but for the
/// layer's tails, where the geometry is not computed. Curvature integrals are divided by it. NaN when no cell
/// has geometry.
double geometry_coverage(const VesicleSnapshot& vesicle);

/// int q dA over phi = 0 of a quantity already mapped to it (H0, K0, foot_point, ...), cells^2 times q's
/// unit. Each cell counts with weight * J: J carries its area to the mid-surface. NaN when no cell has
/// geometry.
template <class Quantity>
double mid_surface_integral(const VesicleSnapshot& vesicle, Quantity quantity) {
    return geometry_sum(vesicle, [&](const InterfaceCell& cell) { return cell.J * quantity(cell); }) /
           geometry_coverage(vesicle);
}

/// The point of phi = 0 nearest to a cell with geometry.
inline Vec3<double> foot_point(const InterfaceCell& cell) {
    return cell.position - cell.s * cell.n;
}

} // namespace vesica
