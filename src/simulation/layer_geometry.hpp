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
        const Vec3<V> n = unit_vector(outward_gradient(t));
        const V chi = t.load(fields_.chi);
        const V density = t.load(fields_.density);
        t.store(n, fields_.n);
        t.store(segregation_flux(chi, density, n, settings_.beta), fields_.w);
    };
    share(reach::colour, threads,
          {fields_.n[0], fields_.n[1], fields_.n[2], fields_.w[0], fields_.w[1], fields_.w[2]}, direct);
    extend_into_solids({fields_.n[0], fields_.n[1], fields_.n[2]}, reach::colour, 0.0, threads);
}

template <class Real>
void Layer<Real>::curvatures(int threads) {
    std::vector<LaneSum<38>> gaussian(static_cast<std::size_t>(threads));
    std::vector<LaneSum<38>> square(static_cast<std::size_t>(threads));
    const auto bend = [&]<class Tiles>(const Tiles& t, std::size_t, int thread) {
        using V = typename Tiles::V;
        const Vec3<V> n = t.load(fields_.n);
        const Jacobian<V> G = jacobian<V>(around(fields_.n, t));
        const V s = t.load(fields_.s);
        const Curvatures<V> here = mapped() ? curvatures_of(G, n) : paper_curvatures_of(G, n);
        const Curvatures<V> surface = mapped() ? map_to_mid_surface(here, s) : here;
        t.store(surface.H, fields_.raw_H0);
        if (!mapped())
            t.store(surface.H, fields_.H0);
        t.store(surface.K, fields_.K0);
        t.store(mapped() ? area_to_mid_surface(here, s) : V(1), fields_.J);
        const V weight = V(0.5 * settings_.beta) * layer_density(t.load(fields_.chi));
        const auto counted = t.cells_of(reach::raw_curvature);
        gaussian[at(thread)].add(select<Real>(counted, weight * here.K, V(0)));
        square[at(thread)].add(select<Real>(counted, weight * here.H * here.H, V(0)));
    };
    share(reach::raw_curvature, threads, {fields_.raw_H0}, bend);
    extend_into_solids({fields_.raw_H0}, reach::raw_curvature, 0.0, threads);
    set_integrals(merged(gaussian), merged(square));
    if (!mapped())
        return;
    share(reach::curvature, threads, {fields_.sharp}, [&]<class Tiles>(const Tiles& t) {
        using V = typename Tiles::V;
        const auto H = around(fields_.raw_H0, t);
        t.store(sharpened<V>(H, 1.0), fields_.H0);    // the derivative that made H of n
        t.store(sharpened<V>(H, 3.0), fields_.sharp); // and the two that make Lap_s H of H
    });
    extend_into_solids({fields_.sharp}, reach::curvature, 0.0, threads);
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
        t.store(flux_on_mid_surface(g, jacobian<V>(around(fields_.n, t)), n, s, J), fields_.g);
    };
    share(reach::slope, threads, {fields_.g[0], fields_.g[1], fields_.g[2]}, slope);
    extend_into_solids({fields_.g[0], fields_.g[1], fields_.g[2]}, reach::slope, 0.0, threads);
}

} // namespace vesica
