#pragma once

#include "simulation/lattice_engine.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace vesica {

namespace detail {

/// One of the eight cells around a point.
struct Corner {
    Vec3<int> cell{}; ///< in the box
    double weight = 0.0;
    double boxes = 0.0; ///< upwards, across sliding faces
    bool in_box = true; ///< else beyond an end that is not periodic
};

} // namespace detail

/// Each rank tells of its own cells, and of the others' nothing; as sums of bits with zeros that is exact.
template <class Real>
std::vector<Vec3<double>> LatticeEngine<Real>::velocities(const std::vector<Vec3<double>>& places) const {
    constexpr std::size_t corners = 8;
    constexpr std::size_t words = 4; // a velocity, and whether there is fluid
    const double speed = block_.slide ? setup_.drive.slide_speed(step_) : 0.0;
    const double slid = block_.slide ? setup_.drive.displacement(step_) : 0.0;
    const auto corner_of = [&](Vec3<double> place, std::size_t k) {
        const Vec3<int> upper{static_cast<int>(k & 1), static_cast<int>(k >> 1 & 1),
                              static_cast<int>(k >> 2)};
        detail::Corner corner{{}, 1.0, 0.0, true};
        if (block_.slide) {
            const int across = block_.slide->gradient;
            corner.boxes = std::floor((std::floor(place[across] - 0.5) + upper[across]) / block_.box[across]);
            place[block_.slide->velocity] -= corner.boxes * slid;
        }
        for (int a = 0; a < 3; ++a) {
            const double below = std::floor(place[a] - 0.5);
            const double t = place[a] - 0.5 - below;
            corner.weight *= upper[a] == 1 ? t : 1.0 - t;
            const double index = below + upper[a];
            const double home = index - std::floor(index / block_.box[a]) * block_.box[a];
            corner.in_box =
                corner.in_box && (home == index || !(setup_.drive.has_walls(a) || setup_.drive.is_open(a)));
            corner.cell[a] = static_cast<int>(home);
        }
        return corner;
    };
    std::vector<std::uint64_t> told(places.size() * corners * words, 0);
    for_each_index(static_cast<std::int64_t>(places.size()), setup_.threads, [&](std::int64_t point) {
        for (std::size_t k = 0; k < corners; ++k) {
            const detail::Corner corner = corner_of(places[static_cast<std::size_t>(point)], k);
            const Vec3<int> here = corner.cell - block_.own.begin;
            bool own = corner.in_box;
            for (int a = 0; a < 3; ++a)
                own = own && here[a] >= 0 && here[a] < block_.own.size[a];
            if (!own)
                continue;
            const std::int64_t cell = grid_.index(here);
            if (solids_ && solids_.has(cell))
                continue;
            const Vec3<double> u =
                velocity_of(moments_at(cell), setup_.reference_density, whole_force_at(cell));
            std::uint64_t* const words_of_corner =
                told.data() + (static_cast<std::size_t>(point) * corners + k) * words;
            for (int a = 0; a < 3; ++a)
                words_of_corner[a] = std::bit_cast<std::uint64_t>(u[a]);
            words_of_corner[3] = 1;
        }
    });
    ranks().sum(std::span(told));
    std::vector<Vec3<double>> result(places.size());
    for (std::size_t point = 0; point < places.size(); ++point) {
        Vec3<double> sum{};
        double weights = 0.0;
        for (std::size_t k = 0; k < corners; ++k) {
            const std::uint64_t* const words_of_corner = told.data() + (point * corners + k) * words;
            if (words_of_corner[3] == 0)
                continue;
            const detail::Corner corner = corner_of(places[point], k);
            Vec3<double> u{std::bit_cast<double>(words_of_corner[0]),
                           std::bit_cast<double>(words_of_corner[1]),
                           std::bit_cast<double>(words_of_corner[2])};
            if (block_.slide)
                u[block_.slide->velocity] += corner.boxes * speed;
            sum = sum + corner.weight * u;
            weights += corner.weight;
        }
        constexpr double nan = std::numeric_limits<double>::quiet_NaN();
        result[point] = weights > 0.0 ? (1.0 / weights) * sum : Vec3<double>{nan, nan, nan};
    }
    return result;
}

} // namespace vesica
