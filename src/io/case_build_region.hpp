#pragma once

#include "core/vec3.hpp"
#include "io/case_values.hpp"

#include <string>

namespace vesica {

/// Part of a box of cells.
struct CaseRegion {
    Vec3<int> begin{}; ///< inclusive
    Vec3<int> end{};   ///< exclusive
};

/// The region at `path`, or all of a box of this size where none is given. Throws InputError for one that is
/// empty or reaches out of the box.
CaseRegion build_region(const CaseValues& values, const std::string& path, const Vec3<int>& size);

} // namespace vesica
