#pragma once

#include "shape/shape.hpp"

#include <cmath>

namespace vesica {

/// The phase field to start from, -tanh(beta s): +1 inside, -1 outside; the profile of a flat interface at
/// rest to leading order. `position` in cells, `beta` in 1/cells.
inline double initial_phase(const Shape& shape, const Vec3<double>& position, double beta) {
    return -std::tanh(beta * shape.signed_distance(position));
}

} // namespace vesica
