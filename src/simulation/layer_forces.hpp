#pragma once

#include "simulation/layer.hpp"

namespace vesica {

template <class Real>
void Layer<Real>::forces(std::span<const Membrane> membranes, int threads) {
    std::visit([&]<class Bending>(const Bending&) { forces_of<Bending>(membranes, threads); },
               membranes.front().bending);
    // Where several push, their sum; in the order of labels.
    const FieldView<Real> force = force_.view();
    for_each_index(static_cast<std::int64_t>(shared_.forces().size()), threads, [&](std::int64_t index) {
        using V = Pack<Real>;
        const SharedTiles::Force& sum = shared_.forces()[at(index)];
        for (int a = 0; a < 3; ++a) {
            V total = V(0);
            for (std::int32_t k = sum.begin; k < sum.end; ++k)
                total += V::load(force.component(a) + shared_.force_slot(k));
            total.store(force.component(a) + sum.slot);
        }
    });
}

template <class Real>
template <class Bending>
void Layer<Real>::forces_of(std::span<const Membrane> membranes, int threads) {
    const FieldView<Real> force = force_.view();
    for_tiles(reach::force, threads, [&]<class Tiles>(const Tiles& t, std::size_t index, int) {
        using V = typename Tiles::V;
        const Membrane& membrane = membranes[at(t.label())];
        const Bending& bending = *std::get_if<Bending>(&membrane.bending);
        const TensionLaw tension{membrane.tension()};
        const V H = mean_curvature(t);
        const V K = t.load(fields_.K0);
        const V normal_force = bending.force(H, K, laplace_beltrami_of_H(t)) + tension.force(H);
        const Vec3<V> slope =
            gradient<V>(ProfileAround<Real, V::width>{spread_force_, around(fields_.chi, t)});
        Vec3<V> F = spread_force_(slope, normal_force);
        if (solids_ != nullptr && t.beside_solid())
            F = F + wetting_force(t);
        const auto here = t.cells_of(reach::force);
        const std::int32_t slot = own_force_slots_[index];
        select<Real>(here, F.x, V(0)).store(force.component(0) + slot);
        select<Real>(here, F.y, V(0)).store(force.component(1) + slot);
        select<Real>(here, F.z, V(0)).store(force.component(2) + slot);
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
    const V strength = V(settings_.wetting) * red_fraction(t.load(fields_.chi));
    return {strength * towards.x, strength * towards.y, strength * towards.z};
}

} // namespace vesica
