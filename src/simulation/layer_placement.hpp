#pragma once

#include "simulation/layer.hpp"

#include <algorithm>
#include <bit>
#include <numeric>

namespace vesica {

namespace detail {

/// Among tiles sorted as they lie in the grid; null if it is not there.
inline const BandTile* find_tile(const std::vector<BandTile>& tiles, std::int64_t tile) {
    const auto found =
        std::lower_bound(tiles.begin(), tiles.end(), tile,
                         [](const BandTile& t, std::int64_t wanted) { return t.tile < wanted; });
    return found != tiles.end() && found->tile == tile ? &*found : nullptr;
}

} // namespace detail

template <class Real>
void Layer<Real>::follow_core(const PopulationView<Real>& f, Streaming streaming, int threads) {
    std::vector<Band::Seed> core;
    for (std::size_t k = 0; k < core_bits_.size(); ++k)
        if (core_bits_[k] != 0)
            core.push_back({band_.tiles()[k].tile, core_bits_[k]});

    const std::vector<BandTile> old_tiles = band_.tiles();
    const std::vector<Real> old_chi(fields_.chi.begin(), fields_.chi.end());
    const std::vector<Real> old_density(fields_.density.begin(), fields_.density.end());
    const auto count_of = [](const std::vector<BandTile>& list) {
        return static_cast<std::int64_t>(list.size());
    };
    for_each_index(count_of(old_tiles), threads, [&](std::int64_t index) {
        const BandTile& t = old_tiles[at(index)];
        for (int k = 0; k < tile_width; ++k)
            if ((t.bits[Band::outermost] >> k & 1) != 0)
                set_side(t.tile, k, sign_bit(old_chi[at(t.slot() + k)]));
    });
    lay_out(core);
    for_each_index(count_of(band_.tiles()), threads, [&](std::int64_t index) {
        const BandTile& t = band_.tiles()[at(index)];
        const BandTile* const old = detail::find_tile(old_tiles, t.tile);
        for (int k = 0; k < tile_width; ++k) {
            const bool red = (inside_[at(t.tile)] >> k & 1) != 0;
            const bool holds_both = (t.bits[reach::colour] >> k & 1) != 0;
            fields_.chi[at(t.slot() + k)] =
                old != nullptr && holds_both ? old_chi[at(old->slot() + k)] : with_sign_bit(red, Real(0));
        }
    });
    let_go(old_tiles, old_chi, old_density);
    weigh(f, streaming, threads);
}

template <class Real>
void Layer<Real>::lay_out(const std::vector<Band::Seed>& core) {
    laid_out_core_ = core;
    for (const BandTile& t : band_.tiles())
        force_slots_[at(t.tile)] = colour_slots_[at(t.tile)] = -1;
    band_.rebuild(core, halo_.exchange_seeds(core, band_.grid()), displacement_.whole);
    if (neighbourhood_->block().slide) {
        join_images();
        list_face_tiles();
    }
    halo_.follow(band_);
    empty_ = !ranks().any(!core.empty());
    if (solids_ != nullptr) {
        margin_.follow(band_);
        near_solids_ = ranks().any(!margin_.empty());
    }
    for (const BandTile& t : band_.tiles())
        colour_slots_[at(t.tile)] = t.slot();
    fields_.resize(band_.compact_size());
    if (force_.stride() < band_.compact_size())
        force_ = Field<Real>(3, band_.compact_size() + band_.compact_size() / 4);
    for (int a = 0; a < 3; ++a)
        std::fill_n(force_.view().component(a), band_.compact_size(), Real(0));
    for (const std::int32_t index : band_.of_level(reach::force)) {
        const BandTile& t = band_.tiles()[at(index)];
        force_slots_[at(t.tile)] = t.slot();
    }
    number_rows();
    count_plain_red();
    // The slot that stands for everything outside the band must be harmless.
    std::fill_n(fields_.density.begin(), fields_.density.size(), Real(settings_.reference_density));
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
    double count = 0.0;
    for (std::int64_t tile = 0; tile < band_.grid().tiles(); ++tile)
        if (inside_[at(tile)] != 0)
            count += std::popcount(static_cast<unsigned>(
                inside_[at(tile)] & band_.grid().interior_bits(band_.grid().tile_origin(tile))));
    for (const BandTile& t : band_.tiles())
        count -= std::popcount(static_cast<unsigned>(inside_[at(t.tile)] & t.bits[Band::outermost]));
    const double lanes[tile_width] = {count};
    plain_red_ = {};
    plain_red_.add(Pack<double>::load(lanes));
}

template <class Real>
void Layer<Real>::let_go(const std::vector<BandTile>& tiles, const std::vector<Real>& chi,
                         const std::vector<Real>& density) {
    // A droplet that fades away far from the rest may leave nearly all it had at the cutoff: room for that.
    LaneSum<50> gone;
    using V = Pack<Real>;
    const V per_reference = V(1.0 / settings_.reference_density);
    for (const BandTile& t : tiles) {
        const BandTile* const now = detail::find_tile(band_.tiles(), t.tile);
        const unsigned kept = now != nullptr ? now->bits[reach::colour] : 0u;
        const auto left = static_cast<std::uint8_t>(t.bits[reach::colour] & ~kept);
        if (left == 0)
            continue;
        const V amount =
            per_reference * (V::load(chi.data() + t.slot()) * V::load(density.data() + t.slot()));
        gone.add(select<Real>(V::mask(left), amount, V(0)));
    }
    LaneSum<38> layer;
    for (const BandTile& t : band_.tiles())
        layer.add(select<Real>(V::mask(t.bits[reach::colour]),
                               layer_density(V::load(fields_.chi.data() + t.slot())), V(0)));
    set_leaked(gone, layer);
}

template <class Real>
std::size_t Layer<Real>::bytes() const {
    return band_.bytes() + fields_.bytes() + force_.bytes() + inside_.capacity() +
           (force_slots_.capacity() + colour_slots_.capacity()) * sizeof(std::int32_t) +
           core_bits_.capacity() + margin_.bytes() + row_begins_.capacity() * sizeof(std::int32_t) +
           transport_sums_.capacity() * sizeof(TransportSums) + face_tiles_.capacity() * sizeof(FaceTile);
}

} // namespace vesica
