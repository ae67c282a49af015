#include "simulation/plan_remarks.hpp"

#include <algorithm>

namespace vesica {

bool has_errors(const Remarks& remarks) {
    return std::any_of(remarks.begin(), remarks.end(),
                       [](const Remark& remark) { return remark.severity == Remark::Severity::error; });
}

std::vector<std::string> texts_of(const Remarks& remarks, Remark::Severity severity) {
    std::vector<std::string> texts;
    for (const Remark& remark : remarks)
        if (remark.severity == severity)
            texts.push_back(remark.text);
    return texts;
}

} // namespace vesica
