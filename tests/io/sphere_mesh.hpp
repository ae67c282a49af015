#pragma once

#include "io/surface_file.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <utility>

/// A sphere around (20, 30, 40) of an icosahedron cut `level` times, stretched along z; quantities that
/// change along it.
inline vesica::SurfaceArrays spheroid_mesh(double radius, double stretch, int level) {
    using Corner = vesica::Vec3<double>;
    const double g = std::numbers::phi;
    std::vector<Corner> points = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                                  {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    std::vector<std::array<std::int32_t, 3>> triangles = {
        {0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
        {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
        {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    for (int i = 0; i < level; ++i) {
        std::map<std::pair<int, int>, std::int32_t> middles;
        const auto middle = [&](std::int32_t a, std::int32_t b) {
            const auto [found, is_new] = middles.try_emplace({std::min(a, b), std::max(a, b)}, 0);
            if (is_new) {
                found->second = static_cast<std::int32_t>(points.size());
                points.push_back(points[static_cast<std::size_t>(a)] + points[static_cast<std::size_t>(b)]);
            }
            return found->second;
        };
        std::vector<std::array<std::int32_t, 3>> finer;
        for (const auto& [a, b, c] : triangles) {
            const std::int32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
        }
        triangles = std::move(finer);
        for (Corner& point : points)
            point = (1.0 / std::sqrt(dot(point, point))) * point;
    }
    vesica::SurfaceArrays surface;
    surface.triangles = std::move(triangles);
    surface.quantities = {{"mean_curvature", 1, {}},
                          {"gaussian_curvature", 1, {}},
                          {"bending_force", 1, {}},
                          {"tension_force", 1, {}},
                          {"velocity", 3, {}}};
    for (const Corner& point : points) {
        surface.points.push_back(
            Corner{20 + radius * point.x, 30 + radius * point.y, 40 + radius * stretch * point.z});
        for (std::size_t q = 0; q < 4; ++q)
            surface.quantities[q].values.push_back(static_cast<float>(static_cast<double>(q) + point.z));
        for (int axis = 0; axis < 3; ++axis)
            surface.quantities[4].values.push_back(static_cast<float>(point[axis]));
    }
    return surface;
}

inline double area_of(const vesica::SurfaceArrays& surface) {
    double area = 0.0;
    for (const auto& [a, b, c] : surface.triangles) {
        const auto at = [&](std::int32_t i) {
            return surface.points[static_cast<std::size_t>(i)];
        };
        const auto normal = cross(at(b) - at(a), at(c) - at(a));
        area += 0.5 * std::sqrt(dot(normal, normal));
    }
    return area;
}

/// Every edge is passed once in each direction: closed, and oriented the same way all over.
inline bool is_closed(const vesica::SurfaceArrays& surface) {
    std::map<std::pair<int, int>, int> passes;
    for (const auto& triangle : surface.triangles)
        for (std::size_t k = 0; k < 3; ++k)
            ++passes[{triangle[k], triangle[(k + 1) % 3]}];
    for (const auto& [edge, count] : passes)
        if (count != 1 || passes.count({edge.second, edge.first}) != 1)
            return false;
    return !passes.empty();
}
