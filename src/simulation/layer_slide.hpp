#pragma once

#include "simulation/layer_placement.hpp"

#include <cmath>

namespace vesica {

/// The band has been laid out: what lies along the faces of the images beyond is told, and asked.
template <class Real>
void Layer<Real>::join_images(const std::function<int(std::int64_t)>& owner_of) {
    const auto neighbours = neighbourhood_->linked_neighbours();
    const Block& block = neighbourhood_->block();
    const std::vector<HaloPart>& parts = neighbourhood_->parts();
    // Per part that slides, how many cells, and those.
    const auto append = [](std::vector<std::byte>& message, const auto& values) {
        const auto bytes = std::as_bytes(std::span(values));
        message.insert(message.end(), bytes.begin(), bytes.end());
    };
    std::vector<std::vector<std::byte>> outgoing(neighbourhood_->neighbours().size());
    bool meets = false;
    for (std::size_t k = 0; k < neighbours.size(); ++k)
        for (const std::size_t part : neighbours[k].outgoing)
            if (block.slides_at(parts[part].link)) {
                const std::vector<Band::RimCell> rim = band_.rim_cells(part, owner_of);
                append(outgoing[k], std::array{static_cast<std::int64_t>(rim.size())});
                append(outgoing[k], rim);
                meets = meets || !band_.part_cells()[part].rim.empty();
            }
    const std::vector<std::vector<std::byte>> incoming = neighbourhood_->exchange(outgoing);
    for (std::size_t k = 0; k < neighbours.size(); ++k) {
        std::span<const std::byte> left(incoming[k]);
        const auto take = [&](auto values) {
            const auto bytes = std::as_writable_bytes(values);
            std::copy_n(left.begin(), bytes.size(), bytes.begin());
            left = left.subspan(bytes.size());
        };
        for (const std::size_t part : neighbours[k].incoming)
            if (block.slides_at(parts[part].link)) {
                std::array<std::int64_t, 1> count{};
                take(std::span(count));
                std::vector<Band::RimCell> rim(at(count.front()));
                take(std::span(rim));
                band_.join(part, rim);
            }
    }
    meets_images_ = ranks().any(meets || !band_.slid_ghosts().empty());
    slid_ = displacement_.whole;
}

template <class Real>
void Layer<Real>::list_face_tiles() {
    face_tiles_.clear();
    for (int row = 0; row < faces_.rows(); ++row)
        faces_.for_each_tile(row, [&](const SlidingFaces::Face& face, std::int64_t cell, unsigned bits) {
            const std::int64_t tile = cell / tile_width;
            const auto add = [&](std::int32_t index, int label) {
                face_tiles_.push_back({cell, face.towards, static_cast<std::uint8_t>(bits), index, label});
            };
            band_.for_each_label(tile, [&](int label, std::int32_t) {
                if (const BandTile* const in_band = find_tile(band_.tiles(), tile, label))
                    add(static_cast<std::int32_t>(in_band - band_.tiles().data()), label);
            });
            if (interior_[at(tile)] >= 0)
                add(-1, interior_[at(tile)]);
        });
}

/// Ghosts beyond sliding faces lie between cells of the images there, of which those in `level` have values.
template <class Real>
void Layer<Real>::blend_slid_ghosts(std::initializer_list<std::span<Real>> arrays, int level, int threads) {
    if (band_.slid_ghosts().empty())
        return;
    const Real pure = signed_distance_of(Real(0), Real(purest), settings_.beta);
    Real weights[Displacement::reads];
    for (std::size_t n = 0; n < Displacement::reads; ++n)
        weights[n] = static_cast<Real>(displacement_.weights[n]);
    for (const std::span<Real>& array : arrays) {
        // Farther out all is pure, and nothing is curved: it is the distance alone that goes on.
        const bool is_distance = array.data() == fields_.s.data() ||
                                 (array.data() == fields_.sharp.data() && level == reach::receiving);
        const auto value_of = [&](std::int32_t from, int lowest) {
            if (from >= 0 && lowest <= level)
                return array[at(from)];
            if (!is_distance)
                return Real(0);
            if (from >= 0)
                return fields_.s[at(from)];
            return from == Band::SlidGhost::pure_blue ? pure : -pure;
        };
        for_each_index(static_cast<std::int64_t>(band_.slid_ghosts().size()), threads, [&](std::int64_t k) {
            const Band::SlidGhost& ghost = band_.slid_ghosts()[at(k)];
            Real sum = Real(0);
            for (std::size_t n = 0; n < Displacement::reads; ++n)
                sum += weights[n] * value_of(ghost.from[n], ghost.level[n]);
            array[at(ghost.to)] = sum;
        });
    }
}

/// Colours between cells follow from the distance, which is straight where a layer is flat; a layer's own
/// profile is too steep for a cubic.
template <class Real>
void Layer<Real>::colour_slid_ghosts(int threads) {
    const Real pure = signed_distance_of(Real(0), Real(purest), settings_.beta);
    for_each_index(static_cast<std::int64_t>(band_.slid_ghosts().size()), threads, [&](std::int64_t k) {
        const std::size_t to = at(band_.slid_ghosts()[at(k)].to);
        const Real s = fields_.s[to];
        const bool is_red = s < Real(0);
        const bool is_pure = std::abs(s) >= Real(0.999) * pure;
        const Real minority =
            is_pure ? Real(0)
                    : static_cast<Real>(
                          1.0 / (1.0 + std::exp(2.0 * settings_.beta * std::abs(static_cast<double>(s)))));
        fields_.chi[to] = with_sign_bit(is_red, minority);
    });
}

template <class Real>
template <class Count>
void Layer<Real>::count_crossing(int threads, const Count& count) {
    for_each_block(static_cast<std::int64_t>(face_tiles_.size()), threads,
                   [&](int thread, std::int64_t begin, std::int64_t end) {
                       for (std::int64_t k = begin; k < end; ++k)
                           count(face_tiles_[at(k)], crossing_sums_.of(thread, face_tiles_[at(k)].label));
                   });
}

namespace detail {

/// Of what travels along i: red share of the cell it comes from, and what recolouring adds there.
template <int i, class V>
V red_carried(const V& population, const V& red, const V& separated, double reference_density) {
    return red * (V(weight(i) * reference_density) + population) - V(weight(i)) * separated;
}

} // namespace detail

template <class Real>
template <Streaming streaming>
void Layer<Real>::count_departing(const PopulationView<Real>& f, int threads) {
    using V = Pack<Real>;
    const int across = faces_.slide().gradient;
    count_crossing(threads, [&](const FaceTile& t, LaneSum<38>& sum) {
        V red = V(1);
        Vec3<V> w{V(0), V(0), V(0)};
        if (t.index >= 0) {
            const TileRun<Real> run{band_.tiles().data() + t.index};
            red = red_fraction(run.load(fields_.chi));
            w = run.load(fields_.w);
        }
        V leaves = V(0);
        for_each_direction([&](auto i) VESICA_INLINE_LAMBDA {
            if (velocity(i, across) != t.towards)
                return;
            const V g = V::load(f.template departing<streaming, decltype(i)::value>(t.cell));
            const V separated = V(velocity(i, 0)) * w.x + V(velocity(i, 1)) * w.y + V(velocity(i, 2)) * w.z;
            leaves += detail::red_carried<decltype(i)::value>(g, red, separated, settings_.reference_density);
        });
        sum.add(select<Real>(V::mask(t.bits), V(1.0 / settings_.reference_density) * leaves, V(0)));
    });
}

template <class Real>
template <Streaming streaming>
void Layer<Real>::count_arriving(const PopulationView<Real>& f, int threads) {
    using V = Pack<Real>;
    const int across = faces_.slide().gradient;
    count_crossing(threads, [&](const FaceTile& t, LaneSum<38>& sum) {
        const BandTile* const in_band = t.index >= 0 ? band_.tiles().data() + t.index : nullptr;
        const V own = in_band != nullptr ? red_fraction(TileRun<Real>{in_band}.load(fields_.chi)) : V(1);
        // Cells that receive none of the other colour keep their side.
        const auto receives = V::mask(in_band != nullptr ? in_band->bits[reach::receiving] : 0u);
        V comes = V(0);
        for_each_direction([&](auto i) VESICA_INLINE_LAMBDA {
            if (velocity(i, across) != -t.towards)
                return;
            constexpr int from = opposite(decltype(i)::value);
            const V g = V::load(f.template arriving<streaming, decltype(i)::value>(t.cell));
            V red = own;
            V separated = V(0);
            if (in_band != nullptr) {
                const TileRun<Real> run{in_band};
                const Vec3<Around<Real, tile_width>> w = around(fields_.w, run);
                red = select<Real>(receives, red_fraction(around(fields_.chi, run)(Direction<from>{})), own);
                separated = select<Real>(receives,
                                         V(velocity(i, 0)) * w.x(Direction<from>{}) +
                                             V(velocity(i, 1)) * w.y(Direction<from>{}) +
                                             V(velocity(i, 2)) * w.z(Direction<from>{}),
                                         V(0));
            }
            comes += detail::red_carried<decltype(i)::value>(g, red, separated, settings_.reference_density);
        });
        sum.add(select<Real>(V::mask(t.bits), V(-1.0 / settings_.reference_density) * comes, V(0)));
    });
}

template <class Real>
void Layer<Real>::count_departing(const PopulationView<Real>& f, Streaming streaming, int threads) {
    if (streaming == Streaming::arrived)
        count_departing<Streaming::arrived>(f, threads);
    else
        count_departing<Streaming::turned>(f, threads);
}

template <class Real>
void Layer<Real>::count_arriving(const PopulationView<Real>& f, Streaming streaming, int threads) {
    if (streaming == Streaming::arrived)
        count_arriving<Streaming::arrived>(f, threads);
    else
        count_arriving<Streaming::turned>(f, threads);
}

} // namespace vesica
