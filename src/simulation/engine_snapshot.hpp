#pragma once

#include "simulation/lattice_engine.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <tuple>

namespace vesica {

namespace detail {

template <class Real>
struct LaneValues {
    Real values[tile_width];
    explicit LaneValues(const Pack<Real>& pack) { pack.store(values); }
    double operator[](int k) const { return static_cast<double>(values[k]); }
};

template <class Real>
struct LaneVectors {
    LaneValues<Real> x, y, z;
    explicit LaneVectors(const Vec3<Pack<Real>>& a) : x(a.x), y(a.y), z(a.z) {}
    Vec3<double> operator[](int k) const { return {x[k], y[k], z[k]}; }
};

/// What the ranks have of a list, put together for the one that leads, in the order of `less`.
template <class T, class Less>
std::vector<T> gathered_list(const Ranks& ranks, std::vector<T> own, const Less& less) {
    if (ranks.count() == 1)
        return own;
    std::vector<T> all;
    ranks.gather(std::as_bytes(std::span(own)), [&](int, std::span<const std::byte> bytes) {
        const std::size_t before = all.size();
        all.resize(before + bytes.size() / sizeof(T));
        std::copy(bytes.begin(), bytes.end(), std::as_writable_bytes(std::span(all).subspan(before)).begin());
    });
    std::sort(all.begin(), all.end(), less);
    return all;
}

/// The one an unmoved cell of the layer lies in.
inline Vec3<int> cell_of(const InterfaceCell& cell) {
    return {static_cast<int>(cell.position.x), static_cast<int>(cell.position.y),
            static_cast<int>(cell.position.z)};
}

/// A mean of positions that counts a box's periodic images as one: each adds its direction round the box.
class CircularMean {
public:
    explicit CircularMean(double period) : turn_(2.0 * std::numbers::pi / period) {}

    void add(double place, double count) {
        sine_ += count * std::sin(turn_ * place);
        cosine_ += count * std::cos(turn_ * place);
    }
    double value() const {
        const double angle = std::atan2(sine_, cosine_) / turn_;
        return angle < 0.0 ? angle + 2.0 * std::numbers::pi / turn_ : angle;
    }

private:
    double turn_;
    double sine_ = 0.0;
    double cosine_ = 0.0;
};

} // namespace detail

/// A point near the vesicle's middle: the circular mean of the core's cells, so that periodic images do not
/// matter. They are counted plane by plane: the same bits however the box is shared out.
template <class Real>
Vec3<double> LatticeEngine<Real>::middle() const {
    const Vec3<int> box = block_.box;
    const auto for_each_core_cell = [&](const auto& body) {
        for (const BandTile& t : layer_.band().tiles())
            for (int k = 0; k < tile_width; ++k)
                if ((t.bits[0] >> k & 1) != 0)
                    body(grid_.tile_origin(t.tile) + block_.own.begin + Vec3<int>{k, 0, 0});
    };
    const std::array<int, 3> begins{0, box.x, box.x + box.y};
    std::vector<std::uint64_t> counts(static_cast<std::size_t>(box.x + box.y + box.z), 0);
    for_each_core_cell([&](const Vec3<int>& cell) {
        for (int a = 0; a < 3; ++a)
            ++counts[static_cast<std::size_t>(begins[static_cast<std::size_t>(a)] + cell[a])];
    });
    ranks().sum(counts);
    Vec3<double> middle{};
    for (int a = 0; a < 3; ++a) {
        detail::CircularMean mean(box[a]);
        for (int k = 0; k < box[a]; ++k)
            mean.add(k + 0.5, static_cast<double>(
                                  counts[static_cast<std::size_t>(begins[static_cast<std::size_t>(a)] + k)]));
        middle[a] = mean.value();
    }
    if (block_.slide) {
        // Images that have slid are counted apart: below, home, above.
        const auto [across, along] = *block_.slide;
        const auto length = static_cast<std::size_t>(box[along]);
        counts.assign(3 * length, 0);
        for_each_core_cell([&](const Vec3<int>& cell) {
            const auto image = 1 - std::lround((cell[across] + 0.5 - middle[across]) / box[across]);
            ++counts[static_cast<std::size_t>(image) * length + static_cast<std::size_t>(cell[along])];
        });
        ranks().sum(counts);
        const double slid = setup_.drive.displacement(step_);
        detail::CircularMean mean(box[along]);
        for (std::size_t k = 0; k < counts.size(); ++k)
            mean.add(static_cast<double>(k % length) + 0.5 + (static_cast<double>(k / length) - 1.0) * slid,
                     static_cast<double>(counts[k]));
        middle[along] = mean.value();
    }
    return middle;
}

/// From phi = 0 to the surface of an obstacle, half-way along the links that end there.
template <class Real>
double LatticeEngine<Real>::distance_to_obstacle(const InterfaceCell& cell, std::int64_t index) const {
    double distance = std::numeric_limits<double>::infinity();
    if (setup_.drive.obstacles() == nullptr)
        return distance;
    const Vec3<int> place = detail::cell_of(cell);
    const bool knows_normal = dot(cell.n, cell.n) > 0.5;
    for (int i = 1; i < direction_count; ++i) {
        const Vec3<double> link{1.0 * velocity(i, 0), 1.0 * velocity(i, 1), 1.0 * velocity(i, 2)};
        if (dot(link, link) > 1.0 ||
            !solids_.has(index + grid_.offset(velocity(i, 0), velocity(i, 1), velocity(i, 2))))
            continue;
        if (setup_.drive.link(place, i).wall == 0)
            distance = std::min(distance, cell.s + 0.5 * (knows_normal ? dot(cell.n, link) : -1.0));
    }
    return distance;
}

/// In the order of the tiles; positions as they lie in the box.
template <class Real>
std::vector<InterfaceCell> LatticeEngine<Real>::layer_cells() const {
    std::vector<InterfaceCell> cells;
    const LayerFields<Real>& fields = layer_.fields();
    for (const BandTile& t : layer_.band().tiles()) {
        const auto lanes = [&](const std::span<Real>& a) {
            return detail::LaneValues<Real>(V::load(a.data() + t.slot()));
        };
        const auto chi = lanes(fields.chi);
        const auto s = lanes(fields.s);
        const detail::LaneVectors<Real> n(TileRun<Real>{&t}.load(fields.n));
        const bool curved = t.bits[reach::curvature] != 0;
        const auto H0 = lanes(fields.raw_H0); // sharpening, which Lap_s H needs, adds noise to H itself
        const auto force_H0 = lanes(fields.H0);
        const auto K0 = lanes(fields.K0);
        const auto J = lanes(fields.J);
        const detail::LaneValues<Real> laplacian(
            t.bits[reach::force] != 0 ? layer_.laplace_beltrami_of_H(TileRun<Real>{&t}) : V(0));
        const Vec3<int> origin = grid_.tile_origin(t.tile) + block_.own.begin;
        for (int k = 0; k < tile_width; ++k) {
            if ((t.bits[Band::outermost] >> k & 1) == 0)
                continue;
            InterfaceCell cell;
            cell.position = {origin.x + k + 0.5, origin.y + 0.5, origin.z + 0.5};
            cell.phi = phase_of(chi[k]);
            cell.s = s[k];
            cell.n = n[k];
            cell.weight = 0.5 * setup_.layer.beta * layer_density(chi[k]);
            const std::int64_t index = t.cell + k;
            const Moments<double> m = moments_at(index);
            cell.density = setup_.reference_density + m.density_deviation;
            cell.u = velocity_of(m, setup_.reference_density, whole_force_at(index));
            if (curved && (t.bits[reach::curvature] >> k & 1) != 0) {
                cell.has_geometry = true;
                cell.H0 = H0[k];
                cell.K0 = K0[k];
                cell.J = J[k];
                cell.K = cell.K0 * cell.J;
                cell.H = setup_.layer.recipe == GeometryRecipe::mapped ? cell.H0 * cell.J + cell.s * cell.K
                                                                       : cell.H0;
                if ((t.bits[reach::force] >> k & 1) != 0) {
                    cell.bending_force = std::visit(
                        [&](const auto& law) { return law.force(force_H0[k], cell.K0, laplacian[k]); },
                        membrane_.bending);
                    cell.tension_force = TensionLaw{membrane_.tension()}.force(force_H0[k]);
                }
            }
            cell.force = force_at(index);
            cell.to_obstacle = distance_to_obstacle(cell, index);
            cells.push_back(cell);
        }
    }
    return cells;
}

/// Runs of cells that are purely inside, outside the band's own cells, as they lie in the box.
template <class Real>
std::vector<InsideSpan> LatticeEngine<Real>::inside_spans() const {
    std::vector<InsideSpan> spans;
    const std::vector<std::uint8_t> in_band = layer_.cells_of_level(Band::outermost);
    const Vec3<int> size = grid_.size();
    const Vec3<int> begin = block_.own.begin;
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y) {
            bool open = false;
            for (int x = 0; x < size.x; ++x) {
                const std::int64_t cell = grid_.index(x, y, z);
                const auto tile = static_cast<std::size_t>(cell / tile_width);
                const bool red = ((layer_.inside()[tile] & ~in_band[tile]) >> (cell % tile_width) & 1) != 0;
                if (red && open)
                    ++spans.back().count;
                else if (red)
                    spans.push_back({begin.x + x, 1, begin.y + y, begin.z + z});
                open = red;
            }
        }
    return spans;
}

/// Mass and momentum of the vesicle's colour, exact sums over every cell of the block that has some of it.
template <class Real>
ColourSums LatticeEngine<Real>::colour_sums(const std::vector<InterfaceCell>& cells,
                                            const std::vector<InsideSpan>& inside,
                                            const Unwrap& unwrap) const {
    ColourSums sums;
    const auto boxes_slid = [&](const Vec3<int>& cell) {
        return block_.slide ? unwrap.boxes_slid(cell) : 0.0;
    };
    for (const InterfaceCell& cell : cells)
        sums.add(0.5 * (1.0 + cell.phi) * cell.density, cell.u, boxes_slid(detail::cell_of(cell)));
    for (const InsideSpan& span : inside)
        for (int k = 0; k < span.count; ++k) {
            const Vec3<int> place = Vec3<int>{span.begin + k, span.y, span.z} - block_.own.begin;
            const std::int64_t cell = grid_.index(place);
            const Moments<double> m = moments_at(cell);
            sums.add(setup_.reference_density + m.density_deviation,
                     velocity_of(m, setup_.reference_density, whole_force_at(cell)),
                     boxes_slid({span.begin + k, span.y, span.z}));
        }
    return sums;
}

namespace detail {

inline Vec3<double> rest_of(const Vec3<double>& shift) {
    return {shift.x - std::floor(shift.x), shift.y - std::floor(shift.y), shift.z - std::floor(shift.z)};
}

/// In one piece: runs end where their periodic image changes, not where a block does.
inline std::vector<InsideSpan> unwrapped(const std::vector<InsideSpan>& home, const Unwrap& unwrap) {
    std::vector<InsideSpan> spans;
    Vec3<int> previous{-2, -2, -2};
    for (const InsideSpan& run : home)
        for (int k = 0; k < run.count; ++k) {
            const Vec3<int> cell{run.begin + k, run.y, run.z};
            const Vec3<double> shift = unwrap.shift(cell);
            const auto whole = [&](int axis) {
                return cell[axis] + static_cast<int>(std::floor(shift[axis]));
            };
            if (cell == previous + Vec3<int>{1, 0, 0} && spans.back().begin + spans.back().count == whole(0))
                ++spans.back().count;
            else
                spans.push_back({whole(0), 1, whole(1), whole(2), rest_of(shift)});
            previous = cell;
        }
    return spans;
}

} // namespace detail

template <class Real>
Snapshot LatticeEngine<Real>::snapshot() const {
    Snapshot snapshot;
    snapshot.step = step_;
    snapshot.reference_density = setup_.reference_density;
    snapshot.max_speed = extremes().speed.size;
    snapshot.outer_viscosity = setup_.outer_viscosity;
    snapshot.shear_rate = setup_.drive.shear_rate(step_);
    for (int a = 0; a < 3; ++a) {
        snapshot.size[a] = setup_.drive.size()[a];
        snapshot.walls[a] = setup_.drive.has_walls(a);
    }
    if (block_.slide)
        snapshot.sliding = SlidingImages{block_.slide->gradient, block_.slide->velocity,
                                         setup_.drive.displacement(step_), setup_.drive.slide_speed(step_)};
    if (solids_) {
        std::vector<WallForce> forces(FlowDrive::wall_count);
        walls_.add_forces(streaming_, forces);
        snapshot.wall_force = sums_over(ranks(), forces);
    }
    if (layer_.empty())
        return snapshot;
    VesicleSnapshot vesicle;
    vesicle.beta = setup_.layer.beta;
    vesicle.layer_moment = setup_.layer_moments.area;
    vesicle.layer = setup_.layer_moments;
    vesicle.bending_modulus = setup_.bending_modulus;
    vesicle.spontaneous_curvature = setup_.spontaneous_curvature;
    vesicle.viscosity_ratio = setup_.viscosity_ratio;
    vesicle.tension = membrane_.tension();
    vesicle.target_area = membrane_.target.at(step_);
    Vec3<int> period = block_.box;
    for (int a = 0; a < 3; ++a)
        if (setup_.drive.has_walls(a) || setup_.drive.is_open(a))
            period[a] = 0;
    const Unwrap unwrap(period, middle(), block_.slide,
                        snapshot.sliding ? snapshot.sliding->displacement : 0.0);

    std::vector<InterfaceCell> cells = layer_cells();
    std::vector<InsideSpan> inside = inside_spans();
    const ColourSums sums = colour_sums(cells, inside, unwrap).over(ranks());
    const auto in_order = [](const auto& a, const auto& b) {
        return std::tie(a.z, a.y, a.x) < std::tie(b.z, b.y, b.x);
    };
    vesicle.cells = detail::gathered_list(ranks(), std::move(cells), [&](const auto& a, const auto& b) {
        return in_order(a.position, b.position);
    });
    inside = detail::gathered_list(ranks(), std::move(inside), [](const auto& a, const auto& b) {
        return std::tie(a.z, a.y, a.begin) < std::tie(b.z, b.y, b.begin);
    });
    if (!ranks().leads())
        return snapshot;
    // Beyond sliding faces velocities are those that the images there have.
    if (snapshot.sliding)
        for (InterfaceCell& cell : vesicle.cells)
            cell.u[snapshot.sliding->velocity] +=
                unwrap.boxes_slid(detail::cell_of(cell)) * snapshot.sliding->speed;
    for (InterfaceCell& cell : vesicle.cells)
        cell.position = cell.position + unwrap.shift(detail::cell_of(cell));
    vesicle.inside = detail::unwrapped(inside, unwrap);
    vesicle.colour_mass = sums.mass.value();
    vesicle.momentum = {sums.momentum[0].value(), sums.momentum[1].value(), sums.momentum[2].value()};
    if (snapshot.sliding)
        vesicle.momentum[snapshot.sliding->velocity] += sums.slid.value() * snapshot.sliding->speed;
    snapshot.vesicles.push_back(std::move(vesicle));
    return snapshot;
}

} // namespace vesica
