#include "measure/dense_block.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace vesica {
namespace {

Vec3<int> cell_of(const Vec3<double>& centre) {
    return {static_cast<int>(std::floor(centre.x)), static_cast<int>(std::floor(centre.y)),
            static_cast<int>(std::floor(centre.z))};
}

} // namespace

std::size_t block_index(const DenseBlock& block, const Vec3<double>& cell_centre) {
    const Vec3<int> place = cell_of(cell_centre) - block.origin;
    for (int a = 0; a < 3; ++a)
        assert(place[a] >= 0 && place[a] < block.size[a]);
    return block.index(place.x, place.y, place.z);
}

DenseBlock phase_block(const VesicleSnapshot& vesicle, int margin) {
    DenseBlock block;
    if (vesicle.cells.empty())
        return block;
    Vec3<int> low = cell_of(vesicle.cells.front().position);
    Vec3<int> high = low;
    const auto include = [&](const Vec3<int>& cell) {
        for (int a = 0; a < 3; ++a) {
            low[a] = std::min(low[a], cell[a]);
            high[a] = std::max(high[a], cell[a]);
        }
    };
    for (const InterfaceCell& cell : vesicle.cells)
        include(cell_of(cell.position));
    for (const InsideSpan& span : vesicle.inside) {
        include({span.begin, span.y, span.z});
        include({span.begin + span.count - 1, span.y, span.z});
    }
    const Vec3<int> rim{margin, margin, margin};
    block.origin = low - rim;
    block.size = high + rim - block.origin + Vec3<int>{1, 1, 1};
    block.values.assign(block.index(0, 0, block.size.z), -1.0);
    for (const InsideSpan& span : vesicle.inside) {
        const Vec3<int> start = Vec3<int>{span.begin, span.y, span.z} - block.origin;
        std::fill_n(block.values.begin() +
                        static_cast<std::ptrdiff_t>(block.index(start.x, start.y, start.z)),
                    span.count, 1.0);
    }
    for (const InterfaceCell& cell : vesicle.cells)
        block.values[block_index(block, cell.position)] = cell.phi;
    return block;
}

DenseBlock distance_block(const DenseBlock& phase, double beta) {
    const double almost_one = 1.0 - 1e-15;
    DenseBlock distance = phase;
    for (double& value : distance.values)
        value = -std::atanh(std::clamp(value, -almost_one, almost_one)) / beta;
    return distance;
}

} // namespace vesica
