#pragma once

#include "case/triangle_mesh.hpp"

namespace vesica {

/// Makes sure that a mesh bounds one vesicle: at least four triangles, none degenerate, every edge between
/// exactly two that agree on the outside, one piece, no pinched vertex, no self-intersection. A mesh whose
/// normals point inwards is turned inside out. Throws InputError that names the source, the first offending
/// triangles (counted from 0) and where they are.
TriangleMesh closed_mesh(TriangleMesh mesh);

} // namespace vesica
