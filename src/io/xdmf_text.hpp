#pragma once

#include "io/field_step_file.hpp"

#include <functional>
#include <span>
#include <string>

namespace vesica {

/// The text of an XDMF file that shows these steps as a series in time: cell data on a uniform grid.
/// `location` gives the HDF5 file of a step as seen from the XDMF file. XDMF lists everything slowest index
/// first: z, y, x.
std::string xdmf_text(std::span<const FieldStep> steps,
                      const std::function<std::string(const FieldStep&)>& location);

} // namespace vesica
