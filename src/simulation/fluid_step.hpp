#pragma once

#include "boundary/periodic.hpp"
#include "collision/regularised.hpp"
#include "colour/phase.hpp"
#include "lattice/band.hpp"
#include "lattice/populations.hpp"
#include "parallel/for_each.hpp"
#include "parallel/pack.hpp"
#include "simulation/engine_setup.hpp"

namespace vesica {

/// What the fluid feels of the membranes: forces in the band's compact arrays, and colours where viscosities
/// differ.
template <class Real>
struct LayerInfluence {
    const std::int32_t* force_slot =
        nullptr; ///< per tile: compact address of its forces, -1 where there are none
    FieldView<const Real> force;
    bool contrast = false; ///< inner and outer viscosity differ
    const std::int32_t* colour_slot = nullptr;
    const Real* chi = nullptr;
    const std::uint8_t* inside = nullptr; ///< per tile: bit k set where cell k, outside the band, is red
};

/// lambda between two fluids, from 1/nu linear in the colour's fraction: a layer sheared along itself (equal
/// stress, velocities adding up) is then exact.
template <class V>
[[gnu::always_inline]] inline V rate_between(const StressRates& rates, const V& red) {
    const double outer_excess = 1.0 / rates.outer - 0.5;
    const double inner_excess = 1.0 / rates.inner - 0.5;
    const V inverse_excess = fma(red, V(1.0 / inner_excess - 1.0 / outer_excess), V(1.0 / outer_excess));
    return V(1) / (V(0.5) + V(1) / inverse_excess);
}

/// Collides every cell and streams it, in place, in one pass over the box.
template <class Real, class Collision>
class FluidStep {
public:
    using V = Pack<Real>;

    FluidStep() = default;
    FluidStep(const Grid& grid, const PopulationView<Real>& f, const Collision& collision,
              const StressRates& rates, double reference_density)
        : grid_(grid),
          f_(f),
          boundary_(f, grid),
          collision_(collision),
          rates_(rates),
          rho0_(reference_density) {}

    void operator()(Streaming streaming, const LayerInfluence<Real>& layer, int threads) const {
        if (streaming == Streaming::arrived)
            step<Streaming::arrived>(layer, threads);
        else
            step<Streaming::turned>(layer, threads);
    }

private:
    template <Streaming streaming>
    void step(const LayerInfluence<Real>& layer, int threads) const {
        const Vec3<int> size = grid_.size();
        const std::int64_t rows = std::int64_t{size.y} * size.z;
        for_each_index(rows, threads, [&](std::int64_t k) {
            const int y = static_cast<int>(k % size.y);
            const int z = static_cast<int>(k / size.y);
            step_row<streaming>(grid_.index(0, y, z), layer);
            if constexpr (streaming == Streaming::arrived)
                boundary_.publish_row(y, z);
        });
        if constexpr (streaming == Streaming::arrived) {
            for_each_index(size.z, threads,
                           [&](std::int64_t z) { boundary_.publish_y(static_cast<int>(z)); });
            for_each_index(size.y + 2, threads,
                           [&](std::int64_t y) { boundary_.publish_z(static_cast<int>(y) - 1); });
        } else {
            for_each_index(size.y + 2, threads,
                           [&](std::int64_t y) { boundary_.collect_z(static_cast<int>(y) - 1); });
            for_each_index(size.z, threads,
                           [&](std::int64_t z) { boundary_.collect_y(static_cast<int>(z)); });
            for_each_index(rows, threads, [&](std::int64_t k) {
                boundary_.collect_row(static_cast<int>(k % size.y), static_cast<int>(k / size.y));
            });
        }
    }

    /// The default collision has a text of its own for cells without a force; for the others one text is
    /// enough.
    static constexpr bool without_force_is_faster = std::is_same_v<Collision, RegularisedCollision>;

    template <Streaming streaming>
    void step_row(std::int64_t first, const LayerInfluence<Real>& layer) const {
        for (int x = 0; x < grid_.size().x; x += tile_width) {
            const std::int64_t cell = first + x;
            const std::int64_t tile = cell / tile_width;
            const V rate = layer.contrast ? local_rate(tile, layer) : V(rates_.outer);
            const std::int32_t slot = layer.force_slot != nullptr ? layer.force_slot[tile] : -1;
            if (without_force_is_faster && slot < 0) {
                collide<streaming>(cell, Vec3<V>{V(0), V(0), V(0)}, rate);
                continue;
            }
            Vec3<V> F{V(0), V(0), V(0)};
            if (slot >= 0)
                F = {V::load(layer.force.component(0) + slot), V::load(layer.force.component(1) + slot),
                     V::load(layer.force.component(2) + slot)};
            collide<streaming>(cell, F, rate);
        }
    }

    V local_rate(std::int64_t tile, const LayerInfluence<Real>& layer) const {
        const std::int32_t slot = layer.colour_slot[tile];
        if (slot >= 0)
            return rate_between(rates_, red_fraction(V::load(layer.chi + slot)));
        return select<Real>(V::mask(layer.inside[tile]), V(rates_.inner), V(rates_.outer));
    }

    template <Streaming streaming>
    VESICA_INLINE void collide(std::int64_t cell, const Vec3<V>& F, const V& rate) const {
        V g[direction_count];
        for_each_direction([&](auto i) VESICA_INLINE_LAMBDA {
            g[i] = V::load(f_.template arriving<streaming, decltype(i)::value>(cell));
        });
        collision_(g, F, rate, V(rho0_));
        for_each_direction([&](auto i) VESICA_INLINE_LAMBDA {
            g[i].store(f_.template departing<streaming, decltype(i)::value>(cell));
        });
    }

    Grid grid_;
    PopulationView<Real> f_;
    PeriodicBoundary<Real> boundary_;
    Collision collision_;
    StressRates rates_;
    double rho0_ = 1.0;
};

} // namespace vesica
