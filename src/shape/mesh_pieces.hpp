#pragma once

#include "case/triangle_mesh.hpp"

namespace vesica {

/// Makes sure that a mesh bounds a region: every piece (triangles connected by edges) passes `closed_mesh`,
/// and no two pieces meet. Throws InputError that names the source and, where there are several pieces, the
/// piece; triangles are counted from 0, within the piece.
void check_closed_pieces(const TriangleMesh& mesh);

} // namespace vesica
