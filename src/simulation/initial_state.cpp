#include "simulation/initial_state.hpp"

#include "colour/phase.hpp"
#include "parallel/for_each.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace vesica {

namespace {

/// How far x lies from the centre by the shortest way round the box, and by the other one.
struct Offsets {
    double way[2];
};
Offsets offsets(double x, double centre, int size) {
    const double shortest = (x - centre) - size * std::round((x - centre) / size);
    return {{shortest, shortest > 0.0 ? shortest - size : shortest + size}};
}

double squared(double x) {
    return x * x;
}

} // namespace

struct InitialColours::Row {
    /// One image of a shape, as a row of cells sees it.
    struct Near {
        const Placed* placed;
        double y; ///< of the row, from the image's centre
        double z;
        double reach; ///< half the row's length within reach of the bounding sphere, squared
    };
    std::vector<Near> images;
    double far = 0.0;
};

std::vector<InitialColours::Placed> InitialColours::shapes_near_plane(int z, double far) const {
    std::vector<Placed> near;
    for (const Placed& placed : shapes_) {
        const double reach = placed.shape->bounding_radius() + far;
        for (const double from : offsets(z + 0.5, placed.centre.z, block_.box.z).way)
            if (std::abs(from) < reach) {
                near.push_back(placed);
                break;
            }
    }
    return near;
}

void InitialColours::find_near(std::span<const Placed> shapes, int y, int z, double far, Row& row) const {
    row.images.clear();
    row.far = far;
    for (const Placed& placed : shapes) {
        const double reach = squared(placed.shape->bounding_radius() + far);
        for (const double from_y : offsets(y + 0.5, placed.centre.y, block_.box.y).way)
            for (const double from_z : offsets(z + 0.5, placed.centre.z, block_.box.z).way)
                if (const double left = reach - squared(from_y) - squared(from_z); left > 0.0)
                    row.images.push_back({&placed, from_y, from_z, left});
    }
}

double InitialColours::distance(const Row& row, std::size_t first_image, std::size_t last_image,
                                int x) const {
    struct Candidate {
        const Row::Near* image = nullptr;
        double x = 0.0; ///< of the cell, from the image's centre
        double at_least =
            std::numeric_limits<double>::max(); ///< no surface is nearer than its bounding sphere
    };
    const auto for_each_in_reach = [&](const auto& body) {
        for (const Row::Near& image : std::span(row.images).subspan(first_image, last_image - first_image))
            for (const double from_x : offsets(x + 0.5, image.placed->centre.x, block_.box.x).way)
                if (squared(from_x) < image.reach)
                    body(Candidate{&image, from_x,
                                   std::sqrt(squared(from_x) + squared(image.y) + squared(image.z)) -
                                       image.placed->shape->bounding_radius()});
    };
    const auto exactly = [&](const Candidate& candidate) {
        const Vec3<double>& centre = candidate.image->placed->centre;
        return candidate.image->placed->shape->signed_distance(
            {centre.x + candidate.x, centre.y + candidate.image->y, centre.z + candidate.image->z});
    };
    // The nearest sphere first: most of the others need no more.
    Candidate first;
    for_each_in_reach([&](const Candidate& candidate) {
        if (candidate.at_least < first.at_least)
            first = candidate;
    });
    if (first.image == nullptr)
        return row.far;
    double nearest = std::min(row.far, exactly(first));
    for_each_in_reach([&](const Candidate& candidate) {
        const bool done = candidate.image == first.image && candidate.x == first.x;
        if (!done && candidate.at_least < nearest)
            nearest = std::min(nearest, exactly(candidate));
    });
    return nearest;
}

InitialColours::InitialColours(const Block& block, std::vector<Placed> shapes, double beta, double cutoff,
                               int threads)
    : block_(block),
      grid_(block.own.size),
      shapes_(std::move(shapes)),
      beta_(beta),
      interior_(static_cast<std::size_t>(grid_.tiles()), -1) {
    const Vec3<int> size = grid_.size();
    const Vec3<int> begin = block.own.begin;
    // 1 - tanh^2(beta s) = cutoff at this distance.
    const double core_reach = std::atanh(std::sqrt(1.0 - cutoff)) / beta;
    std::vector<std::vector<Band::Seed>> core_of_plane(static_cast<std::size_t>(size.z));
    for_each_index(size.z, threads, [&](std::int64_t plane) {
        const int z = static_cast<int>(plane);
        const std::vector<Placed> near = shapes_near_plane(begin.z + z, core_reach + 1.0);
        Row row;
        for (int y = 0; y < size.y; ++y) {
            find_near(near, begin.y + y, begin.z + z, core_reach + 1.0, row);
            for (int x0 = 0; x0 < size.x && !row.images.empty(); x0 += Grid::tile) {
                const std::int64_t tile = grid_.index(x0, y, z) / Grid::tile;
                const unsigned all = grid_.interior_bits({x0, y, z});
                std::size_t behind = 0;
                for (std::size_t first = 0; first < row.images.size(); first = behind) {
                    const int label = row.images[first].placed->label;
                    while (behind < row.images.size() && row.images[behind].placed->label == label)
                        ++behind;
                    unsigned core = 0;
                    unsigned red = 0;
                    for (int k = 0; k < Grid::tile && x0 + k < size.x; ++k) {
                        const double s = distance(row, first, behind, begin.x + x0 + k);
                        red |= (s < 0.0 ? 1u : 0u) << k;
                        core |= (std::abs(s) < core_reach ? 1u : 0u) << k;
                    }
                    if (red == all)
                        interior_[static_cast<std::size_t>(tile)] = label;
                    if (core != 0)
                        core_of_plane[static_cast<std::size_t>(z)].push_back(
                            {tile, static_cast<std::uint8_t>(core), label});
                }
            }
        }
    });
    for (const std::vector<Band::Seed>& core : core_of_plane)
        core_.insert(core_.end(), core.begin(), core.end());
}

double InitialColours::chi_at(std::int64_t index, int label) const {
    Vec3<int> cell = grid_.tile_origin(index / Grid::tile) + block_.own.begin;
    cell.x += static_cast<int>(index % Grid::tile);
    const auto shapes = std::equal_range(shapes_.begin(), shapes_.end(), Placed{nullptr, {}, label},
                                         [](const Placed& a, const Placed& b) { return a.label < b.label; });
    // To where the layer has long died away: 1e-21.
    thread_local Row row;
    find_near(std::span(shapes.first, shapes.second), cell.y, cell.z, 24.0 / beta_, row);
    const double s = distance(row, 0, row.images.size(), cell.x);
    // (1 - tanh(beta |s|))/2 = 1/(1 + exp(2 beta |s|)) keeps its digits in the tail.
    return with_sign_bit(s < 0.0, 1.0 / (1.0 + std::exp(2.0 * beta_ * std::abs(s))));
}

} // namespace vesica
