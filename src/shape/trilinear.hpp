#pragma once

#include "core/vec3.hpp"

#include <cmath>

namespace vesica {

/// A distance, and the direction in which it grows fastest.
struct DistanceValue {
    double distance = 0.0;
    Vec3<double> gradient{}; ///< of unit length where the distance has one
};

/// Between the values of the eight nodes around a place, which is in units of the nodes' spacing:
/// node(Vec3<int>).
template <class Node>
DistanceValue trilinear(const Vec3<double>& place, const Node& node) {
    Vec3<int> low{};
    Vec3<double> part{};
    for (int a = 0; a < 3; ++a) {
        const double floor = std::floor(place[a]);
        low[a] = static_cast<int>(floor);
        part[a] = place[a] - floor;
    }
    DistanceValue value;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3<int> step{corner & 1, corner >> 1 & 1, corner >> 2 & 1};
        const auto weight = [&](int a) {
            return step[a] == 1 ? part[a] : 1.0 - part[a];
        };
        const double distance = node(low + step);
        value.distance += weight(0) * weight(1) * weight(2) * distance;
        for (int a = 0; a < 3; ++a)
            value.gradient[a] +=
                (step[a] == 1 ? 1.0 : -1.0) * weight((a + 1) % 3) * weight((a + 2) % 3) * distance;
    }
    const double length = norm(value.gradient);
    if (length > 0.0)
        value.gradient = (1.0 / length) * value.gradient;
    return value;
}

} // namespace vesica
