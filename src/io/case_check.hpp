#pragma once

#include "core/scales.hpp"
#include "io/case_values.hpp"
#include "io/toml_tree.hpp"

#include <optional>
#include <string>

namespace vesica {

/// Holds the tree against the declared keys: every key known, every value of its kind and dimension, every
/// number in its range, every group stated once, conditions met; defaults filled in. Quantities stay in SI.
/// Throws InputError for the first mistake of the file.
CaseValues check_case(const TomlNode& root, const std::string& file);

/// Turns every quantity into a lattice number and holds it against its range. Keys that stay in SI stay.
/// Throws InputError, also for a quantity where there are no scales.
void convert_to_lattice(CaseValues& values, const std::optional<Scales>& scales);

} // namespace vesica
