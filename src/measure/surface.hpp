#pragma once

#include "measure/dense_block.hpp"
#include "measure/surface_mesh.hpp"

namespace vesica {

/// The surface s = 0 of a block of signed distances (negative inside), as a triangle mesh, by marching
/// tetrahedra on the Kuhn subdivision: each cube of eight nodes is cut into six tetrahedra around its main
/// diagonal, so that neighbouring cubes agree on their common faces and the mesh is closed and consistently
/// oriented whatever the values are - unless the inside reaches the block's rim, where the mesh ends.
///
/// The crossing of an edge is found linearly in s; s is very nearly linear across the layer where phi is not.
/// A node with s = 0 counts as outside, and crossings keep 1e-4 of the edge away from the nodes, so that no
/// triangle degenerates to a point. Facets cut corners: for a radius of curvature R_c area and volume are low
/// by a fraction of order 0.1/R_c^2.
SurfaceMesh extract_surface(const DenseBlock& distance);

/// The surface phi = 0 of one vesicle. Its lattice points refer to phase_block(vesicle), on which
/// nodal_values() puts any quantity of the layer's cells for interpolate().
SurfaceMesh extract_surface(const VesicleSnapshot& vesicle);

} // namespace vesica
