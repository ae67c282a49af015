#pragma once

#include "case/case.hpp"
#include "case/solid_voxels.hpp"

#include <cstdint>

namespace vesica {

/// Packs what the case's [suspension] asks for: from then on these are vesicles like any other, the last
/// `what.packed` of them. Nothing where there is none, or where it has been done. The same case gives the
/// same bits. Throws InputError where they do not fit, which says how many would.
void pack_suspension(Case& what);

/// Cells of fluid in a region of the box.
std::int64_t fluid_cells(const Vec3<int>& begin, const Vec3<int>& end, const SolidVoxels* solids);

} // namespace vesica
