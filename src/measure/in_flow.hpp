#pragma once

#include "measure/equivalent_ellipsoid.hpp"
#include "measure/snapshot.hpp"

namespace vesica {

/// 2 pi over the time that a point of the membrane takes to go round in the shear plane through the centre of
/// mass, 1/steps; positive the way the shear turns. T is the integral of ds/u along the contour, the velocity
/// being that along the membrane relative to the centre's. NaN where the membrane does not go round one way
/// everywhere.
double tank_treading_frequency(const VesicleSnapshot& vesicle, const ShearPlane& plane);

/// What a vesicle adds to the stress of a box, times the box's volume: the component in the shear plane of
///   S = - int f x dV + int 2 (eta(x) - eta) E dV,
/// symmetrised, f the membrane's force on the fluid and eta(x) the layer's own viscosity; for a sharp surface
/// the second part is eta (lambda - 1) int (u n + n u) dA (Batchelor 1970; Kennedy, Pozrikidis & Skalak
/// 1994). `outer_viscosity` is eta, dynamic.
double particle_stress(const VesicleSnapshot& vesicle, const ShearPlane& plane, double outer_viscosity);

/// The smallest distance between the membrane and a wall; infinite without walls.
double distance_to_walls(const VesicleSnapshot& vesicle, const Snapshot& snapshot);

} // namespace vesica
