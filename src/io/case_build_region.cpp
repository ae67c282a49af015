#include "io/case_build_region.hpp"

#include <fmt/format.h>

namespace vesica {

CaseRegion build_region(const CaseValues& values, const std::string& path, const Vec3<int>& size) {
    CaseRegion region{{}, size};
    if (!values.find(path))
        return region;
    for (int a = 0; a < 3; ++a) {
        const std::int64_t begin = values.integer(path, static_cast<std::size_t>(a));
        const std::int64_t end = values.integer(path, static_cast<std::size_t>(a) + 3);
        if (begin < 0 || end > size[a] || begin >= end) {
            values.refuse(path,
                          fmt::format("expected two corners within the box, the second beyond the first; try "
                                      "region = [[0, 0, 0], [{}, {}, {}]]",
                                      size.x, size.y, size.z));
        }
        region.begin[a] = static_cast<int>(begin);
        region.end[a] = static_cast<int>(end);
    }
    return region;
}

} // namespace vesica
