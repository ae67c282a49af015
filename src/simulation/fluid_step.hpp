#pragma once

#include "boundary/bounce_back.hpp"
#include "boundary/lees_edwards.hpp"
#include "boundary/periodic.hpp"
#include "lattice/band.hpp"
#include "lattice/populations.hpp"
#include "lattice/solid_cells.hpp"
#include "parallel/for_each.hpp"
#include "parallel/pack.hpp"
#include "simulation/layer_influence.hpp"
#include "simulation/rank_boundary.hpp"
#include "simulation/row_schedule.hpp"

#include <algorithm>
#include <functional>

namespace vesica {

/// What drives the fluid, and what it cannot pass.
template <class Real>
struct FlowInfluence {
    Vec3<double> body_force{};               ///< per volume, in every cell
    const SolidCells* solids = nullptr;      ///< null: none
    const BounceBack<Real>* walls = nullptr; ///< null: none
    LeesEdwards<Real>* sliding = nullptr;    ///< null: no face slides
    std::function<void()>
        on_departure{}; ///< called when the populations that leave through sliding faces are known

    bool pushes() const { return body_force != Vec3<double>{}; }
};

/// 1/nu, but for a factor.
constexpr double thinness_of(double rate) {
    return 1.0 / (1.0 / rate - 0.5);
}
/// lambda of what lies between fluids, from 1/nu linear in the colours' shares: a layer sheared along itself
/// (equal stress, velocities adding up) is then exact.
template <class V>
[[gnu::always_inline]] inline V rate_of_thinness(const V& thinness) {
    return V(1) / (V(0.5) + V(1) / thinness);
}

/// The same, rounded alike, where there is one colour alone: whether a band has a pure cell must not show.
template <class Real>
double pure_rate(double outer_rate, double thinning) {
    using V = Pack<Real>;
    return static_cast<double>(rate_of_thinness(fma(V(1), V(thinning), V(thinness_of(outer_rate))))[0]);
}

/// Collides every cell and streams it, in place, in one pass over the block. Whoever needs the populations of
/// the new state is told, row by row, as soon as they have settled: settled(thread, first row, last row).
/// Where other processes hold the neighbouring blocks, the cells along the boundary go first, and what
/// crosses it travels while the rest is worked on.
template <class Real, class Collision>
class FluidStep {
public:
    FluidStep() = default;
    FluidStep(const Grid& grid, const PopulationView<Real>& f, const Collision& collision, double outer_rate,
              double reference_density)
        : grid_(grid),
          f_(f),
          boundary_(f, grid),
          collision_(collision),
          outer_rate_(outer_rate),
          pure_outer_rate_(pure_rate<Real>(outer_rate, 0.0)),
          rho0_(reference_density) {}

    /// `others` is null where the block meets no images in messages.
    template <class Settled>
    void operator()(Streaming streaming, const LayerInfluence<Real>& layer, const FlowInfluence<Real>& flow,
                    RankBoundary<Real>* others, int threads, const Settled& settled) const {
        const Influence influence{layer, flow, flow.pushes() || layer.buoyant,
                                  layer.contrast || layer.buoyant};
        if (streaming == Streaming::arrived)
            step<Streaming::arrived>(influence, others, threads, settled);
        else
            step<Streaming::turned>(influence, others, threads, settled);
    }

private:
    static constexpr int rows_between_progress = 64;

    struct Influence {
        const LayerInfluence<Real>& layer;
        const FlowInfluence<Real>& flow;
        bool pushed;    ///< by more than the layer
        bool by_colour; ///< something depends on a cell's colours
    };

    template <Streaming streaming, class Settled>
    void step(const Influence& influence, RankBoundary<Real>* others, int threads,
              const Settled& settled) const {
        const Vec3<int> size = grid_.size();
        const Vec3<bool> divided = others != nullptr ? others->divided() : Vec3<bool>{};
        const bool follows = influence.layer.force_slot != nullptr || influence.flow.walls != nullptr;
        const RowSchedule schedule(size, follows ? rows_in_cache() : size.y, divided.x);
        const auto settle = [&](int thread, std::int64_t first, std::int64_t last) {
            if constexpr (streaming == Streaming::turned)
                collect_rows(first, last, divided);
            if (influence.flow.walls != nullptr)
                influence.flow.walls->template reflect_rows<streaming>(first, last);
            settled(thread, first, last);
        };
        if (others != nullptr) {
            step_rim<streaming>(influence, divided, threads);
            if (influence.flow.sliding != nullptr)
                leave_through_sliding_faces<streaming>(influence.flow, divided, threads);
            others->template start<streaming>(threads);
        }
        const auto is_done = [&](std::int64_t row) {
            return others != nullptr && is_rim(row, divided);
        };
        // The inner cells of rows whose ends belong to the rim.
        const int begin_x = divided.x ? tile_width : 0;
        const int end_x = divided.x ? last_tile() : size.x;
        for_each_block(schedule.rows(), threads, [&](int thread, std::int64_t begin, std::int64_t end) {
            int since_progress = 0;
            schedule.in_turn(
                begin, end,
                [&](std::int64_t row, std::int64_t next) {
                    if (others != nullptr && thread == 0 && ++since_progress % rows_between_progress == 0)
                        others->progress();
                    if (is_done(row))
                        return;
                    step_row<streaming>(first_cell(row), first_cell(next), begin_x, end_x, influence);
                    if constexpr (streaming == Streaming::arrived)
                        if (!divided.x)
                            boundary_.publish_row(y_of(row), z_of(row));
                },
                [&](std::int64_t first, std::int64_t last) { settle(thread, first, last); });
        });
        close_boundary<streaming>(divided, others, threads);
        if constexpr (streaming == Streaming::arrived)
            if (influence.flow.sliding != nullptr)
                slide<streaming>(*influence.flow.sliding, threads);
        for_each_block(schedule.rows(), threads, [&](int thread, std::int64_t begin, std::int64_t end) {
            schedule.left_over(begin, end,
                               [&](std::int64_t first, std::int64_t last) { settle(thread, first, last); });
        });
    }

    /// The block's own periodic faces, and what the neighbours have sent. What is collected from neighbours
    /// may belong on the far side of the block's own faces.
    template <Streaming streaming>
    void close_boundary(const Vec3<bool>& divided, RankBoundary<Real>* others, int threads) const {
        const Vec3<int> size = grid_.size();
        if constexpr (streaming == Streaming::arrived) {
            if (!divided.y)
                for_each_index(size.z, threads,
                               [&](std::int64_t z) { boundary_.publish_y(static_cast<int>(z)); });
            if (!divided.z)
                for_each_index(size.y + 2, threads,
                               [&](std::int64_t y) { boundary_.publish_z(static_cast<int>(y) - 1); });
            if (others != nullptr)
                others->template finish<streaming>(threads);
        } else {
            if (others != nullptr)
                others->template finish<streaming>(threads);
            if (!divided.z)
                for_each_index(size.y + 2, threads,
                               [&](std::int64_t y) { boundary_.collect_z(static_cast<int>(y) - 1); });
            if (!divided.y)
                for_each_index(size.z, threads,
                               [&](std::int64_t z) { boundary_.collect_y(static_cast<int>(z)); });
        }
    }

    /// Rows along the faces across y and z that are divided, and the ends of all others if x is.
    template <Streaming streaming>
    void step_rim(const Influence& influence, const Vec3<bool>& divided, int threads) const {
        const Vec3<int> size = grid_.size();
        for_each_index(std::int64_t{size.y} * size.z, threads, [&](std::int64_t row) {
            const std::int64_t first = first_cell(row);
            if (is_rim(row, divided)) {
                step_row<streaming>(first, first, 0, size.x, influence);
                if constexpr (streaming == Streaming::arrived)
                    if (!divided.x)
                        boundary_.publish_row(y_of(row), z_of(row));
            } else if (divided.x) {
                step_row<streaming>(first, first, 0, tile_width, influence);
                step_row<streaming>(first, first, last_tile(), size.x, influence);
            }
        });
    }

    template <Streaming streaming>
    static void slide(LeesEdwards<Real>& sliding, int threads) {
        for_each_index(sliding.lines(), threads,
                       [&](std::int64_t line) { sliding.template slide<streaming>(line); });
    }

    /// Sliding faces belong to the rim: the block meets even its own images in messages.
    template <Streaming streaming>
    void leave_through_sliding_faces(const FlowInfluence<Real>& flow, const Vec3<bool>& divided,
                                     int threads) const {
        for_each_index(flow.sliding->faces().rows(), threads,
                       [&](std::int64_t row) { flow.sliding->template correct<streaming, Pack<Real>>(row); });
        flow.on_departure();
        if constexpr (streaming == Streaming::turned) {
            slide<streaming>(*flow.sliding, threads);
        } else if (!divided.x) {
            const Vec3<int> size = grid_.size();
            for_each_index(std::int64_t{size.y} * size.z, threads, [&](std::int64_t row) {
                if (is_rim(row, divided))
                    boundary_.publish_row(y_of(row), z_of(row));
            });
        }
    }

    bool is_rim(std::int64_t row, const Vec3<bool>& divided) const {
        const int y = y_of(row);
        const int z = z_of(row);
        return (divided.y && (y == 0 || y == grid_.size().y - 1)) ||
               (divided.z && (z == 0 || z == grid_.size().z - 1));
    }

    int last_tile() const { return (grid_.size().x - 1) / tile_width * tile_width; }

    int y_of(std::int64_t row) const { return static_cast<int>(row % grid_.size().y); }
    int z_of(std::int64_t row) const { return static_cast<int>(row / grid_.size().y); }
    std::int64_t first_cell(std::int64_t row) const { return grid_.index(0, y_of(row), z_of(row)); }

    void collect_rows(std::int64_t first, std::int64_t last, const Vec3<bool>& divided) const {
        if (divided.x)
            return;
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

    /// The tiles of a row from begin_x to end_x, as many at once as fill a register.
    template <Streaming streaming>
    void step_row(std::int64_t first, std::int64_t next_first, int begin_x, int end_x,
                  const Influence& influence) const {
        constexpr int most = tiles_per_register<Real>;
        for (int x = begin_x; x < end_x;) {
            if constexpr (most > 1)
                if (x + most * tile_width <= end_x &&
                    side_by_side<most>((first + x) / tile_width, influence)) {
                    step_tiles<streaming, Pack<Real, most * tile_width>>(first + x, next_first + x,
                                                                         influence);
                    x += most * tile_width;
                    continue;
                }
            step_tiles<streaming, Pack<Real>>(first + x, next_first + x, influence);
            x += tile_width;
        }
    }

    /// Whether what the layer tells of these tiles can be read as one.
    template <int count>
    static bool side_by_side(std::int64_t tile, const Influence& influence) {
        const LayerInfluence<Real>& layer = influence.layer;
        const auto follow = [&](const std::int32_t* slot) {
            for (int k = 1; k < count; ++k)
                if (slot[tile + k] != (slot[tile] < 0 ? outside_bands : slot[tile] + k * tile_width))
                    return false;
            return true;
        };
        const auto alike = [&] {
            for (int k = 1; k < count; ++k)
                if (layer.interior[tile + k] != layer.interior[tile])
                    return false;
            return !is_shared(layer.colour_slot[tile]) && follow(layer.colour_slot);
        };
        return layer.force_slot == nullptr || (follow(layer.force_slot) && (!influence.by_colour || alike()));
    }

    /// Cells without a force have a text of their own.
    template <Streaming streaming, class V>
    VESICA_INLINE void step_tiles(std::int64_t cell, std::int64_t next, const Influence& influence) const {
        const LayerInfluence<Real>& layer = influence.layer;
        const std::int64_t tile = cell / tile_width;
        std::uint32_t solid = 0;
        if (influence.flow.solids != nullptr) {
            solid = influence.flow.solids->of_tiles(tile, V::width / tile_width);
            if (solid == static_cast<std::uint32_t>((std::uint64_t{1} << V::width) - 1))
                return;
        }
        const V rate = layer.contrast ? local_rate<V>(tile, layer) : V(outer_rate_);
        const std::int32_t slot = layer.force_slot != nullptr ? layer.force_slot[tile] : -1;
        if (slot < 0 && !influence.pushed) {
            collide<streaming>(cell, next, Vec3<V>{V(0), V(0), V(0)}, rate, solid);
            return;
        }
        Vec3<V> F{V(0), V(0), V(0)};
        if (slot >= 0)
            F = {V::load(layer.force.component(0) + slot), V::load(layer.force.component(1) + slot),
                 V::load(layer.force.component(2) + slot)};
        if (influence.pushed)
            F = F + flow_force<V>(tile, influence);
        collide<streaming>(cell, next, F, rate, solid);
    }

    template <class V>
    Vec3<V> flow_force(std::int64_t tile, const Influence& influence) const {
        const FlowInfluence<Real>& flow = influence.flow;
        Vec3<V> F{V(flow.body_force.x), V(flow.body_force.y), V(flow.body_force.z)};
        if (influence.layer.buoyant)
            influence.layer.template for_each_colour<V>(tile, [&](std::int32_t label, const V& share) {
                const Vec3<double>& lift = influence.layer.inner[label].buoyancy;
                F = F + Vec3<V>{share * V(lift.x), share * V(lift.y), share * V(lift.z)};
            });
        return F;
    }

    template <class V>
    V local_rate(std::int64_t tile, const LayerInfluence<Real>& layer) const {
        if (layer.colour_slot[tile] == outside_bands)
            return V(layer.interior[tile] < 0 ? pure_outer_rate_ : layer.inner[layer.interior[tile]].rate);
        V thinness = V(thinness_of(outer_rate_));
        layer.template for_each_colour<V>(tile, [&](std::int32_t label, const V& share) {
            thinness = fma(share, V(layer.inner[label].thinning), thinness);
        });
        return rate_of_thinness(thinness);
    }

    /// The machine foresees long runs of memory only: meanwhile it is asked for the row that comes next, line
    /// by line between the rest, as it takes few requests at a time. Solid cells stay at rest.
    template <Streaming streaming, class V>
    VESICA_INLINE void collide(std::int64_t cell, std::int64_t next, const Vec3<V>& F, const V& rate,
                               std::uint32_t solid) const {
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
        if (solid != 0) [[unlikely]]
            for_each_direction([&](auto i)
                                   VESICA_INLINE_LAMBDA { g[i] = select<Real>(V::mask(solid), V(0), g[i]); });
        for_each_direction([&](auto i) VESICA_INLINE_LAMBDA {
            g[i].store(f_.template departing<streaming, decltype(i)::value>(cell));
            fetch(i, i % 2 == 1);
        });
    }

    Grid grid_;
    PopulationView<Real> f_;
    PeriodicBoundary<Real> boundary_;
    Collision collision_;
    double outer_rate_ = 1.0;
    double pure_outer_rate_ = 1.0; ///< as it comes out where fluids of several viscosities are
    double rho0_ = 1.0;
};

} // namespace vesica
