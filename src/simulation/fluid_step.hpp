#pragma once

#include "boundary/periodic.hpp"
#include "lattice/band.hpp"
#include "lattice/populations.hpp"
#include "parallel/for_each.hpp"
#include "parallel/pack.hpp"
#include "simulation/engine_setup.hpp"
#include "simulation/row_schedule.hpp"

#include <algorithm>

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
    const Real* red = nullptr;            ///< rho_R/rho there, before streaming: a step does not write it
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

/// Collides every cell and streams it, in place, in one pass over the box. Whoever needs the populations of
/// the new state is told, row by row, as soon as they have settled: settled(thread, first row, last row).
template <class Real, class Collision>
class FluidStep {
public:
    FluidStep() = default;
    FluidStep(const Grid& grid, const PopulationView<Real>& f, const Collision& collision,
              const StressRates& rates, double reference_density)
        : grid_(grid),
          f_(f),
          boundary_(f, grid),
          collision_(collision),
          rates_(rates),
          rho0_(reference_density) {}

    template <class Settled>
    void operator()(Streaming streaming, const LayerInfluence<Real>& layer, int threads,
                    const Settled& settled) const {
        if (streaming == Streaming::arrived)
            step<Streaming::arrived>(layer, threads, settled);
        else
            step<Streaming::turned>(layer, threads, settled);
    }

private:
    template <Streaming streaming, class Settled>
    void step(const LayerInfluence<Real>& layer, int threads, const Settled& settled) const {
        const Vec3<int> size = grid_.size();
        const RowSchedule schedule(size, layer.force_slot != nullptr ? rows_in_cache() : size.y);
        for_each_block(schedule.rows(), threads, [&](int thread, std::int64_t begin, std::int64_t end) {
            schedule.in_turn(
                begin, end,
                [&](std::int64_t row, std::int64_t next) {
                    step_row<streaming>(first_cell(row), first_cell(next), layer);
                    if constexpr (streaming == Streaming::arrived)
                        boundary_.publish_row(y_of(row), z_of(row));
                },
                [&](std::int64_t first, std::int64_t last) {
                    if constexpr (streaming == Streaming::turned)
                        collect_rows(first, last);
                    settled(thread, first, last);
                });
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
        }
        for_each_block(schedule.rows(), threads, [&](int thread, std::int64_t begin, std::int64_t end) {
            schedule.left_over(begin, end, [&](std::int64_t first, std::int64_t last) {
                if constexpr (streaming == Streaming::turned)
                    collect_rows(first, last);
                settled(thread, first, last);
            });
        });
    }

    int y_of(std::int64_t row) const { return static_cast<int>(row % grid_.size().y); }
    int z_of(std::int64_t row) const { return static_cast<int>(row / grid_.size().y); }
    std::int64_t first_cell(std::int64_t row) const { return grid_.index(0, y_of(row), z_of(row)); }

    void collect_rows(std::int64_t first, std::int64_t last) const {
        for (std::int64_t row = first; row < last; ++row)
            boundary_.collect_row(y_of(row), z_of(row));
    }

    /// Rows of which three planes fit in a core's second-level cache, of a megabyte or two these days.
    int rows_in_cache() const {
        constexpr std::int64_t cache = 1'000'000;
        const std::int64_t row_bytes =
            std::int64_t{direction_count} * grid_.row_stride() * std::int64_t{sizeof(Real)};
        return static_cast<int>(std::max<std::int64_t>(cache / (3 * row_bytes), 4));
    }

    /// As many tiles at once as fill a register.
    template <Streaming streaming>
    void step_row(std::int64_t first, std::int64_t next_first, const LayerInfluence<Real>& layer) const {
        constexpr int most = tiles_per_register<Real>;
        for (int x = 0; x < grid_.size().x;) {
            if constexpr (most > 1)
                if (x + most * tile_width <= grid_.size().x &&
                    side_by_side<most>((first + x) / tile_width, layer)) {
                    step_tiles<streaming, Pack<Real, most * tile_width>>(first + x, next_first + x, layer);
                    x += most * tile_width;
                    continue;
                }
            step_tiles<streaming, Pack<Real>>(first + x, next_first + x, layer);
            x += tile_width;
        }
    }

    /// Whether what the layer tells of these tiles can be read as one.
    template <int count>
    static bool side_by_side(std::int64_t tile, const LayerInfluence<Real>& layer) {
        const auto follow = [&](const std::int32_t* slot) {
            for (int k = 1; k < count; ++k)
                if (slot[tile + k] != (slot[tile] < 0 ? -1 : slot[tile] + k * tile_width))
                    return false;
            return true;
        };
        return layer.force_slot == nullptr ||
               (follow(layer.force_slot) && (!layer.contrast || follow(layer.colour_slot)));
    }

    /// Cells without a force have a text of their own.
    template <Streaming streaming, class V>
    VESICA_INLINE void step_tiles(std::int64_t cell, std::int64_t next,
                                  const LayerInfluence<Real>& layer) const {
        const std::int64_t tile = cell / tile_width;
        const V rate = layer.contrast ? local_rate<V>(tile, layer) : V(rates_.outer);
        const std::int32_t slot = layer.force_slot != nullptr ? layer.force_slot[tile] : -1;
        if (slot < 0)
            collide<streaming>(cell, next, Vec3<V>{V(0), V(0), V(0)}, rate);
        else
            collide<streaming>(cell, next,
                               Vec3<V>{V::load(layer.force.component(0) + slot),
                                       V::load(layer.force.component(1) + slot),
                                       V::load(layer.force.component(2) + slot)},
                               rate);
    }

    template <class V>
    V local_rate(std::int64_t tile, const LayerInfluence<Real>& layer) const {
        const std::int32_t slot = layer.colour_slot[tile];
        if (slot >= 0)
            return rate_between(rates_, V::load(layer.red + slot));
        std::uint32_t inside = layer.inside[tile];
        for (int k = 1; k < V::width / tile_width; ++k)
            inside |= std::uint32_t{layer.inside[tile + k]} << (k * tile_width);
        return select<Real>(V::mask(inside), V(rates_.inner), V(rates_.outer));
    }

    /// The machine foresees long runs of memory only: meanwhile it is asked for the row that comes next, line
    /// by line between the rest, as it takes few requests at a time.
    template <Streaming streaming, class V>
    VESICA_INLINE void collide(std::int64_t cell, std::int64_t next, const Vec3<V>& F, const V& rate) const {
        constexpr int cells_per_line = 64 / static_cast<int>(sizeof(Real));
        const bool new_line = V::width == cells_per_line || next % cells_per_line == 0;
        const auto fetch = [&](auto i, bool in_turn) VESICA_INLINE_LAMBDA {
            if (in_turn && new_line)
                f_.template fetch<streaming, decltype(i)::value>(next);
        };
        V g[direction_count];
        for_each_direction([&](auto i) VESICA_INLINE_LAMBDA {
            g[i] = V::load(f_.template arriving<streaming, decltype(i)::value>(cell));
            fetch(i, i % 2 == 0);
        });
        collision_(g, F, rate, V(rho0_));
        for_each_direction([&](auto i) VESICA_INLINE_LAMBDA {
            g[i].store(f_.template departing<streaming, decltype(i)::value>(cell));
            fetch(i, i % 2 == 1);
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
