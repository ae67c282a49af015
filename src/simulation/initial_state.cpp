#include "simulation/initial_state.hpp"

#include "colour/phase.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vesica {

namespace {

/// x moved by whole boxes to within half a box of the centre.
double nearest_image(double x, double centre, int size) {
    return x - size * std::round((x - centre) / size);
}

} // namespace

InitialColours::InitialColours(const Grid& grid, std::vector<Placed> shapes, double beta, double cutoff)
    : grid_(grid),
      shapes_(std::move(shapes)),
      beta_(beta),
      inside_(static_cast<std::size_t>(grid.tiles()), 0) {
    const Vec3<int> size = grid.size();
    // 1 - tanh^2(beta s) = cutoff at this distance.
    const double core_reach = std::atanh(std::sqrt(1.0 - cutoff)) / beta;
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x0 = 0; x0 < size.x; x0 += Grid::tile) {
                const std::int64_t tile = grid.index(x0, y, z) / Grid::tile;
                unsigned core = 0;
                unsigned red = 0;
                for (int k = 0; k < Grid::tile && x0 + k < size.x; ++k) {
                    const double s = distance({x0 + k, y, z}, core_reach + 1.0);
                    if (s < 0.0)
                        red |= 1u << k;
                    if (std::abs(s) < core_reach)
                        core |= 1u << k;
                }
                inside_[static_cast<std::size_t>(tile)] = static_cast<std::uint8_t>(red);
                if (core != 0)
                    core_.push_back({tile, static_cast<std::uint8_t>(core)});
            }
}

/// From the nearest surface; `far` where that is farther.
double InitialColours::distance(const Vec3<int>& cell, double far) const {
    const Vec3<int> size = grid_.size();
    double nearest = far;
    for (const Placed& placed : shapes_) {
        const Vec3<double>& centre = placed.centre;
        const Vec3<double> position{nearest_image(cell.x + 0.5, centre.x, size.x),
                                    nearest_image(cell.y + 0.5, centre.y, size.y),
                                    nearest_image(cell.z + 0.5, centre.z, size.z)};
        if (norm(position - centre) - placed.shape->bounding_radius() < nearest)
            nearest = std::min(nearest, placed.shape->signed_distance(position));
    }
    return nearest;
}

double InitialColours::chi_at(std::int64_t index) const {
    Vec3<int> cell = grid_.tile_origin(index / Grid::tile);
    cell.x += static_cast<int>(index % Grid::tile);
    const double s = distance(cell, 40.0 / beta_); // where the layer has long died away
    // (1 - tanh(beta |s|))/2 = 1/(1 + exp(2 beta |s|)) keeps its digits in the tail.
    return with_sign_bit(s < 0.0, 1.0 / (1.0 + std::exp(2.0 * beta_ * std::abs(s))));
}

} // namespace vesica
