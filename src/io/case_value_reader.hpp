#pragma once

#include "io/case_values.hpp"
#include "io/toml_tree.hpp"

#include <string>

namespace vesica {

/// Reads one value as its key declares it: kind, unit, dimension, choices, and the range of plain numbers
/// (quantities meet their range on the lattice). Throws InputError `PATH is VALUE; expected ...; try ...` at
/// the value's place.
CaseValue read_case_value(const TomlNode& node, const CaseKey& key, const std::string& path);

/// Holds a lattice number against the key's range; `scalar` tells how it was written. Throws InputError.
void check_range(const CaseKey& key, const std::string& path, const CaseScalar& scalar, double lattice);

} // namespace vesica
