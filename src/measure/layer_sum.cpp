#include "measure/layer_sum.hpp"

#include "measure/area.hpp"

#include <algorithm>
#include <limits>

namespace vesica {

double geometry_trust(const VesicleSnapshot& vesicle, const InterfaceCell& cell) {
    if (!cell.has_geometry || !(cell.J > 0.1 && cell.J < 10.0))
        return 0.0;
    constexpr double none = 5e-3;
    constexpr double full = 2e-2;
    const double contrast = cell.weight / (0.5 * vesicle.beta); // 1 - phi^2
    const double t = std::clamp((contrast - none) / (full - none), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

double geometry_coverage(const VesicleSnapshot& vesicle, std::optional<double> known_area) {
    const double covered = geometry_sum(vesicle, [](const InterfaceCell& cell) { return cell.J; });
    if (!(covered > 0.0))
        return std::numeric_limits<double>::quiet_NaN();
    return covered / (known_area ? *known_area : area(vesicle));
}

LayerMoments layer_moments(const VesicleSnapshot& vesicle) {
    if (vesicle.layer.area > 0.0)
        return vesicle.layer;
    const double second = vesicle.layer_moment;
    return {second, 0.0, second, 0.0,
            4.2 * second * second}; // a tanh's fourth moment over its second's square
}

} // namespace vesica
