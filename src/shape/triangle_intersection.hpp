#pragma once

#include "core/vec3.hpp"

#include <array>

namespace vesica {

using Triangle = std::array<Vec3<double>, 3>;

/// Whether two triangles without a common corner have a point in common; touching counts.
bool triangles_meet(const Triangle& a, const Triangle& b);

/// Whether two triangles with the common corner a[0] = b[0] have any other point in common.
bool triangles_meet_beyond_corner(const Triangle& a, const Triangle& b);

/// Whether two triangles with the common edge a[0] = b[0], a[1] = b[1] lie on each other.
bool triangles_fold(const Triangle& a, const Triangle& b);

} // namespace vesica
