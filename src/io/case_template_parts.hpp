#pragma once

#include "io/case_templates.hpp"

#include <span>

namespace vesica::detail {

/// Templates of cases with flow.
std::span<const CaseTemplate> flow_templates();

} // namespace vesica::detail
