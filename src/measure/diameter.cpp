#include "measure/diameter.hpp"

#include "measure/layer_sum.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace vesica {
namespace {

/// Evenly spread over the half sphere: the golden-angle spiral.
std::vector<Vec3<double>> half_sphere_directions(int count) {
    const double golden_angle = std::numbers::pi * (3.0 - std::sqrt(5.0));
    std::vector<Vec3<double>> directions;
    for (int i = 0; i < count; ++i) {
        const double z = (i + 0.5) / count;
        const double r = std::sqrt(1.0 - z * z);
        directions.push_back({r * std::cos(golden_angle * i), r * std::sin(golden_angle * i), z});
    }
    return directions;
}

template <class Measure>
std::size_t index_of_largest(const std::vector<Vec3<double>>& points, Measure measure) {
    std::size_t best = 0;
    double largest = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double value = measure(points[i]);
        if (value > largest) {
            largest = value;
            best = i;
        }
    }
    return best;
}

double squared_distance(const Vec3<double>& a, const Vec3<double>& b) {
    const Vec3<double> d = a - b;
    return dot(d, d);
}

} // namespace

std::vector<Vec3<double>> surface_points(const VesicleSnapshot& vesicle, double reach) {
    std::vector<Vec3<double>> points;
    for (const InterfaceCell& cell : vesicle.cells)
        if (cell.has_geometry && std::abs(cell.s) <= reach)
            points.push_back(foot_point(cell));
    return points;
}

double largest_diameter(const std::vector<Vec3<double>>& points) {
    if (points.size() < 2)
        return 0.0;
    double longest = 0.0;
    for (const Vec3<double>& direction : half_sphere_directions(256)) {
        std::size_t here = index_of_largest(points, [&](const auto& p) { return dot(p, direction); });
        double reached = 0.0;
        while (true) {
            const std::size_t there =
                index_of_largest(points, [&](const auto& p) { return squared_distance(p, points[here]); });
            const double distance = squared_distance(points[here], points[there]);
            if (distance <= reached)
                break;
            reached = distance;
            here = there;
        }
        longest = std::max(longest, reached);
    }
    return std::sqrt(longest);
}

double largest_diameter(const VesicleSnapshot& vesicle) {
    const std::vector<Vec3<double>> points = surface_points(vesicle);
    return points.empty() ? std::numeric_limits<double>::quiet_NaN() : largest_diameter(points);
}

double deformation_index(double diameter, double diameter_at_rest) {
    const double square = (diameter / diameter_at_rest) * (diameter / diameter_at_rest);
    return (square - 1.0) / (square + 1.0);
}

} // namespace vesica
