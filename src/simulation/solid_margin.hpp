#pragma once

#include "lattice/band.hpp"
#include "lattice/velocity_set.hpp"
#include "parallel/for_each.hpp"

#include <cmath>
#include <initializer_list>
#include <span>
#include <vector>

namespace vesica {

/// What solid cells beside a membrane stand for where its geometry is differentiated. Solids are of the outer
/// colour. A membrane that comes near one sees its own distance go on growing into it, straight away from the
/// surface, and its normals and curvatures go on as they are: as if it lay parallel to the solid. So it is
/// neither drawn to solids nor bent by them, and what lies on their other side is not felt.
template <class Real>
class SolidMargin {
public:
    using Arrays = std::initializer_list<std::span<Real>>;

    /// The band has been laid out anew.
    void follow(const Band& band) {
        cells_ = &band.solid_cells();
        neighbours_ = &band.fluid_neighbours();
        distances_.resize(neighbours_->size());
        for (const Band::SolidCell& cell : *cells_)
            find_distances(cell);
    }

    /// No solid cell of the block has anything to stand for.
    bool empty() const { return cells_ == nullptr || cells_->empty(); }
    std::size_t bytes() const { return distances_.capacity() * sizeof(double); }

    /// The mean of the fluid neighbours that belong to `level`, plus `slope` per cell of distance from them.
    void fill(Arrays arrays, int level, double slope, int threads) const {
        if (empty())
            return;
        for_each_index(static_cast<std::int64_t>(cells_->size()), threads, [&](std::int64_t k) {
            const Band::SolidCell& cell = (*cells_)[static_cast<std::size_t>(k)];
            for (const std::span<Real>& array : arrays) {
                double weights = 0.0;
                double sum = 0.0;
                for (std::uint32_t at = cell.begin; at < cell.end; ++at) {
                    const Band::FluidNeighbour& beside = (*neighbours_)[at];
                    if (beside.level > level)
                        continue;
                    const double w = weight(beside.direction);
                    weights += w;
                    sum += w * (static_cast<double>(array[static_cast<std::size_t>(beside.address)]) +
                                slope * distances_[at]);
                }
                if (weights > 0.0)
                    array[static_cast<std::size_t>(cell.address)] = static_cast<Real>(sum / weights);
            }
        });
    }

private:
    /// Along the mean direction of the fluid around; straight where that is nowhere, in a wall of one cell.
    void find_distances(const Band::SolidCell& cell) {
        Vec3<double> mean{};
        for (std::uint32_t at = cell.begin; at < cell.end; ++at) {
            const int i = (*neighbours_)[at].direction;
            mean = mean + weight(i) * along(i);
        }
        const double length = norm(mean);
        for (std::uint32_t at = cell.begin; at < cell.end; ++at) {
            const Vec3<double> link = along((*neighbours_)[at].direction);
            distances_[at] = length > 1e-6 ? std::abs(dot(link, mean)) / length : norm(link);
        }
    }

    static Vec3<double> along(int i) {
        return {1.0 * velocity(i, 0), 1.0 * velocity(i, 1), 1.0 * velocity(i, 2)};
    }

    const std::vector<Band::SolidCell>* cells_ = nullptr;
    const std::vector<Band::FluidNeighbour>* neighbours_ = nullptr;
    std::vector<double> distances_; ///< per neighbour
};

} // namespace vesica
