#pragma once

#include "simulation/layer.hpp"

namespace vesica {

template <class Real>
void Layer<Real>::normals(int threads) {
    if (mapped()) {
        share(reach::receiving, threads, {fields_.sharp}, [&]<class Tiles>(const Tiles& t) {
            using V = typename Tiles::V;
            t.store(sharpened<V>(around(fields_.s, t), 1.0), fields_.sharp); // normals differentiate it
        });
        extend_into_solids({fields_.sharp}, reach::receiving, 1.0, threads);
    }
    const auto direct = [&]<class Tiles>(const Tiles& t) {
        using V = typename Tiles::V;
        const Vec3<V> outward = outward_gradient(t);
        const Vec3<V> n = unit_vector(outward);
        const V chi = t.load(fields_.chi);
        const V density = t.load(fields_.density);
        t.store(mapped() ? normal_of_distance(outward) : n, fields_.n);
        t.store(segregation_flux(chi, density, n, settings_.beta), fields_.w);
    };
    const std::initializer_list<std::span<Real>> found{fields_.n[0], fields_.n[1], fields_.n[2],
                                                       fields_.w[0], fields_.w[1], fields_.w[2]};
    if (shared_.empty()) {
        share(reach::colour, threads, found, direct);
    } else {
        for_tiles(reach::colour, threads, direct);
        part_shared_colours(threads);
        share(reach::colour, threads, found, [](const auto&) {});
    }
    extend_into_solids({fields_.n[0], fields_.n[1], fields_.n[2]}, reach::colour, 0.0, threads);
}

/// Where several vesicles have a share of a cell, each pair of colours parts along a direction of its own,
/// and what one gives the other takes (colour/recolouring.hpp).
template <class Real>
void Layer<Real>::part_shared_colours(int threads) {
    using V = Pack<Real>;
    for_each_index(shared_.count(), threads, [&](std::int64_t index) {
        const SharedTiles::Range& range = shared_.range(index);
        const auto tile_of = [&](std::int32_t k) {
            const std::int32_t tile = shared_.colour(k).tile;
            return tile < 0 ? nullptr : band_.tiles().data() + tile;
        };
        for (std::int32_t k = range.begin; k < range.end; ++k) {
            if (tile_of(k) == nullptr || tile_of(k)->bits[reach::colour] == 0)
                continue;
            const TileRun<Real> own{tile_of(k)};
            // None on a kink of the distance, where a cell is pure enough for what parts it to be next to
            // nothing.
            const Vec3<V> n = own.load(fields_.n);
            V others = V(0);
            Vec3<V> parted{V(0), V(0), V(0)};
            for (std::int32_t other = range.begin; other < range.end; ++other) {
                if (other == k || tile_of(other) == nullptr || tile_of(other)->bits[reach::colour] == 0)
                    continue;
                const TileRun<Real> beside{tile_of(other)};
                const V red = select<Real>(beside.cells_of(reach::colour),
                                           red_fraction(beside.load(fields_.chi)), V(0));
                others += red;
                const Vec3<V> share = red * direction_between(n, beside.load(fields_.n));
                const auto is_there = red > V(0); // a normal means nothing elsewhere
                for (int a = 0; a < 3; ++a)
                    parted[a] += select<Real>(is_there, share[a], V(0));
            }
            const V chi = own.load(fields_.chi);
            const V rest = larger(blue_fraction(chi) - others, V(0));
            const V strength = V(settings_.beta) * own.load(fields_.density) * red_fraction(chi);
            const Vec3<V> flux = strength * (rest * n + parted);
            const auto meets = (others > V(0)) & own.cells_of(reach::colour);
            const Vec3<V> alone = own.load(fields_.w);
            own.store({select<Real>(meets, flux.x, alone.x), select<Real>(meets, flux.y, alone.y),
                       select<Real>(meets, flux.z, alone.z)},
                      fields_.w);
        }
    });
}

template <class Real>
void Layer<Real>::curvatures(int threads) {
    gaussian_sums_.reset(threads, labels());
    square_sums_.reset(threads, labels());
    const auto bend = [&]<class Tiles>(const Tiles& t, std::size_t, int thread) {
        using V = typename Tiles::V;
        const Vec3<V> n = t.load(fields_.n);
        const V s = t.load(fields_.s);
        const Curvatures<V> here = mapped() ? curvatures_of(jacobian_of_normals(around(fields_.n, t), n), n)
                                            : paper_curvatures_of(jacobian<V>(around(fields_.n, t)), n);
        const Curvatures<V> surface = mapped() ? map_to_mid_surface(here, s) : here;
        t.store(surface.H, fields_.raw_H0);
        t.store(surface.K, fields_.K0);
        t.store(mapped() ? area_to_mid_surface(here, s) : V(1), fields_.J);
        const V weight = V(0.5 * settings_.beta) * layer_density(t.load(fields_.chi));
        const auto counted = t.cells_of(reach::raw_curvature);
        gaussian_sums_.of(thread, t.label()).add(select<Real>(counted, weight * here.K, V(0)));
        square_sums_.of(thread, t.label()).add(select<Real>(counted, weight * here.H * here.H, V(0)));
    };
    share(reach::raw_curvature, threads, {fields_.raw_H0}, bend);
    extend_into_solids({fields_.raw_H0}, reach::raw_curvature, 0.0, threads);
    set_integrals();
    if (!mapped())
        return;
    share(reach::curvature, threads, {fields_.sharp}, [&]<class Tiles>(const Tiles& t) {
        using V = typename Tiles::V;
        // The derivative that made H of n, and the two that make Lap_s H of H.
        t.store(sharpened<V>(around(fields_.raw_H0, t), 3.0), fields_.sharp);
    });
    extend_into_solids({fields_.sharp}, reach::curvature, 0.0, threads);
}

template <class Real>
void Layer<Real>::set_integrals() {
    over_ranks_(
        ranks(), labels(),
        [&](int label, const std::array<double, 5>& values) {
            const auto [area, gaussian_curvature, square_mean_curvature, red, inside] = values;
            sums_[at(label)] = {area, gaussian_curvature, square_mean_curvature, red + inside};
        },
        area_sums_, gaussian_sums_, square_sums_, red_sums_, plain_red_);
}

template <class Real>
void Layer<Real>::slopes(int threads) {
    const auto slope = [&]<class Tiles>(const Tiles& t) {
        using V = typename Tiles::V;
        if (!mapped()) {
            t.store(gradient<V>(around(fields_.raw_H0, t)), fields_.g);
            return;
        }
        const Vec3<V> n = t.load(fields_.n);
        const Vec3<V> g = tangential(gradient<V>(around(fields_.sharp, t)), n);
        const V s = t.load(fields_.s);
        const V J = t.load(fields_.J);
        // The cell's own H, from H0 = (H - s K)/J and K0 = K/J.
        const V H = J * fma(s, t.load(fields_.K0), t.load(fields_.raw_H0));
        t.store(flux_on_mid_surface(g, jacobian<V>(around(fields_.n, t)), n, s, H, J), fields_.g);
    };
    share(reach::slope, threads, {fields_.g[0], fields_.g[1], fields_.g[2]}, slope);
    extend_into_solids({fields_.g[0], fields_.g[1], fields_.g[2]}, reach::slope, 0.0, threads);
}

} // namespace vesica
