#pragma once

#include "io/surface_file.hpp"

#include <cstddef>

namespace vesica {

/// The surface with at most about `triangles` triangles: edges collapse onto points that are there, least
/// quadric error first (Garland and Heckbert 1997, by meshoptimizer), so that a closed surface stays closed
/// and each point keeps its values. Points and triangles come in an order that compresses well.
SurfaceArrays decimate(const SurfaceArrays& surface, std::size_t triangles);

} // namespace vesica
