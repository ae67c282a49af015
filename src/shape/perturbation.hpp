#pragma once

#include "case/parameters.hpp"
#include "shape/spherical_harmonics.hpp"

#include <span>

namespace vesica {

/// The relative change of radius, sum of amplitude Y_lm, in the vesicle's frame. A random perturbation has a
/// Gaussian coefficient for each harmonic, all of equal variance in order of l, then m from -l to l, scaled
/// so that its root mean square over the sphere is exactly the amplitude. The numbers come from the Mersenne
/// twister mt19937_64 by the Box-Muller transform, both fixed by their definition: a seed means the same
/// shape with every compiler. Throws InputError for harmonics that do not exist and for amplitudes that would
/// push the surface through the vesicle's centre.
HarmonicSeries harmonic_series(std::span<const Perturbation> perturbations);

} // namespace vesica
