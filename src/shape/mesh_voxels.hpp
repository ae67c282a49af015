#pragma once

#include "case/solid_voxels.hpp"
#include "case/triangle_mesh.hpp"

namespace vesica {

/// The cells of a box whose centres are inside (`solid_inside`) or outside the closed surfaces of a mesh. The
/// points times `scale` (> 0) plus `position` are in cells: cell i spans [i, i + 1) along each axis. A centre
/// on the surface counts as if it lay an infinitesimal step further along +x, +y, +z, so a body of whole
/// cells keeps its volume wherever it stands. Surfaces may leave the box. A mesh may have several pieces; one
/// within another is a hollow in it. Throws InputError that names the mesh's source unless every piece passes
/// `closed_mesh` and no two meet.
SolidVoxels voxelise(const TriangleMesh& mesh, const Vec3<int>& size, double scale,
                     const Vec3<double>& position, bool solid_inside);

} // namespace vesica
