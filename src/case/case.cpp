#include "case/case.hpp"

namespace vesica {

SourcePlace Case::place(const std::string& path) const {
    for (std::string around = path;;) {
        if (const auto found = places.find(around); found != places.end())
            return found->second;
        const auto end = around.find_last_of(".[");
        if (end == std::string::npos)
            return {source_file, 0, 0};
        around.resize(end);
    }
}

} // namespace vesica
