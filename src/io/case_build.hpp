#pragma once

#include "case/case.hpp"
#include "io/case_units.hpp"
#include "io/case_values.hpp"

#include <filesystem>

namespace vesica {

/// Refuses what needs more than one key to be seen but no units: references to nothing, what is not available
/// yet.
void check_references(const CaseValues& values);

/// Makes the types of a case from its values, which are lattice numbers by now, and refuses what does not go
/// together. `folder` is where mesh files are looked for. Warnings are added to `values`.
void build_case(CaseValues& values, const CaseUnits& units, const std::filesystem::path& folder,
                Case& result);

} // namespace vesica
