#pragma once

#include "case/case.hpp"

#include <string>

namespace vesica {

/// The case as a checkpoint keeps it: its text verbatim, and behind it, as comments, where it came from and what the
/// command line changed. So it can be read again to the same bits.
std::string case_text_of(const Case& what);

/// Reads such a text. Throws InputError.
Case case_of_text(const std::string& text);

} // namespace vesica
