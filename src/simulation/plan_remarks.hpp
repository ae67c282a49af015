#pragma once

#include <string>
#include <vector>

namespace vesica {

/// Something worth saying about a case. A note needs no action; a warning says what to change; an error is a case
/// that `run` refuses.
struct Remark {
    enum class Severity { note, warning, error };
    Severity severity = Severity::note;
    std::string text;
};

using Remarks = std::vector<Remark>;

bool has_errors(const Remarks& remarks);

/// The texts of one severity, in order.
std::vector<std::string> texts_of(const Remarks& remarks, Remark::Severity severity);

} // namespace vesica
