#pragma once

#include "io/surface_reader.hpp"

#include <span>
#include <string>
#include <vector>

namespace vesica {

/// What the report colours a surface by.
struct ColourQuantity {
    std::string name;
    std::string unit_like; ///< the quantity of the surface file that has its unit
};

/// The scalars the report knows how to make of a surface's quantities: curvatures, forces, their sum, speed.
std::span<const ColourQuantity> colour_quantities();

/// Where 98 of 100 values of a quantity lie in one step.
struct ValueSpread {
    double low = 0.0;
    double high = 0.0;
};

/// One step's surfaces as the report's page decodes them (report/src/frame.js). `bytes` are the length of a
/// JSON header in four bytes (little-endian), the header, and for each surface meshoptimizer's encodings of
/// its points and its triangles. A point is uint16 numbers: x, y, z in steps of `unit` from `origin`, then
/// each quantity in `value_steps` from its `low` to its `high`; values that are not finite become `low`.
struct PackedStep {
    std::int64_t step = 0;
    double time = 0.0;
    std::size_t triangles = 0;
    std::size_t largest_surface = 0;  ///< triangles of it
    std::vector<ValueSpread> spreads; ///< as many as colour_quantities()
    std::string bytes;
};

PackedStep pack_surfaces(const SurfaceStep& step);

} // namespace vesica
