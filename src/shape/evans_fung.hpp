#pragma once

#include "shape/meridian.hpp"

namespace vesica {

/// Meridian of the resting red cell of Evans & Fung 1972 (Microvasc. Res. 4, 335), as used by Spendlove et
/// al. 2021, Eq 66: z = (1/2) sqrt(1 - r^2/R^2) (C0 + C1 r^2/R^2 + C2 r^4/R^4), in units of its largest
/// radius R.
Meridian evans_fung_meridian();

} // namespace vesica
