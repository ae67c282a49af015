#pragma once

#include "core/exact_sum.hpp"
#include "measure/area.hpp"
#include "measure/snapshot.hpp"

#include <optional>

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

/// How much a cell's geometry is trusted, 0 to 1: less and less below 1 - phi^2 = 2e-2, not at all below
/// 5e-3, so that no cell enters a sum with a jump; and not at all where the map to phi = 0 has lost its
/// meaning, at J < 0.1 or J > 10, beyond the surface's own centres of curvature or between the faces of a
/// thin disc. 0 without geometry.
double geometry_trust(const VesicleSnapshot& vesicle, const InterfaceCell& cell);

/// sum of weight * q over the cells whose geometry is known, each as far as it is trusted.
template <class Quantity>
double geometry_sum(const VesicleSnapshot& vesicle, Quantity quantity) {
    ExactSum sum;
    for (const InterfaceCell& cell : vesicle.cells) {
        const double trust = geometry_trust(vesicle, cell);
        if (trust > 0.0)
            sum.add(trust * cell.weight * quantity(cell));
    }
    return sum.value();
}

/// The vesicle's layer moments, or those of a tanh with its layer_moment when it states no more.
LayerMoments layer_moments(const VesicleSnapshot& vesicle);

/// The share of the membrane's area that cells with geometry represent, sum(weight * J) / A: one but for the
/// layer's tails, where the geometry is not computed or not trusted.
/// NaN when no cell has geometry.
double geometry_coverage(const VesicleSnapshot& vesicle, std::optional<double> known_area = {});

/// int q dA over phi = 0 of a quantity already mapped to it (H0, K0, foot_point, ...), cells^2 times q's
/// unit: the vesicle's area times the mean of q. Cells count with (1 - phi^2)^2 J: J carries their area to
/// the mid-surface, and the square keeps to the middle of the layer, where the map is short and the other
/// face of a thin disc is far. With the layer's own weight, 1 - phi^2, the energy of an exact discocyte is
/// three times as far off at R0 = 10. NaN when no cell has geometry. `known_area`, here and elsewhere, is
/// area(vesicle), which takes three passes over the layer, where it is at hand.
template <class Quantity>
double mid_surface_integral(const VesicleSnapshot& vesicle, Quantity quantity,
                            std::optional<double> known_area = {}) {
    ExactSum sum;
    ExactSum weights;
    for (const InterfaceCell& cell : vesicle.cells) {
        const double weight = geometry_trust(vesicle, cell) * cell.weight * cell.weight * cell.J;
        if (weight > 0.0) {
            sum.add(weight * quantity(cell));
            weights.add(weight);
        }
    }
    const double whole = known_area ? *known_area : area(vesicle);
    return whole * (sum.value() / weights.value()); // 0/0 is the NaN promised
}

/// The point of phi = 0 nearest to a cell with geometry.
inline Vec3<double> foot_point(const InterfaceCell& cell) {
    return cell.position - cell.s * cell.n;
}

} // namespace vesica
