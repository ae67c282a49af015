#pragma once

#include "shape/shape.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace vesica {

/// `count` directions spread evenly over the sphere, none of them special (a Fibonacci lattice).
inline std::vector<Vec3<double>> directions(int count) {
    std::vector<Vec3<double>> found;
    const double turn = std::numbers::pi * (3.0 - std::sqrt(5.0));
    for (int i = 0; i < count; ++i) {
        const double z = 1.0 - (2.0 * i + 1.0) / count, r = std::sqrt(1.0 - z * z);
        found.push_back({r * std::cos(turn * i), r * std::sin(turn * i), z});
    }
    return found;
}

/// The gradient of the signed distance by central differences; exact to step^2 times third derivatives.
inline Vec3<double> distance_gradient(const Shape& shape, const Vec3<double>& x, double step = 1e-4) {
    Vec3<double> g{};
    for (int i = 0; i < 3; ++i) {
        Vec3<double> e{};
        e[i] = step;
        g[i] = (shape.signed_distance(x + e) - shape.signed_distance(x - e)) / (2.0 * step);
    }
    return g;
}

/// Volume and centre of the region inside, by sums over cells of a smooth step in the signed distance, 1
/// inside to 0 outside and odd about s = 0. What a layer adds grows with the square of its width, which
/// Richardson's extrapolation from two widths removes.
struct VoxelMoments {
    double volume = 0.0;
    Vec3<double> centre{};
};
inline VoxelMoments voxel_moments(const Shape& shape, double half_box, double spacing) {
    const auto layer = [&](double width) {
        VoxelMoments sum;
        const int n = static_cast<int>(half_box / spacing);
        for (int i = -n; i < n; ++i)
            for (int j = -n; j < n; ++j)
                for (int k = -n; k < n; ++k) {
                    const Vec3<double> x{(i + 0.5) * spacing, (j + 0.5) * spacing, (k + 0.5) * spacing};
                    const double s = std::clamp(shape.signed_distance(x) / width, -1.0, 1.0);
                    const double h = 0.5 - 0.9375 * (s - 2.0 * s * s * s / 3.0 + s * s * s * s * s / 5.0);
                    const double cell = h * spacing * spacing * spacing;
                    sum.volume += cell;
                    sum.centre = sum.centre + cell * x;
                }
        return sum;
    };
    const VoxelMoments narrow = layer(2.0 * spacing), wide = layer(4.0 * spacing);
    VoxelMoments result;
    result.volume = (4.0 * narrow.volume - wide.volume) / 3.0;
    result.centre = (1.0 / (3.0 * result.volume)) * (4.0 * narrow.centre - wide.centre);
    return result;
}

} // namespace vesica
