#pragma once

#include "lattice/block.hpp"
#include "lattice/grid.hpp"
#include "lattice/populations.hpp"
#include "lattice/solid_cells.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace vesica {

/// What a link from a fluid cell into a solid one meets.
struct WallLink {
    int wall = 0;
    Vec3<double> velocity{}; ///< of the wall at the link's middle, at full strength
};

/// How a wall is in one step.
struct WallState {
    double strength = 1.0;          ///< of its velocities
    bool open = false;              ///< an outlet of known density
    double density_deviation = 0.0; ///< from the reference, of an outlet
};

/// Half-way bounce-back at solid cells: what would enter one comes back along its link in the same step, from
/// a wall that lies half-way; a wall that moves with velocity U gives it -6 t_i rho0 c_i.U on the way (Ladd
/// 1994). At an outlet it comes back with the opposite sign and twice the even part of the equilibrium at the
/// outlet's density and the cell's velocity (anti-bounce-back, Ginzburg et al. 2008). A link's two places
/// belong to its fluid cell alone, so that every cell can be dealt with as soon as it has been streamed, and
/// neither exchange between blocks nor ghosts are disturbed.
template <class Real>
class BounceBack {
public:
    BounceBack() = default;
    /// link_of(fluid cell of the box, direction) says what solid lies there: walls count from 0 to wall_count
    /// - 1.
    template <class LinkOf>
    BounceBack(const PopulationView<Real>& f, const Grid& grid, const Block& block, const SolidCells& solids,
               int wall_count, const LinkOf& link_of, double reference_density)
        : f_(f), size_(grid.size()), rho0_(reference_density), walls_(static_cast<std::size_t>(wall_count)) {
        for (int i = 0; i < direction_count; ++i)
            offsets_[i] = grid.offset(velocity(i, 0), velocity(i, 1), velocity(i, 2));
        row_begins_.push_back(0);
        for (int z = 0; z < size_.z; ++z)
            for (int y = 0; y < size_.y; ++y) {
                for (int x = 0; x < size_.x; ++x) {
                    const std::int64_t cell = grid.index(x, y, z);
                    if (solids.has(cell))
                        continue;
                    for (int i = 1; i < direction_count; ++i)
                        if (solids.has(cell + offsets_[i]))
                            add(cell, i, link_of(Vec3<int>{x, y, z} + block.own.begin, i));
                }
                row_begins_.push_back(links_.size());
            }
    }

    std::size_t bytes() const {
        return links_.capacity() * sizeof(Link) + row_begins_.capacity() * sizeof(std::size_t);
    }

    /// One per wall, for the steps to come.
    void set_walls(std::span<const WallState> walls) {
        std::copy(walls.begin(), walls.end(), walls_.begin());
    }

    /// After a step, for cells that have been streamed: rows are numbered y + size.y z.
    template <Streaming streaming>
    void reflect_rows(std::int64_t first, std::int64_t last) const {
        for (std::size_t k = row_begins_[static_cast<std::size_t>(first)];
             k < row_begins_[static_cast<std::size_t>(last)]; ++k) {
            const Link& link = links_[k];
            const WallState& wall = walls_[link.wall];
            const int i = link.direction;
            Real* const inside = f_.slot(opposite(i)) + link.cell;
            Real* const beyond = f_.slot(i) + link.cell + offsets_[i];
            const Real* const from = streaming == Streaming::arrived ? inside : beyond;
            Real* const to = streaming == Streaming::arrived ? beyond : inside;
            if (!wall.open)
                *to = *from + static_cast<Real>(link.gift * wall.strength);
            else
                *to = static_cast<Real>(even_part<streaming>(link, wall)) - *from;
        }
    }

    /// The force of each wall but outlets on the fluid in the last step, whose states are still set: the
    /// momentum its links gave. From what came back alone, which a cell keeps when it is saved. Sums are
    /// exact.
    template <class Sum>
    void add_forces(Streaming streaming, std::vector<std::array<Sum, 3>>& forces) const {
        for (const Link& link : links_) {
            if (walls_[link.wall].open)
                continue;
            const int i = link.direction;
            const double gift = link.gift * walls_[link.wall].strength;
            Real back = f_.slot(opposite(i))[link.cell];
            if (streaming == Streaming::turned) // it lies beyond, and here what was sent
                back += static_cast<Real>(gift);
            const double lost = 2.0 * static_cast<double>(back) - gift + 2.0 * weight(i) * rho0_;
            for (int a = 0; a < 3; ++a)
                if (velocity(i, a) != 0)
                    forces[link.wall][static_cast<std::size_t>(a)].add(-velocity(i, a) * lost);
        }
    }

private:
    struct Link {
        std::int64_t cell;
        double gift; ///< what f_i* gains at full strength where it is turned back
        std::uint16_t direction;
        std::uint16_t wall;
    };

    void add(std::int64_t cell, int i, const WallLink& link) {
        double along = 0.0;
        for (int a = 0; a < 3; ++a)
            along += velocity(i, a) * link.velocity[a];
        links_.push_back({cell, -6.0 * weight(i) * rho0_ * along, static_cast<std::uint16_t>(i),
                          static_cast<std::uint16_t>(link.wall)});
    }

    /// 2 t_i rho (1 + 9/2 (c_i.u)^2 - 3/2 u^2) - 2 t_i rho0 with the cell's velocity after collision.
    template <Streaming streaming>
    double even_part(const Link& link, const WallState& wall) const {
        double mass = rho0_;
        Vec3<double> momentum{};
        for_each_direction([&](auto k) {
            const auto g =
                static_cast<double>(*f_.template departing<streaming, decltype(k)::value>(link.cell));
            mass += g;
            for (int a = 0; a < 3; ++a)
                momentum[a] += velocity(k, a) * g;
        });
        const Vec3<double> u = (1.0 / mass) * momentum;
        const int i = link.direction;
        const double along = velocity(i, 0) * u.x + velocity(i, 1) * u.y + velocity(i, 2) * u.z;
        const double rho = rho0_ + wall.density_deviation;
        return 2.0 * weight(i) * (wall.density_deviation + rho * (4.5 * along * along - 1.5 * dot(u, u)));
    }

    PopulationView<Real> f_;
    Vec3<int> size_{};
    double rho0_ = 1.0;
    std::int64_t offsets_[direction_count] = {};
    std::vector<Link> links_;
    std::vector<std::size_t> row_begins_;
    std::vector<WallState> walls_;
};

} // namespace vesica
