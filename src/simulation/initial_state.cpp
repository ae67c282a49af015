#include "simulation/initial_state.hpp"

#include "colour/phase.hpp"
#include "parallel/for_each.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vesica {

namespace {

/// x moved by whole boxes to within half a box of the centre.
double nearest_image(double x, double centre, int size) {
    return x - size * std::round((x - centre) / size);
}

double squared(double x) {
    return x * x;
}

} // namespace

struct InitialColours::Row {
    /// A shape as a row of cells sees it: its image the row passes nearest by.
    struct Near {
        const Placed* placed;
        double y;
        double z;
        double beside; ///< squared distance of its centre from the row
    };
    std::vector<Near> shapes;
    double far;
};

InitialColours::Row InitialColours::row_near(int y, int z, double far) const {
    Row row{{}, far};
    for (const Placed& placed : shapes_) {
        const double near_y = nearest_image(y + 0.5, placed.centre.y, grid_.size().y);
        const double near_z = nearest_image(z + 0.5, placed.centre.z, grid_.size().z);
        const double beside = squared(near_y - placed.centre.y) + squared(near_z - placed.centre.z);
        if (beside < squared(placed.shape->bounding_radius() + far))
            row.shapes.push_back({&placed, near_y, near_z, beside});
    }
    return row;
}

/// From the nearest surface; `far` where that is farther.
double InitialColours::distance(const Row& row, int x) const {
    const auto near_x = [&](const Row::Near& near) {
        return nearest_image(x + 0.5, near.placed->centre.x, grid_.size().x);
    };
    // No surface is nearer than its bounding sphere. The nearest sphere first: most others need no more.
    const auto at_least = [&](const Row::Near& near) {
        return std::sqrt(near.beside + squared(near_x(near) - near.placed->centre.x)) -
               near.placed->shape->bounding_radius();
    };
    const auto exactly = [&](const Row::Near& near) {
        return near.placed->shape->signed_distance({near_x(near), near.y, near.z});
    };
    const Row::Near* first = nullptr;
    double lowest = row.far;
    for (const Row::Near& near : row.shapes)
        if (const double bound = at_least(near); bound < lowest) {
            lowest = bound;
            first = &near;
        }
    if (first == nullptr)
        return row.far;
    double nearest = std::min(row.far, exactly(*first));
    for (const Row::Near& near : row.shapes)
        if (&near != first && at_least(near) < nearest)
            nearest = std::min(nearest, exactly(near));
    return nearest;
}

InitialColours::InitialColours(const Grid& grid, std::vector<Placed> shapes, double beta, double cutoff,
                               int threads)
    : grid_(grid),
      shapes_(std::move(shapes)),
      beta_(beta),
      inside_(static_cast<std::size_t>(grid.tiles()), 0) {
    const Vec3<int> size = grid.size();
    // 1 - tanh^2(beta s) = cutoff at this distance.
    const double core_reach = std::atanh(std::sqrt(1.0 - cutoff)) / beta;
    std::vector<std::vector<Band::Seed>> core_of_plane(static_cast<std::size_t>(size.z));
    for_each_index(size.z, threads, [&](std::int64_t plane) {
        const int z = static_cast<int>(plane);
        for (int y = 0; y < size.y; ++y) {
            const Row row = row_near(y, z, core_reach + 1.0);
            if (row.shapes.empty())
                continue;
            for (int x0 = 0; x0 < size.x; x0 += Grid::tile) {
                const std::int64_t tile = grid.index(x0, y, z) / Grid::tile;
                unsigned core = 0;
                unsigned red = 0;
                for (int k = 0; k < Grid::tile && x0 + k < size.x; ++k) {
                    const double s = distance(row, x0 + k);
                    if (s < 0.0)
                        red |= 1u << k;
                    if (std::abs(s) < core_reach)
                        core |= 1u << k;
                }
                inside_[static_cast<std::size_t>(tile)] = static_cast<std::uint8_t>(red);
                if (core != 0)
                    core_of_plane[static_cast<std::size_t>(z)].push_back(
                        {tile, static_cast<std::uint8_t>(core)});
            }
        }
    });
    for (const std::vector<Band::Seed>& core : core_of_plane)
        core_.insert(core_.end(), core.begin(), core.end());
}

double InitialColours::chi_at(std::int64_t index) const {
    Vec3<int> cell = grid_.tile_origin(index / Grid::tile);
    cell.x += static_cast<int>(index % Grid::tile);
    const Row row = row_near(cell.y, cell.z, 40.0 / beta_); // where the layer has long died away
    const double s = distance(row, cell.x);
    // (1 - tanh(beta |s|))/2 = 1/(1 + exp(2 beta |s|)) keeps its digits in the tail.
    return with_sign_bit(s < 0.0, 1.0 / (1.0 + std::exp(2.0 * beta_ * std::abs(s))));
}

} // namespace vesica
