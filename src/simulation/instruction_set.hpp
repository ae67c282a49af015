#pragma once

#include <string_view>

namespace vesica {

/// Whether this machine runs kernels compiled for `name`: baseline, avx2 or avx512. What these stand for is
/// said in cmake/instruction_sets.cmake.
bool instruction_set_runs_here(std::string_view name);

} // namespace vesica
