#pragma once

#include "simulation/layer.hpp"

namespace vesica {

template <class Real>
void Layer<Real>::forces(const Membrane& membrane, int threads) {
    std::visit([&](const auto& bending) { forces_of(bending, TensionLaw{membrane.tension()}, threads); },
               membrane.bending);
}

template <class Real>
template <class Bending>
void Layer<Real>::forces_of(const Bending& bending, const TensionLaw& tension, int threads) {
    const FieldView<Real> force = force_.view();
    for_tiles(reach::force, threads, [&]<class Tiles>(const Tiles& t) {
        using V = typename Tiles::V;
        const V H = t.load(fields_.H0);
        const V K = t.load(fields_.K0);
        const V normal_force = bending.force(H, K, laplace_beltrami_of_H(t)) + tension.force(H);
        const Vec3<V> slope = gradient<V>(around(fields_.psi, t));
        Vec3<V> F = spread_force_(slope, normal_force);
        if (solids_ != nullptr && t.beside_solid())
            F = F + wetting_force(t);
        const auto here = t.cells_of(reach::force);
        select<Real>(here, F.x, V(0)).store(force.component(0) + t.slot());
        select<Real>(here, F.y, V(0)).store(force.component(1) + t.slot());
        select<Real>(here, F.z, V(0)).store(force.component(2) + t.slot());
    });
}

/// Solids repel what is inside, or attract it: a force on red in the cells beside them, along the mean of
/// the links that lead there (of length 1 at a flat wall).
template <class Real>
template <class Tiles>
Vec3<typename Tiles::V> Layer<Real>::wetting_force(const Tiles& t) const {
    using V = typename Tiles::V;
    Vec3<V> towards{V(0), V(0), V(0)};
    for (int i = 1; i < direction_count; ++i) {
        const auto solid = V::mask(solids_->beside_tiles(t.cell() / tile_width, Tiles::count, i));
        const V share = select<Real>(solid, V(6.0 * weight(i)), V(0));
        for (int a = 0; a < 3; ++a)
            towards[a] += V(velocity(i, a)) * share;
    }
    const V strength = V(settings_.wetting) * t.load(fields_.red);
    return {strength * towards.x, strength * towards.y, strength * towards.z};
}

} // namespace vesica
