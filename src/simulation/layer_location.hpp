#pragma once

#include "simulation/layer.hpp"

namespace vesica {

template <class Real>
void Layer<Real>::locate(int threads) {
    corrections_.resize(leaked_.size());
    for (std::size_t k = 0; k < leaked_.size(); ++k)
        corrections_[k] = static_cast<Real>(layer_sum_[k] > 0.0 ? leaked_[k] / layer_sum_[k] : 0.0);
    area_sums_.reset(threads, labels());
    red_sums_.reset(threads, labels());
    struct alignas(64) Departed {
        unsigned bits = 0;
    };
    std::vector<Departed> departed(static_cast<std::size_t>(threads));
    core_bits_.resize(band_.tiles().size());
    const auto place_surface = [&]<class Tiles>(const Tiles& t, std::size_t index, int thread) {
        using V = typename Tiles::V;
        const V density = t.load(fields_.density);
        V chi = t.load(fields_.chi);
        if (have_arrived_)
            chi = select<Real>(t.cells_of(reach::receiving), t.load(fields_.s), chi);
        const auto holds_both = t.cells_of(reach::colour);
        // The side stays as it is: a pure red cell is -0, and -0 plus a zero share of the correction
        // would be +0, blue.
        const V corrected = with_sign_bit<Real>(sign_bit(chi), chi + V(corrections_[at(t.label())]) *
                                                                         layer_density(chi) / density);
        chi = select<Real>(holds_both, corrected, chi);
        t.store(chi, fields_.chi);
        t.store(signed_distance_of(chi, V(purest), settings_.beta), fields_.s);
        const V layer = layer_density(chi);
        area_sums_.of(thread, t.label()).add(select<Real>(holds_both, V(0.5 * settings_.beta) * layer, V(0)));
        red_sums_.of(thread, t.label())
            .add(select<Real>(t.cells_of(Band::outermost), red_fraction(chi), V(0)));
        const std::uint32_t core = bits_of<V>((layer > V(settings_.cutoff)) & holds_both);
        for (int k = 0; k < Tiles::count; ++k)
            core_bits_[index + at(k)] = static_cast<std::uint8_t>(core >> (k * tile_width));
        departed[at(thread)].bits |= core & ~t.bits(reach::force);
    };
    share(Band::outermost, threads, {fields_.chi, fields_.s}, place_surface);
    have_arrived_ = false;
    colour_slid_ghosts(threads);
    extend_into_solids({fields_.s}, Band::outermost, 1.0, threads);
    core_has_left_ = ranks().any(
        std::any_of(departed.begin(), departed.end(), [](const Departed& cells) { return cells.bits != 0; }));
    leaked_.assign(leaked_.size(), 0.0);
}

} // namespace vesica
