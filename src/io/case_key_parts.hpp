#pragma once

#include "io/case_keys.hpp"

#include <string>
#include <vector>

namespace vesica::detail {

/// The keys of [numerics], [run], [output] and [units].
std::vector<CaseKey> run_and_output_keys();

/// The keys of [boundary] and [flow].
std::vector<CaseKey> flow_keys();

/// The keys of a table that say what type and shape its vesicles are.
std::vector<CaseKey> shape_keys(const std::string& table);

/// The keys of [suspension].
std::vector<CaseKey> suspension_keys();

} // namespace vesica::detail
