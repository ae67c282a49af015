#pragma once

#include "simulation/engine_middles.hpp"

#include <algorithm>
#include <cmath>
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

} // namespace detail

template <class Real>
struct LatticeEngine<Real>::LayerCell {
    int label = 0;
    InterfaceCell cell;
};

template <class Real>
struct LatticeEngine<Real>::LabelledSpan {
    int label = 0;
    InsideSpan span;
};

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
std::vector<typename LatticeEngine<Real>::LayerCell>
LatticeEngine<Real>::layer_cells(const LabelRange& labels) const {
    std::vector<LayerCell> cells;
    const LayerFields<Real>& fields = layer_.fields();
    const double beta = setup_.layer.beta;
    constexpr double profile_reach = 8.0; // farther out colours need not have their profile yet
    for (const BandTile& t : layer_.band().tiles()) {
        if (!labels.has(t.label))
            continue;
        const auto lanes = [&](const std::span<Real>& a) {
            return detail::LaneValues<Real>(V::load(a.data() + t.slot()));
        };
        const auto chi = lanes(fields.chi);
        const auto s = lanes(fields.s);
        const detail::LaneVectors<Real> n(TileRun<Real>{&t}.load(fields.n));
        const bool curved = t.bits[reach::curvature] != 0;
        const auto H0 = lanes(fields.raw_H0); // sharpening, which Lap_s H needs, adds noise to H itself
        const detail::LaneValues<Real> force_H0(
            t.bits[reach::force] != 0 ? layer_.mean_curvature(TileRun<Real>{&t}) : V(0));
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
                    const Membrane& membrane = membranes_[static_cast<std::size_t>(t.label)];
                    cell.bending_force = std::visit(
                        [&](const auto& law) { return law.force(force_H0[k], cell.K0, laplacian[k]); },
                        membrane.bending);
                    cell.tension_force = TensionLaw{membrane.sigma}.force(force_H0[k]);
                    cell.area_force = TensionLaw{membrane.constraint_tension}.force(force_H0[k]);
                }
            }
            if ((t.bits[reach::force] >> k & 1) != 0)
                for (int a = 0; a < 3; ++a)
                    cell.force[a] =
                        static_cast<double>(layer_.force().view().component(a)[layer_.force_slot(t) + k]);
            cell.to_obstacle = distance_to_obstacle(cell, index);
            layer_.for_each_colour(index, fields.chi, [&](int label, Real other) {
                const double distance = signed_distance_of(static_cast<double>(other), 1e-8, beta);
                const bool is_near = std::max(std::abs(cell.s), std::abs(distance)) < profile_reach;
                if (label != t.label && is_near)
                    cell.to_vesicle = std::min(cell.to_vesicle, cell.s + distance);
            });
            cells.push_back({t.label, cell});
        }
    }
    return cells;
}

/// Runs of cells that are purely inside, outside their vesicle's band, as they lie in the box.
template <class Real>
std::vector<typename LatticeEngine<Real>::LabelledSpan>
LatticeEngine<Real>::inside_spans(const LabelRange& labels) const {
    std::vector<LabelledSpan> spans;
    const Vec3<int> size = grid_.size();
    const Vec3<int> begin = block_.own.begin;
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y) {
            int open = -1;
            for (int x = 0; x < size.x; ++x) {
                int owner = layer_.empty() ? -1 : layer_.owner_beyond_band(grid_.index(x, y, z));
                if (!labels.has(owner))
                    owner = -1;
                if (owner >= 0 && owner == open)
                    ++spans.back().span.count;
                else if (owner >= 0)
                    spans.push_back({owner, {begin.x + x, 1, begin.y + y, begin.z + z, {}}});
                open = owner;
            }
        }
    return spans;
}

/// Mass and momentum of the vesicles' colours, exact sums over every cell of the block that has some of them.
template <class Real>
std::vector<ColourSums> LatticeEngine<Real>::colour_sums(const std::vector<LayerCell>& cells,
                                                         const std::vector<LabelledSpan>& inside,
                                                         const std::vector<Unwrap>& unwraps) const {
    std::vector<ColourSums> sums(membranes_.size());
    const auto boxes_slid = [&](std::size_t label, const Vec3<int>& cell) {
        return block_.slide ? unwraps[label].boxes_slid(cell) : 0.0;
    };
    for (const auto& [label, cell] : cells) {
        const auto of = static_cast<std::size_t>(label);
        sums[of].add(0.5 * (1.0 + cell.phi) * cell.density, cell.u, boxes_slid(of, detail::cell_of(cell)));
    }
    for (const auto& [label, span] : inside)
        for (int k = 0; k < span.count; ++k) {
            const auto of = static_cast<std::size_t>(label);
            const Vec3<int> place = Vec3<int>{span.begin + k, span.y, span.z} - block_.own.begin;
            const std::int64_t cell = grid_.index(place);
            const Moments<double> m = moments_at(cell);
            sums[of].add(setup_.reference_density + m.density_deviation,
                         velocity_of(m, setup_.reference_density, whole_force_at(cell)),
                         boxes_slid(of, {span.begin + k, span.y, span.z}));
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

/// What is known of a vesicle without looking at cells.
template <class Real>
VesicleSnapshot LatticeEngine<Real>::described(std::size_t label) const {
    const VesicleSetup& setup = setup_.vesicles[label];
    VesicleSnapshot vesicle;
    vesicle.beta = setup_.layer.beta;
    vesicle.layer_moment = setup_.layer_moments.area;
    vesicle.layer = setup_.layer_moments;
    vesicle.bending_modulus = setup.bending_modulus;
    vesicle.spontaneous_curvature = setup.spontaneous_curvature;
    vesicle.viscosity_ratio = setup.viscosity_ratio;
    vesicle.tension = membranes_[label].tension();
    vesicle.target_area = membranes_[label].target.at(step_);
    return vesicle;
}

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
    snapshot.sliding = sliding_images();
    if (solids_) {
        std::vector<WallForce> forces(FlowDrive::wall_count);
        walls_.add_forces(streaming_, forces);
        snapshot.wall_force = sums_over(ranks(), forces);
    }
    snapshot.vesicles = vesicles(0, static_cast<int>(membranes_.size()));
    return snapshot;
}

template <class Real>
std::optional<SlidingImages> LatticeEngine<Real>::sliding_images() const {
    if (!block_.slide)
        return std::nullopt;
    return SlidingImages{block_.slide->gradient, block_.slide->velocity, setup_.drive.displacement(step_),
                         setup_.drive.slide_speed(step_)};
}

/// All ranks look at the cells that they have, and the one that leads puts the vesicles together.
template <class Real>
std::vector<VesicleSnapshot> LatticeEngine<Real>::vesicles(int first, int count) const {
    const LabelRange labels{first, first + count};
    const std::optional<SlidingImages> sliding = sliding_images();
    std::vector<VesicleSnapshot> found;
    if (layer_.empty() || count == 0)
        return found;
    Vec3<int> period = block_.box;
    for (int a = 0; a < 3; ++a)
        if (setup_.drive.has_walls(a) || setup_.drive.is_open(a))
            period[a] = 0;
    std::vector<Unwrap> unwraps;
    for (const Vec3<double>& middle : middles())
        unwraps.emplace_back(period, middle, block_.slide, sliding ? sliding->displacement : 0.0);

    std::vector<LayerCell> cells = layer_cells(labels);
    std::vector<LabelledSpan> inside = inside_spans(labels);
    const std::vector<ColourSums> sums = over_ranks(ranks(), colour_sums(cells, inside, unwraps));
    const auto place_of = [](const LayerCell& c) {
        return std::tie(c.cell.position.z, c.cell.position.y, c.cell.position.x, c.label);
    };
    cells = detail::gathered_list(ranks(), std::move(cells), [&](const LayerCell& a, const LayerCell& b) {
        return place_of(a) < place_of(b);
    });
    inside = detail::gathered_list(ranks(), std::move(inside), [](const auto& a, const auto& b) {
        return std::tie(a.span.z, a.span.y, a.span.begin) < std::tie(b.span.z, b.span.y, b.span.begin);
    });
    if (!ranks().leads())
        return found;
    std::vector<std::vector<InsideSpan>> spans(static_cast<std::size_t>(count));
    for (const auto& [label, span] : inside)
        spans[static_cast<std::size_t>(label - first)].push_back(span);
    for (int label = first; label < labels.end; ++label) {
        const auto of = static_cast<std::size_t>(label);
        VesicleSnapshot& vesicle = found.emplace_back(described(of));
        vesicle.inside = detail::unwrapped(spans[of - static_cast<std::size_t>(first)], unwraps[of]);
        vesicle.colour_mass = sums[of].mass.value();
        for (int a = 0; a < 3; ++a)
            vesicle.momentum[a] = sums[of].momentum[a].value();
        if (sliding)
            vesicle.momentum[sliding->velocity] += sums[of].slid.value() * sliding->speed;
    }
    for (auto& [label, cell] : cells) {
        const Unwrap& unwrap = unwraps[static_cast<std::size_t>(label)];
        const Vec3<int> home = detail::cell_of(cell);
        // Beyond sliding faces velocities are those that the images there have.
        if (sliding)
            cell.u[sliding->velocity] += unwrap.boxes_slid(home) * sliding->speed;
        cell.position = cell.position + unwrap.shift(home);
        found[static_cast<std::size_t>(label - first)].cells.push_back(cell);
    }
    return found;
}

} // namespace vesica
