#pragma once

#include <string>
#include <vector>

namespace vesica {

/// Something worth saying about a case. A note needs no action; a warning says what to change; an error is a
/// case that `run` refuses.
struct Remark {
    enum class Severity { note, warning, error };
    Severity severity = Severity::note;
    std::string key;  ///< path in the case file of what to look at, for its place; may be empty
    std::string text; ///< `path.key is VALUE: ...; expected ...; try ...`
};

using Remarks = std::vector<Remark>;

bool has_errors(const Remarks& remarks);

/// The texts of one severity, in order.
std::vector<std::string> texts_of(const Remarks& remarks, Remark::Severity severity);

} // namespace vesica
