#pragma once

#include "core/input_error.hpp"
#include "simulation/lattice_engine.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <type_traits>
#include <utility>

namespace vesica {

inline constexpr std::size_t controllers_per_vesicle = 4;

/// The state in canonical order: nothing of threads, tiles or the streaming pattern shows.
template <class Real>
class LatticeEngine<Real>::Planes final : public StatePlanes {
public:
    explicit Planes(const LatticeEngine& engine) : engine_(engine) {
        head_.step = engine.step_;
        head_.precision = engine.setup_.precision;
        head_.size = engine.block_.box;
        head_.part = engine.block_.own;
        for (const Membrane& membrane : engine.membranes_) {
            AreaMultiplier::State held;
            if (const auto* multiplier = std::get_if<AreaMultiplier>(&membrane.area))
                held = multiplier->state();
            head_.controllers.insert(
                head_.controllers.end(),
                {membrane.constraint_tension, held.integral, held.previous_excess, held.started ? 1.0 : 0.0});
        }
        if (head_.controllers.empty())
            head_.controllers.assign(controllers_per_vesicle, 0.0);
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
    std::size_t slots() const override { return static_cast<std::size_t>(engine_.layer_.colours_per_cell()); }
    bool is_labelled() const override { return engine_.layer_.labels() > 1; }
    void minority(std::size_t slot, int z, std::span<double> plane) const override {
        for_each_cell(z, [&](std::size_t at, std::int64_t cell) { plane[at] = colour_of(cell, slot).chi; });
    }
    void band(std::size_t slot, int z, std::span<std::uint8_t> plane) const override {
        for_each_cell(z, [&](std::size_t at, std::int64_t cell) {
            const CellColour<Real> colour = colour_of(cell, slot);
            plane[at] =
                static_cast<std::uint8_t>((colour.in_core ? 1 : 0) | (std::signbit(colour.chi) ? 2 : 0));
        });
    }
    void label(std::size_t slot, int z, std::span<std::int32_t> plane) const override {
        for_each_cell(z, [&](std::size_t at, std::int64_t cell) { plane[at] = colour_of(cell, slot).label; });
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

    /// The slot-th of the cell's colours; of none, pure blue.
    CellColour<Real> colour_of(std::int64_t cell, std::size_t slot) const {
        CellColour<Real> found;
        engine_.layer_.for_each_cell_colour(cell, [&, left = slot](const CellColour<Real>& colour) mutable {
            if (left-- == 0)
                found = colour;
        });
        return found;
    }

    const LatticeEngine& engine_;
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
        state.populations.size() != direction_count || state.minority.size() != cells * state.slots() ||
        state.slots() == 0 || state.band.size() != state.minority.size() ||
        state.controllers.size() != controllers_per_vesicle * std::max<std::size_t>(1, membranes_.size()) ||
        state.label.size() != (membranes_.size() > 1 ? state.minority.size() : 0))
        throw RunError("the saved state belongs to another box");
    if (state.precision != setup_.precision)
        throw RunError("the saved state was computed in another precision");

    fill_at_rest();
    step_ = state.step;
    streaming_ = Streaming::arrived;
    remember_walls();
    slide_layer();
    std::vector<std::size_t> canonical(static_cast<std::size_t>(grid_.cells()), cells);
    for_each_cell_of_block([&](std::size_t at, std::int64_t cell) {
        for (int i = 0; i < direction_count; ++i)
            f_.slot(i)[cell] = static_cast<Real>(state.populations[static_cast<std::size_t>(i)][at]);
        canonical[static_cast<std::size_t>(cell)] = at;
    });
    if (setup_.colours == nullptr)
        return;
    const auto label_in = [&](std::size_t at) {
        return state.label.empty() ? 0 : state.label[at];
    };
    const auto chi_at = [&](std::int64_t cell, int label) {
        const std::size_t at = canonical[static_cast<std::size_t>(cell)];
        if (at < cells)
            for (std::size_t slot = 0; slot < state.slots(); ++slot)
                if (label_in(slot * cells + at) == label)
                    return static_cast<Real>(state.minority[slot * cells + at]);
        return Real(0);
    };
    std::map<std::pair<std::int64_t, std::int32_t>, std::uint8_t> core;
    std::vector<std::int32_t> interior(static_cast<std::size_t>(grid_.tiles()), -1);
    for_each_cell_of_block([&](std::size_t at, std::int64_t cell) {
        const std::int64_t tile = cell / tile_width;
        for (std::size_t slot = 0; slot < state.slots(); ++slot) {
            const std::size_t here = slot * cells + at;
            if ((state.band[here] & 1) != 0) {
                std::uint8_t& bits = core[{tile, label_in(here)}];
                bits = static_cast<std::uint8_t>(bits | 1u << (cell % tile_width));
            }
            if ((state.band[here] & 2) != 0)
                interior[static_cast<std::size_t>(tile)] = label_in(here);
        }
    });
    for (std::int64_t tile = 0; tile < grid_.tiles(); ++tile) {
        unsigned inside = grid_.interior_bits(grid_.tile_origin(tile));
        if (solids_)
            inside &= ~unsigned{solids_.of_tile(tile)};
        std::int32_t& label = interior[static_cast<std::size_t>(tile)];
        for (int k = 0; k < tile_width && label >= 0; ++k)
            if ((inside >> k & 1) != 0 && !std::signbit(chi_at(tile * tile_width + k, label)))
                label = -1;
    }
    std::vector<Band::Seed> seeds;
    for (const auto& [place, bits] : core)
        seeds.push_back({place.first, bits, place.second});
    layer_.place(seeds, chi_at, std::move(interior), setup_.threads);
    for (std::size_t label = 0; label < membranes_.size(); ++label) {
        const double* const held = state.controllers.data() + controllers_per_vesicle * label;
        membranes_[label].constraint_tension = held[0];
        if (auto* multiplier = std::get_if<AreaMultiplier>(&membranes_[label].area))
            multiplier->restore({held[1], held[2], held[3] != 0.0});
    }
    layer_.weigh(f_, streaming_, setup_.threads);
    layer_.locate(setup_.threads);
    find_geometry();
    answer_buoyancy();
    layer_.forces(membranes_, setup_.threads);
}

} // namespace vesica
