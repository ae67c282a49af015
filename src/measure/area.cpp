#include "measure/area.hpp"

#include "measure/layer_sum.hpp"

#include <cmath>
#include <numbers>

namespace vesica {
namespace {

/// Over the cells that have it, so without the layer's far tails.
double partial_gaussian_curvature(const VesicleSnapshot& vesicle) {
    return geometry_sum(vesicle, [](const InterfaceCell& cell) { return cell.K; });
}

} // namespace

double raw_area(const VesicleSnapshot& vesicle) {
    return layer_sum(vesicle, [](const InterfaceCell&) { return 1.0; });
}

double area(const VesicleSnapshot& vesicle) {
    const double sphere = 4.0 * std::numbers::pi;
    const double one_minus_genus = std::round(partial_gaussian_curvature(vesicle) / sphere);
    const double square = geometry_sum(vesicle, [](const InterfaceCell& cell) { return cell.H * cell.H; });
    const LayerMoments layer = layer_moments(vesicle);
    return raw_area(vesicle) - sphere * one_minus_genus * layer.area - layer.bending * square;
}

double gaussian_curvature_integral(const VesicleSnapshot& vesicle, std::optional<double> known_area) {
    return partial_gaussian_curvature(vesicle) / geometry_coverage(vesicle, known_area);
}

} // namespace vesica
