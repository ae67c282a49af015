#pragma once

#include "case/suspension_parameters.hpp"
#include "io/case_values.hpp"

#include <filesystem>
#include <optional>

namespace vesica {

/// The table [suspension]; nothing without it. Mesh files are looked for in `folder`. Throws InputError.
std::optional<SuspensionParameters> build_suspension(const CaseValues& values, const Parameters& parameters,
                                                     const std::filesystem::path& folder);

} // namespace vesica
