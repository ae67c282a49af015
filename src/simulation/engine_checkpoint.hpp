#pragma once

#include "core/input_error.hpp"
#include "simulation/lattice_engine.hpp"

namespace vesica {

/// The state in canonical order: nothing of threads, tiles or the streaming pattern shows.
template <class Real>
EngineState LatticeEngine<Real>::save() const {
    EngineState state;
    state.step = step_;
    state.precision = setup_.precision;
    state.size = block_.box;
    state.part = block_.own;
    const auto cells = static_cast<std::size_t>(grid_.volume());
    state.populations.assign(direction_count, std::vector<double>(cells));
    state.minority.assign(cells, 0.0);
    state.band.assign(cells, 0);

    const std::vector<std::uint8_t> in_band = layer_.cells_of_level(Band::outermost);
    std::vector<std::uint8_t> core(layer_.inside().size(), 0);
    for (const Band::Seed& seed : layer_.core())
        core[static_cast<std::size_t>(seed.tile)] = seed.bits;

    for_each_cell_of_block([&](std::size_t at, std::int64_t cell) {
        for (int i = 0; i < direction_count; ++i)
            state.populations[static_cast<std::size_t>(i)][at] =
                static_cast<double>(*f_.find(streaming_, i, cell));
        const auto tile = static_cast<std::size_t>(cell / tile_width);
        const auto bit = cell % tile_width;
        bool red = (layer_.inside()[tile] >> bit & 1) != 0;
        double chi = with_sign_bit(red, 0.0);
        if ((in_band[tile] >> bit & 1) != 0) {
            const std::int32_t slot = layer_.band().slot_of_tile(cell / tile_width);
            chi = static_cast<double>(layer_.fields().chi[static_cast<std::size_t>(slot + bit)]);
            red = sign_bit(chi);
        }
        state.minority[at] = chi;
        state.band[at] = static_cast<std::uint8_t>((core[tile] >> bit & 1) | (red ? 2 : 0));
    });
    state.controllers = {membrane_.constraint_tension, 0.0, 0.0, 0.0};
    if (const auto* multiplier = std::get_if<AreaMultiplier>(&membrane_.area)) {
        const AreaMultiplier::State& held = multiplier->state();
        state.controllers = {membrane_.constraint_tension, held.integral, held.previous_excess,
                             held.started ? 1.0 : 0.0};
    }
    return state;
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
    layer_.forces(membrane_, setup_.threads);
}

} // namespace vesica
