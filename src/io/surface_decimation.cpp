#include "io/surface_decimation.hpp"

#include <meshoptimizer.h>

#include <algorithm>

namespace vesica {
namespace {

/// Beyond this share of the surface's extent an edge is not collapsed, however many triangles remain.
constexpr float largest_error = 0.02f;

/// meshoptimizer measures errors against the extent; single precision is what the file had.
std::vector<float> positions_of(const SurfaceArrays& surface) {
    std::vector<float> positions;
    positions.reserve(3 * surface.points.size());
    for (const auto& point : surface.points)
        for (int axis = 0; axis < 3; ++axis)
            positions.push_back(static_cast<float>(point[axis] - surface.points.front()[axis]));
    return positions;
}

std::vector<unsigned int> indices_of(const SurfaceArrays& surface) {
    std::vector<unsigned int> indices;
    indices.reserve(3 * surface.triangles.size());
    for (const auto& triangle : surface.triangles)
        for (const std::int32_t corner : triangle)
            indices.push_back(static_cast<unsigned int>(corner));
    return indices;
}

/// The points that triangles still name, at their new places.
SurfaceArrays remapped(const SurfaceArrays& surface, const std::vector<unsigned int>& indices) {
    constexpr auto gone = ~0u;
    std::vector<unsigned int> place(surface.points.size());
    const std::size_t kept =
        meshopt_optimizeVertexFetchRemap(place.data(), indices.data(), indices.size(), place.size());
    SurfaceArrays result;
    result.vesicle = surface.vesicle;
    result.points.resize(kept);
    for (const auto& quantity : surface.quantities)
        result.quantities.push_back(
            {quantity.name, quantity.components,
             std::vector<float>(kept * static_cast<std::size_t>(quantity.components))});
    for (std::size_t old = 0; old < place.size(); ++old) {
        if (place[old] == gone)
            continue;
        result.points[place[old]] = surface.points[old];
        for (std::size_t q = 0; q < surface.quantities.size(); ++q) {
            const auto components = static_cast<std::size_t>(surface.quantities[q].components);
            std::copy_n(surface.quantities[q].values.begin() + static_cast<std::ptrdiff_t>(old * components),
                        components,
                        result.quantities[q].values.begin() +
                            static_cast<std::ptrdiff_t>(place[old] * components));
        }
    }
    for (std::size_t i = 0; i < indices.size(); i += 3)
        result.triangles.push_back({static_cast<std::int32_t>(place[indices[i]]),
                                    static_cast<std::int32_t>(place[indices[i + 1]]),
                                    static_cast<std::int32_t>(place[indices[i + 2]])});
    return result;
}

} // namespace

SurfaceArrays decimate(const SurfaceArrays& surface, std::size_t triangles) {
    if (surface.triangles.empty())
        return surface;
    const std::vector<float> positions = positions_of(surface);
    const std::size_t points = surface.points.size();
    std::vector<unsigned int> indices = indices_of(surface);
    if (surface.triangles.size() > triangles) {
        std::vector<unsigned int> fewer(indices.size());
        fewer.resize(meshopt_simplify(fewer.data(), indices.data(), indices.size(), positions.data(), points,
                                      3 * sizeof(float), 3 * triangles, largest_error, 0, nullptr));
        indices = std::move(fewer);
    }
    std::vector<unsigned int> ordered(indices.size());
    meshopt_optimizeVertexCacheStrip(ordered.data(), indices.data(), indices.size(), points);
    return remapped(surface, ordered);
}

} // namespace vesica
