#pragma once

#include "simulation/layer.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>

namespace vesica {

/// Among tiles in the band's order; null if it is not there.
template <class Real>
const BandTile* Layer<Real>::find_tile(const std::vector<BandTile>& tiles, std::int64_t tile,
                                       int label) const {
    BandTile wanted;
    wanted.tile = tile;
    wanted.label = label;
    const auto found =
        std::lower_bound(tiles.begin(), tiles.end(), wanted,
                         [&](const BandTile& a, const BandTile& b) { return band_.precedes(a, b); });
    return found != tiles.end() && found->tile == tile && found->label == label ? &*found : nullptr;
}

template <class Real>
int Layer<Real>::owner_beyond_band(std::int64_t cell) const {
    if (solids_ != nullptr && solids_->has(cell))
        return -1;
    int owner = interior_[at(cell / tile_width)];
    if (owner < 0)
        for_each_tile_at(cell, [&](const BandTile& t) {
            const auto k = cell % tile_width;
            if ((t.bits[Band::outermost] >> k & 1) == 0 && sign_bit(fields_.chi[at(t.slot() + k)]))
                owner = t.label;
        });
    return owner;
}

template <class Real>
template <class Body>
void Layer<Real>::for_each_cell_colour(std::int64_t cell, Body&& body) const {
    const int owner = owner_beyond_band(cell);
    bool told = owner < 0;
    const auto tell_owner = [&](int before) {
        if (!told && owner < before)
            body(CellColour<Real>{owner, with_sign_bit(true, Real(0)), false});
        told = told || owner < before;
    };
    for_each_tile_at(cell, [&](const BandTile& t) {
        const auto k = cell % tile_width;
        if ((t.bits[Band::outermost] >> k & 1) == 0)
            return;
        tell_owner(t.label);
        body(CellColour<Real>{t.label, fields_.chi[at(t.slot() + k)],
                              (laid_out_bits_[at(&t - band_.tiles().data())] >> k & 1) != 0});
    });
    tell_owner(std::numeric_limits<int>::max());
}

/// The same whichever way the box is cut.
template <class Real>
void Layer<Real>::count_colours() {
    int most = 1;
    for (std::int64_t index = 0; index < shared_.count(); ++index) {
        const SharedTiles::Range& range = shared_.range(index);
        const std::int32_t first = shared_.colour(range.begin).tile;
        const std::int64_t tile =
            band_.tiles()[at(first >= 0 ? first : shared_.colour(range.begin + 1).tile)].tile;
        const unsigned inside = band_.grid().interior_bits(band_.grid().tile_origin(tile));
        for (int k = 0; k < tile_width; ++k) {
            int colours = 0;
            if ((inside >> k & 1) != 0)
                for_each_cell_colour(tile * tile_width + k, [&](const auto&) { ++colours; });
            most = std::max(most, colours);
        }
    }
    colours_per_cell_ = most;
    for (const int of_rank : ranks().gather_all(most))
        colours_per_cell_ = std::max(colours_per_cell_, of_rank);
}

template <class Real>
const BandTile* Layer<Real>::nearest_tile(std::int64_t cell, int level) const {
    const BandTile* nearest = nullptr;
    Real distance = Real(0);
    for_each_tile_at(cell, [&](const BandTile& t) {
        const auto k = cell % tile_width;
        if ((t.bits[level] >> k & 1) == 0)
            return;
        const Real away = std::abs(fields_.s[at(t.slot() + k)]);
        if (nearest == nullptr || away < distance) {
            nearest = &t;
            distance = away;
        }
    });
    return nearest;
}

template <class Real>
template <class Body>
void Layer<Real>::for_each_share(std::int64_t cell, const Body& body) const {
    double rest = 1.0;
    for_each_colour(cell, fields_.chi, [&](int label, Real chi) {
        const auto share = static_cast<double>(red_fraction(chi));
        rest -= share;
        if (share > 0.0)
            body(label, share);
    });
    if (const int owner = interior_[at(cell / tile_width)]; owner >= 0)
        body(owner, rest);
}

template <class Real>
void Layer<Real>::follow_core(const PopulationView<Real>& f, Streaming streaming, int threads) {
    std::vector<Band::Seed> core;
    for (std::size_t k = 0; k < core_bits_.size(); ++k)
        if (core_bits_[k] != 0)
            core.push_back({band_.tiles()[k].tile, core_bits_[k], band_.tiles()[k].label});

    const std::vector<BandTile> old_tiles = band_.tiles();
    const std::vector<Real> old_chi(fields_.chi.begin(), fields_.chi.end());
    const std::vector<Real> old_density(fields_.density.begin(), fields_.density.end());
    forget_slots();
    // What a band lets go of is all on one side.
    for (const BandTile& t : old_tiles) {
        const unsigned fluid = fluid_bits(t.tile);
        if (fluid != 0 && sign_bit(old_chi[at(t.slot() + std::countr_zero(fluid))]))
            interior_[at(t.tile)] = t.label;
    }
    lay_out(core, threads, [&](const BandTile& t, Real* chi) {
        if (const BandTile* const old = find_tile(old_tiles, t.tile, t.label))
            std::copy_n(old_chi.begin() + old->slot(), tile_width, chi);
        else
            std::fill_n(chi, tile_width, with_sign_bit(interior_[at(t.tile)] == t.label, Real(0)));
    });
    let_go(old_tiles, old_chi, old_density);
    weigh(f, streaming, threads);
}

template <class Real>
void Layer<Real>::forget_slots() {
    for (const BandTile& t : band_.tiles())
        force_slots_[at(t.tile)] = colour_slots_[at(t.tile)] = outside_bands;
}

template <class Real>
template <class Colour>
void Layer<Real>::lay_out(const std::vector<Band::Seed>& core, int threads, const Colour& colour) {
    laid_out_core_ = core;
    band_.rebuild(core, halo_.exchange_seeds(core, band_.grid()), displacement_.whole);
    const auto colours_of = [&](const BandTile& t, Real* chi) {
        colour(t, chi);
        for (int k = 0; k < tile_width; ++k)
            if ((t.bits[reach::colour] >> k & 1) == 0)
                chi[k] = with_sign_bit(sign_bit(chi[k]), Real(0));
    };
    if (neighbourhood_->block().slide)
        join_images([&](std::int64_t cell) {
            const std::int64_t tile = cell / tile_width;
            int owner = interior_[at(tile)];
            band_.for_each_label(tile, [&](int label, std::int32_t) {
                const BandTile* const t = find_tile(band_.tiles(), tile, label);
                if (t == nullptr)
                    return;
                Real chi[tile_width];
                colours_of(*t, chi);
                const auto k = cell % tile_width;
                if ((t->bits[Band::outermost] >> k & 1) == 0 && sign_bit(chi[k]))
                    owner = label;
                else if (owner == label)
                    owner = -1;
            });
            return owner;
        });
    halo_.follow(band_);
    empty_ = !ranks().any(!core.empty());
    if (solids_ != nullptr) {
        margin_.follow(band_);
        near_solids_ = ranks().any(!margin_.empty());
    }
    fields_.resize(band_.compact_size());
    for_each_index(static_cast<std::int64_t>(band_.tiles().size()), threads, [&](std::int64_t index) {
        const BandTile& t = band_.tiles()[at(index)];
        colours_of(t, fields_.chi.data() + t.slot());
    });
    for (const BandTile& t : band_.tiles())
        if (interior_[at(t.tile)] == t.label)
            interior_[at(t.tile)] = -1;
    number_slots();
    number_rows();
    if (labels() > 1)
        count_colours();
    count_plain_red();
    if (neighbourhood_->block().slide)
        list_face_tiles();
    // The slot that stands for everything outside the band must be harmless.
    std::fill_n(fields_.density.begin(), fields_.density.size(), Real(settings_.reference_density));
}

/// Where a tile's colours and forces are.
template <class Real>
void Layer<Real>::number_slots() {
    shared_.clear();
    const std::vector<BandTile>& tiles = band_.tiles();
    slot_labels_.assign(at(band_.compact_size() / tile_width), -1);
    slot_tiles_.assign(slot_labels_.size(), -1);
    for (std::size_t k = 0; k < tiles.size(); ++k) {
        colour_slots_[at(tiles[k].tile)] = tiles[k].slot();
        slot_labels_[at(tiles[k].slot() / tile_width)] = tiles[k].label;
        slot_tiles_[at(tiles[k].slot() / tile_width)] = static_cast<std::int32_t>(k);
    }
    std::int32_t numbers = 0;
    own_force_slots_.assign(tiles.size(), -1);
    for (const std::int32_t index : band_.of_level(reach::force)) {
        const BandTile& t = tiles[at(index)];
        own_force_slots_[at(index)] = numbers;
        if (t.bits[reach::force] != 0) // not where all of the level is solid
            force_slots_[at(t.tile)] = numbers;
        numbers += tile_width;
    }
    // Beside sliding faces the band's own core is larger.
    laid_out_bits_.assign(tiles.size(), 0);
    for (const Band::Seed& seed : laid_out_core_)
        laid_out_bits_[at(slot_tiles_[at(band_.slot_of_tile(seed.tile, seed.label) / tile_width)])] =
            seed.bits;
    std::vector<std::int64_t> several = band_.shared_tiles();
    for (const BandTile& t : tiles)
        if (interior_[at(t.tile)] >= 0)
            several.push_back(t.tile);
    std::sort(several.begin(), several.end());
    several.erase(std::unique(several.begin(), several.end()), several.end());
    std::vector<SharedTiles::Colour> colours;
    for (const std::int64_t tile : several) {
        colours.clear();
        band_.for_each_label(tile, [&](int label, std::int32_t slot) {
            if (const BandTile* const t = find_tile(tiles, tile, label))
                colours.push_back(
                    {label, slot, static_cast<std::int32_t>(t - tiles.data()),
                     t->bits[reach::force] != 0 ? force_slot(*t) : SharedTiles::Colour::no_force});
        });
        if (const int owner = interior_[at(tile)]; owner >= 0 && !colours.empty())
            colours.push_back({owner, SharedTiles::Colour::pure, -1, SharedTiles::Colour::no_force});
        if (colours.size() < 2)
            continue;
        std::sort(colours.begin(), colours.end(),
                  [](const auto& a, const auto& b) { return a.label < b.label; });
        numbers += shared_.add(tile, colours, numbers);
        colour_slots_[at(tile)] = shared_.last_slot();
    }
    for (const SharedTiles::Force& sum : shared_.forces())
        force_slots_[at(sum.tile)] = sum.slot;
    if (force_.stride() < numbers)
        force_ = Field<Real>(3, force_.stride() == 0 ? numbers : numbers + numbers / 4);
    for (int a = 0; a < 3; ++a)
        std::fill_n(force_.view().component(a), numbers, Real(0));
}

template <class Real>
void Layer<Real>::number_rows() {
    const Vec3<int> size = band_.grid().size();
    row_begins_.assign(at(std::int64_t{size.y} * size.z + 1), 0);
    for (const std::int32_t index : band_.of_level(reach::receiving)) {
        const Vec3<int> origin = band_.grid().tile_origin(band_.tiles()[at(index)].tile);
        ++row_begins_[at(origin.y + std::int64_t{size.y} * origin.z + 1)];
    }
    std::partial_sum(row_begins_.begin(), row_begins_.end(), row_begins_.begin());
}

template <class Real>
void Layer<Real>::count_plain_red() {
    plain_red_.reset(1, labels());
    const auto add = [&](int label, unsigned bits) {
        const double lanes[tile_width] = {static_cast<double>(std::popcount(bits))};
        if (bits != 0)
            plain_red_.of(0, label).add(Pack<double>::load(lanes));
    };
    for (std::int64_t tile = 0; tile < band_.grid().tiles(); ++tile)
        if (interior_[at(tile)] >= 0)
            add(interior_[at(tile)], fluid_bits(tile));
    for (const BandTile& t : band_.tiles()) {
        unsigned red = 0;
        for (int k = 0; k < tile_width; ++k)
            red |= (sign_bit(fields_.chi[at(t.slot() + k)]) ? 1u : 0u) << k;
        add(t.label, red & fluid_bits(t.tile) & ~unsigned{t.bits[Band::outermost]});
    }
}

template <class Real>
void Layer<Real>::let_go(const std::vector<BandTile>& tiles, const std::vector<Real>& chi,
                         const std::vector<Real>& density) {
    using V = Pack<Real>;
    leaked_sums_.reset(1, labels());
    layer_sums_.reset(1, labels());
    crossing_sums_.reset(1, labels());
    const V per_reference = V(1.0 / settings_.reference_density);
    for (const BandTile& t : tiles) {
        const BandTile* const now = find_tile(band_.tiles(), t.tile, t.label);
        const unsigned kept = now != nullptr ? now->bits[reach::colour] : 0u;
        const auto left = static_cast<std::uint8_t>(t.bits[reach::colour] & ~kept);
        if (left == 0)
            continue;
        const V amount =
            per_reference * (V::load(chi.data() + t.slot()) * V::load(density.data() + t.slot()));
        leaked_sums_.of(0, t.label).add(select<Real>(V::mask(left), amount, V(0)));
    }
    for (const BandTile& t : band_.tiles())
        layer_sums_.of(0, t.label)
            .add(select<Real>(V::mask(t.bits[reach::colour]),
                              layer_density(V::load(fields_.chi.data() + t.slot())), V(0)));
    set_leaked();
}

template <class Real>
std::size_t Layer<Real>::bytes() const {
    return band_.bytes() + fields_.bytes() + force_.bytes() +
           (interior_.capacity() + force_slots_.capacity() + colour_slots_.capacity()) *
               sizeof(std::int32_t) +
           (slot_labels_.capacity() + slot_tiles_.capacity()) * sizeof(std::int32_t) + shared_.bytes() +
           core_bits_.capacity() + laid_out_bits_.capacity() + margin_.bytes() +
           row_begins_.capacity() * sizeof(std::int32_t) + leaked_sums_.bytes() + layer_sums_.bytes() +
           crossing_sums_.bytes() + area_sums_.bytes() + red_sums_.bytes() + gaussian_sums_.bytes() +
           square_sums_.bytes() + plain_red_.bytes() + face_tiles_.capacity() * sizeof(FaceTile);
}

} // namespace vesica
