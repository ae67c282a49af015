#pragma once

#include "core/vec3.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace vesica {

/// A quantity on a surface's points: `components` numbers (1 or 3) per point, in the points' order.
struct SurfaceQuantity {
    std::string name;
    int components = 1;
    std::vector<float> values;
};

/// One vesicle's surface: points in the file's unit of length, triangles with outward normals by the right
/// hand.
struct SurfaceArrays {
    int vesicle = 0;
    std::vector<Vec3<double>> points;
    std::vector<std::array<std::int32_t, 3>> triangles;
    std::vector<SurfaceQuantity> quantities;
};

/// Writes VTK PolyData (XML, raw appended binary, single precision) with all surfaces in one piece; the cell
/// data `vesicle` tells them apart. The surfaces must carry the same quantities. The field data hold
/// `TimeValue` and `step`. Throws RunError.
void write_surface_file(const std::filesystem::path& path, std::span<const SurfaceArrays> surfaces,
                        std::int64_t step, double time);

} // namespace vesica
