#pragma once

#include "core/input_error.hpp"
#include "simulation/lattice_engine.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace vesica {

/// The state in canonical order: nothing of threads, tiles or the streaming pattern shows.
template <class Real>
class LatticeEngine<Real>::Planes final : public StatePlanes {
public:
    explicit Planes(const LatticeEngine& engine)
        : engine_(engine),
          in_band_(engine.layer_.cells_of_level(Band::outermost)),
          core_(in_band_.size(), 0) {
        head_.step = engine.step_;
        head_.precision = engine.setup_.precision;
        head_.size = engine.block_.box;
        head_.part = engine.block_.own;
        const Membrane& membrane = engine.membrane_;
        head_.controllers = {membrane.constraint_tension, 0.0, 0.0, 0.0};
        if (const auto* multiplier = std::get_if<AreaMultiplier>(&membrane.area)) {
            const AreaMultiplier::State& held = multiplier->state();
            head_.controllers = {membrane.constraint_tension, held.integral, held.previous_excess,
                                 held.started ? 1.0 : 0.0};
        }
        for (const Band::Seed& seed : engine.layer_.core())
            core_[static_cast<std::size_t>(seed.tile)] = seed.bits;
    }

    const StateHead& head() const override { return head_; }
    bool all_floats() const override { return std::is_same_v<Real, float>; }
    std::size_t population_count() const override { return direction_count; }

    void population(std::size_t i, int z, std::span<double> plane) const override {
        const Vec3<int> size = engine_.grid_.size();
        double* to = plane.data();
        for (int y = 0; y < size.y; ++y) {
            const Real* const row =
                engine_.f_.find(engine_.streaming_, static_cast<int>(i), engine_.grid_.index(0, y, z));
            to = std::transform(row, row + size.x, to, [](Real value) { return static_cast<double>(value); });
        }
    }
    void minority(int z, std::span<double> plane) const override {
        for_each_cell(z, [&](std::size_t at, std::int64_t cell) { plane[at] = colour_of(cell); });
    }
    void band(int z, std::span<std::uint8_t> plane) const override {
        for_each_cell(z, [&](std::size_t at, std::int64_t cell) {
            const bool red = std::signbit(colour_of(cell));
            plane[at] = static_cast<std::uint8_t>((holds(core_, cell) ? 1 : 0) | (red ? 2 : 0));
        });
    }

private:
    template <class Body>
    void for_each_cell(int z, const Body& body) const {
        const Vec3<int> size = engine_.grid_.size();
        std::size_t at = 0;
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                body(at++, engine_.grid_.index(x, y, z));
    }

    static bool holds(const std::vector<std::uint8_t>& bits, std::int64_t cell) {
        return (bits[static_cast<std::size_t>(cell / tile_width)] >> (cell % tile_width) & 1) != 0;
    }

    double colour_of(std::int64_t cell) const {
        const Layer<Real>& layer = engine_.layer_;
        if (!holds(in_band_, cell))
            return holds(layer.inside(), cell) ? -0.0 : 0.0;
        const std::int32_t slot = layer.band().slot_of_tile(cell / tile_width);
        return static_cast<double>(layer.fields().chi[static_cast<std::size_t>(slot + cell % tile_width)]);
    }

    const LatticeEngine& engine_;
    std::vector<std::uint8_t> in_band_;
    std::vector<std::uint8_t> core_;
    StateHead head_;
};

template <class Real>
std::unique_ptr<StatePlanes> LatticeEngine<Real>::planes() const {
    return std::make_unique<Planes>(*this);
}

template <class Real>
EngineState LatticeEngine<Real>::save() const {
    return collected(Planes(*this));
}

template <class Real>
void LatticeEngine<Real>::load(const EngineState& state) {
    const auto cells = static_cast<std::size_t>(grid_.volume());
    if (!(state.size == block_.box) || !(state.part == block_.own) ||
        state.populations.size() != direction_count || state.minority.size() != cells ||
        state.band.size() != cells || state.controllers.size() != 4)
        throw RunError("the saved state belongs to another box");
    if (state.precision != setup_.precision)
        throw RunError("the saved state was computed in another precision");

    fill_at_rest();
    step_ = state.step;
    streaming_ = Streaming::arrived;
    remember_walls();
    slide_layer();
    std::vector<std::uint8_t> core(layer_.inside().size(), 0);
    std::vector<std::uint8_t> inside(layer_.inside().size(), 0);
    std::vector<std::size_t> canonical(static_cast<std::size_t>(grid_.cells()), 0);
    for_each_cell_of_block([&](std::size_t at, std::int64_t cell) {
        for (int i = 0; i < direction_count; ++i)
            f_.slot(i)[cell] = static_cast<Real>(state.populations[static_cast<std::size_t>(i)][at]);
        const auto tile = static_cast<std::size_t>(cell / tile_width);
        const auto bit = cell % tile_width;
        core[tile] = static_cast<std::uint8_t>(core[tile] | (state.band[at] & 1) << bit);
        inside[tile] = static_cast<std::uint8_t>(inside[tile] | (state.band[at] >> 1 & 1) << bit);
        canonical[static_cast<std::size_t>(cell)] = at;
    });
    if (setup_.colours == nullptr)
        return;
    std::vector<Band::Seed> seeds;
    for (std::size_t tile = 0; tile < core.size(); ++tile)
        if (core[tile] != 0)
            seeds.push_back({static_cast<std::int64_t>(tile), core[tile]});
    layer_.place(
        seeds,
        [&](std::int64_t cell) {
            return static_cast<Real>(state.minority[canonical[static_cast<std::size_t>(cell)]]);
        },
        std::move(inside), setup_.threads);
    membrane_.constraint_tension = state.controllers[0];
    if (auto* multiplier = std::get_if<AreaMultiplier>(&membrane_.area))
        multiplier->restore({state.controllers[1], state.controllers[2], state.controllers[3] != 0.0});
    layer_.weigh(f_, streaming_, setup_.threads);
    layer_.locate(setup_.threads);
    find_geometry();
    answer_buoyancy();
    layer_.forces(membrane_, setup_.threads);
}

} // namespace vesica
