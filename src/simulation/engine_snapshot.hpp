#pragma once

#include "core/exact_sum.hpp"
#include "simulation/lattice_engine.hpp"

#include <cmath>

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

} // namespace detail

/// A point near the vesicle's middle: the circular mean of the layer's cells, so that periodic images do not
/// matter.
template <class Real>
Vec3<double> LatticeEngine<Real>::middle() const {
    const double turn[3] = {2 * pi / grid_.size().x, 2 * pi / grid_.size().y, 2 * pi / grid_.size().z};
    double sine[3] = {};
    double cosine[3] = {};
    for (const BandTile& t : layer_.band().tiles()) {
        if (t.bits[0] == 0)
            continue;
        const Vec3<int> origin = grid_.tile_origin(t.tile);
        const Vec3<double> x{origin.x + 0.5 * tile_width, origin.y + 0.5, origin.z + 0.5};
        for (int a = 0; a < 3; ++a) {
            sine[a] += std::sin(turn[a] * x[a]);
            cosine[a] += std::cos(turn[a] * x[a]);
        }
    }
    Vec3<double> middle;
    for (int a = 0; a < 3; ++a) {
        const double angle = std::atan2(sine[a], cosine[a]);
        middle[a] = (angle < 0.0 ? angle + 2 * pi : angle) / turn[a];
    }
    return middle;
}

template <class Real>
void LatticeEngine<Real>::add_layer_cells(const Unwrap& unwrap, VesicleSnapshot& vesicle) const {
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
        const Vec3<int> origin = grid_.tile_origin(t.tile);
        for (int k = 0; k < tile_width; ++k) {
            if ((t.bits[Band::outermost] >> k & 1) == 0)
                continue;
            InterfaceCell cell;
            const int x = origin.x + k;
            cell.position = {x + 0.5 + unwrap.shift(0, x), origin.y + 0.5 + unwrap.shift(1, origin.y),
                             origin.z + 0.5 + unwrap.shift(2, origin.z)};
            cell.phi = phase_of(chi[k]);
            cell.s = s[k];
            cell.n = n[k];
            cell.weight = 0.5 * setup_.layer.beta * layer_density(chi[k]);
            const std::int64_t index = t.cell + k;
            const Moments<double> m = moments_at(index);
            cell.density = setup_.reference_density + m.density_deviation;
            cell.u = velocity_of(m, setup_.reference_density, force_at(index));
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
            vesicle.cells.push_back(cell);
        }
    }
}

/// Runs of cells that are purely inside, outside the band's own cells; a run ends where its periodic image
/// changes.
template <class Real>
void LatticeEngine<Real>::add_inside(const Unwrap& unwrap, VesicleSnapshot& vesicle) const {
    const std::vector<std::uint8_t> in_band = layer_.cells_of_level(Band::outermost);
    const Vec3<int> size = grid_.size();
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y) {
            const int shift_y = unwrap.shift(1, y);
            const int shift_z = unwrap.shift(2, z);
            bool open = false;
            for (int x = 0; x < size.x; ++x) {
                const std::int64_t cell = grid_.index(x, y, z);
                const auto tile = static_cast<std::size_t>(cell / tile_width);
                const int k = static_cast<int>(cell % tile_width);
                const bool red = ((layer_.inside()[tile] & ~in_band[tile]) >> k & 1) != 0;
                const int begin = x + unwrap.shift(0, x);
                if (red && open && vesicle.inside.back().begin + vesicle.inside.back().count == begin)
                    ++vesicle.inside.back().count;
                else if (red)
                    vesicle.inside.push_back({begin, 1, y + shift_y, z + shift_z});
                open = red;
            }
        }
}

/// Mass and momentum of the vesicle's colour, exact sums over every cell that has some of it.
template <class Real>
void LatticeEngine<Real>::add_colour_sums(VesicleSnapshot& vesicle) const {
    ExactSum mass;
    ExactSum momentum[3];
    const auto add = [&](double rho, const Vec3<double>& u) {
        mass.add(rho);
        for (int a = 0; a < 3; ++a)
            momentum[a].add(rho * u[a]);
    };
    for (const InterfaceCell& cell : vesicle.cells)
        add(0.5 * (1.0 + cell.phi) * cell.density, cell.u);
    const Vec3<int> size = grid_.size();
    const auto home = [](int x, int n) {
        return ((x % n) + n) % n;
    };
    for (const InsideSpan& span : vesicle.inside)
        for (int k = 0; k < span.count; ++k) {
            const std::int64_t cell =
                grid_.index(home(span.begin + k, size.x), home(span.y, size.y), home(span.z, size.z));
            const Moments<double> m = moments_at(cell);
            add(setup_.reference_density + m.density_deviation,
                velocity_of(m, setup_.reference_density, force_at(cell)));
        }
    vesicle.colour_mass = mass.value();
    vesicle.momentum = {momentum[0].value(), momentum[1].value(), momentum[2].value()};
}

template <class Real>
Snapshot LatticeEngine<Real>::snapshot() const {
    Snapshot snapshot;
    snapshot.step = step_;
    snapshot.reference_density = setup_.reference_density;
    snapshot.max_speed = extremes().speed.size;
    if (layer_.empty())
        return snapshot;
    VesicleSnapshot vesicle;
    vesicle.beta = setup_.layer.beta;
    vesicle.layer_moment = setup_.layer_moments.area;
    vesicle.layer = setup_.layer_moments;
    vesicle.bending_modulus = setup_.bending_modulus;
    vesicle.spontaneous_curvature = setup_.spontaneous_curvature;
    vesicle.tension = membrane_.tension();
    vesicle.target_area = membrane_.target.at(step_);
    const Unwrap unwrap(grid_.size(), middle());
    add_layer_cells(unwrap, vesicle);
    add_inside(unwrap, vesicle);
    add_colour_sums(vesicle);
    snapshot.vesicles.push_back(std::move(vesicle));
    return snapshot;
}

} // namespace vesica
