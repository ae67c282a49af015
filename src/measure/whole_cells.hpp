#pragma once

#include "measure/snapshot.hpp"

namespace vesica {

/// The vesicle with all cells where the lattice's are: what lies beyond a sliding face, parts of a cell away,
/// is interpolated between its two neighbours along the line; the phase by its distance. For pictures: sums
/// over cells are better taken from the vesicle itself.
VesicleSnapshot on_whole_cells(const VesicleSnapshot& vesicle);

} // namespace vesica
