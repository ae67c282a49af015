#pragma once

#include <span>
#include <string_view>

namespace vesica {

/// A commented case to start from; the same text is shipped as cases/NAME.toml.
struct CaseTemplate {
    std::string_view name;
    std::string_view description;
    std::string_view text;
};

/// The first one is the default of `vesica new`.
std::span<const CaseTemplate> case_templates();

} // namespace vesica
