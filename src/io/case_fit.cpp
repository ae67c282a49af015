#include "io/case_fit.hpp"

#include <cmath>

namespace vesica {
namespace {

/// Radius across the axis and half-length along it, over the radius of the sphere of equal volume.
struct Extent {
    double across = 0.0;
    double along = 0.0;
};

struct LeastExtent {
    Extent operator()(const SphereShape&) const { return {1.0, 1.0}; }

    Extent operator()(const SpheroidShape& spheroid) const {
        const double across = std::cbrt(1.0 / spheroid.aspect);
        return {across, across * spheroid.aspect};
    }

    // Bounds over all tabulated reduced volumes, relative to R_A = R0 v^(-1/3).
    Extent operator()(const HelfrichShape& shape) const {
        const double area_radius = 1.0 / std::cbrt(shape.reduced_volume);
        switch (shape.branch) {
        case HelfrichBranch::discocyte:
            return {area_radius, 0.3 * area_radius};
        case HelfrichBranch::prolate:
            return {0.4 * area_radius, area_radius};
        case HelfrichBranch::stomatocyte:
            return {0.85 * area_radius, 0.7 * area_radius};
        }
        return {};
    }

    // Evans and Fung 1972: 3.91 um radius, 2.566 um thick, 94.09 um^3.
    Extent operator()(const EvansFungShape&) const { return {1.385, 0.454}; }

    Extent operator()(const MeshShape&) const { return {}; }
};

} // namespace

Vec3<double> least_half_widths(const VesicleParameters& vesicle) {
    const Extent extent = std::visit(LeastExtent{}, vesicle.shape);
    const double length = norm(vesicle.axis);
    Vec3<double> result;
    for (int a = 0; a < 3; ++a) {
        // Half-width of the spheroid of these semi-axes; every other shape with them reaches at least as far
        // along and across its axis.
        const double cosine = vesicle.axis[a] / length;
        const double aligned = extent.along * cosine;
        const double sine_squared = std::max(0.0, 1.0 - cosine * cosine);
        const bool spheroid = std::holds_alternative<SpheroidShape>(vesicle.shape) ||
                              std::holds_alternative<SphereShape>(vesicle.shape);
        const double radial = extent.across * std::sqrt(sine_squared);
        result[a] =
            vesicle.radius * (spheroid ? std::hypot(aligned, radial) : std::max(std::abs(aligned), radial));
    }
    return result;
}

} // namespace vesica
