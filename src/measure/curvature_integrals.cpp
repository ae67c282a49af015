#include "measure/curvature_integrals.hpp"

#include "measure/layer_sum.hpp"

#include <numbers>

namespace vesica {

double mean_curvature_integral(const VesicleSnapshot& vesicle, std::optional<double> known_area) {
    return mid_surface_integral(
        vesicle, [](const InterfaceCell& cell) { return cell.H0; }, known_area);
}

double bending_energy(const VesicleSnapshot& vesicle, std::optional<double> known_area) {
    const double energy = mid_surface_integral(
        vesicle,
        [&](const InterfaceCell& cell) {
            const double excess = 2.0 * cell.H0 - vesicle.spontaneous_curvature;
            return 0.5 * excess * excess;
        },
        known_area);
    return energy / (8.0 * std::numbers::pi);
}

} // namespace vesica
