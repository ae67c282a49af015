#include "io/chunk_layout.hpp"

#include <algorithm>

namespace vesica {
namespace {

/// Far more than what deflate looks back on (32 kB), few enough that threads and ranks find work.
constexpr std::size_t bytes_wanted = std::size_t{256} << 10;

int as_many(std::size_t bytes_each, int at_most) {
    return std::clamp(static_cast<int>(std::min<std::size_t>(bytes_wanted / bytes_each, 1u << 30)), 1,
                      at_most);
}

} // namespace

ChunkLayout::ChunkLayout(const Vec3<int>& box, std::size_t width)
    : box_(box), width_(width), edges_(box), across_{1, 1, 1} {
    const std::size_t row = static_cast<std::size_t>(box.x) * width;
    const std::size_t plane = static_cast<std::size_t>(box.y) * row;
    edges_.z = as_many(plane, box.z);
    edges_.y = edges_.z > 1 ? box.y : as_many(row, box.y);
    for (int a = 0; a < 3; ++a)
        across_[a] = (box[a] + edges_[a] - 1) / edges_[a];
}

Vec3<int> ChunkLayout::begin(std::int64_t chunk) const {
    return {0, static_cast<int>(chunk % across_.y) * edges_.y,
            static_cast<int>(chunk / across_.y) * edges_.z};
}

CellBox ChunkLayout::elements(std::int64_t chunk) const {
    return common({begin(chunk), edges_}, {{}, box_});
}

CellBox common(const CellBox& a, const CellBox& b) {
    CellBox shared;
    for (int axis = 0; axis < 3; ++axis) {
        shared.begin[axis] = std::max(a.begin[axis], b.begin[axis]);
        const int end = std::min(a.begin[axis] + a.size[axis], b.begin[axis] + b.size[axis]);
        shared.size[axis] = std::max(0, end - shared.begin[axis]);
    }
    return shared.volume() > 0 ? shared : CellBox{};
}

} // namespace vesica
