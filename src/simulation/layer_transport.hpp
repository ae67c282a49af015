#pragma once

#include "simulation/layer.hpp"

#include <chrono>

namespace vesica {

template <class Real>
void Layer<Real>::begin_transport(int threads) {
    leaked_sums_.reset(threads, labels());
    layer_sums_.reset(threads, labels());
    crossing_sums_.reset(threads, labels());
    have_arrived_ = true;
    transport_seconds_.assign(at(threads), 0.0);
}

template <class Real>
void Layer<Real>::transport_rows(const PopulationView<Real>& f, Streaming streaming, int thread,
                                 std::int64_t first, std::int64_t last) {
    if (empty())
        return;
    const std::size_t begin = at(row_begins_[at(first)]);
    const std::size_t end = at(row_begins_[at(last)]);
    if (begin == end)
        return;
    const auto started = std::chrono::steady_clock::now();
    if (streaming == Streaming::arrived)
        transport_tiles<Streaming::arrived>(f, begin, end, thread);
    else
        transport_tiles<Streaming::turned>(f, begin, end, thread);
    transport_seconds_[at(thread)] +=
        std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
}

template <class Real>
template <Streaming streaming>
void Layer<Real>::transport_tiles(const PopulationView<Real>& f, std::size_t begin, std::size_t end,
                                  int thread) {
    const std::vector<std::int32_t>& list = band_.of_level(reach::receiving);
    const auto label_of = [&](std::size_t k) {
        return band_.tiles()[at(list[k])].label;
    };
    while (begin < end) {
        const int label = label_of(begin);
        std::size_t behind = begin + 1;
        while (behind < end && label_of(behind) == label)
            ++behind;
        TransportSums here; // the compiler knows that nothing else refers to it
        for_each_run<Real>(band_, list, static_cast<std::int64_t>(begin), static_cast<std::int64_t>(behind),
                           [&](const auto& t, std::size_t) { transport_tile<streaming>(f, t, here); });
        leaked_sums_.of(thread, label).merge(here.leaked);
        layer_sums_.of(thread, label).merge(here.layer);
        begin = behind;
    }
}

template <class Real>
template <Streaming streaming, class Tiles>
VESICA_INLINE void Layer<Real>::transport_tile(const PopulationView<Real>& f, const Tiles& t,
                                               TransportSums& sums) {
    using V = typename Tiles::V;
    V g[direction_count];
    for_each_direction([&](auto i) VESICA_INLINE_LAMBDA {
        g[i] = V::load(f.template arriving<streaming, decltype(i)::value>(t.cell()));
    });
    const V density = density_of(g);
    const auto blue_was_minor = sign_bit(t.load(fields_.chi));
    const MinorityAround<Real, V::width> fraction{blue_was_minor, around(fields_.chi, t)};
    const auto w = around(fields_.w, t);
    const auto gather = [&](const auto& fraction_around, const auto& w_around) VESICA_INLINE_LAMBDA {
        return gather_colours(g, V(settings_.reference_density), density, blue_was_minor, fraction_around,
                              w_around);
    };
    ColourDensities<V> arrived;
    if (solids_ == nullptr || !t.beside_solid()) [[likely]]
        arrived = gather(fraction, w);
    else
        arrived = gather_beside_solids(t, fraction, w, gather);
    const auto blue_is_minor = arrived.blue < arrived.red;
    const V minority = smaller(arrived.red, arrived.blue);
    const V kept = larger(minority, V(0));
    const auto holds_both = t.cells_of(reach::colour);
    const auto received = t.cells_of(reach::receiving);
    const V stays = select<Real>(holds_both, kept, V(0));
    const V gone = minority - stays;
    // Exact sums have a range: amounts are counted in cells' worth of fluid, whatever its density.
    const V lost = V(1.0 / settings_.reference_density) * select<Real>(blue_is_minor, -gone, gone);
    sums.leaked.add(select<Real>(received, lost, V(0)));
    const V chi = with_sign_bit<Real>(blue_is_minor, stays / density);
    sums.layer.add(select<Real>(holds_both, layer_density(chi), V(0)));
    t.store(chi, fields_.s); // neighbours still ask what was here
    t.store(density, fields_.density);
}

/// From a wall a cell's own colours return, and what its separation sent there with the opposite sign.
template <class Real>
template <class Tiles, class Fraction, class Flux, class Gather>
auto Layer<Real>::gather_beside_solids(const Tiles& t, const Fraction& fraction, const Vec3<Flux>& w,
                                       const Gather& gather) const {
    using V = typename Tiles::V;
    typename V::Mask solid[direction_count] = {};
    for (int i = 1; i < direction_count; ++i)
        solid[i] = V::mask(solids_->beside_tiles(t.cell() / tile_width, Tiles::count, i));
    const Vec3<V> own = t.load(fields_.w);
    using OwnFraction = Reflected<Real, V::width, Fraction>;
    using OwnFlux = Reflected<Real, V::width, Flux>;
    return gather(OwnFraction{fraction, fraction(Direction<0>{}), solid},
                  Vec3<OwnFlux>{{w.x, -own.x, solid}, {w.y, -own.y, solid}, {w.z, -own.z, solid}});
}

template <class Real>
void Layer<Real>::weigh(const PopulationView<Real>& f, Streaming streaming, int threads) {
    for_tiles(reach::receiving, threads, [&]<class Tiles>(const Tiles& t) {
        using V = typename Tiles::V;
        V g[direction_count];
        for (int i = 0; i < direction_count; ++i)
            g[i] = V::load(f.find(streaming, i, t.cell()));
        t.store(density_of(g), fields_.density);
    });
}

template <class Real>
double Layer<Real>::end_transport() {
    set_leaked();
    double seconds = 0.0;
    for (const double of_thread : transport_seconds_)
        seconds += of_thread;
    return seconds / static_cast<double>(transport_seconds_.size());
}

template <class Real>
void Layer<Real>::set_leaked() {
    if (empty())
        return;
    over_ranks_(
        ranks(), labels(),
        [&](int label, const std::array<double, 3>& values) {
            const auto [leaked, layer_sum, lost] = values;
            leaked_[at(label)] += settings_.reference_density * (leaked + lost);
            layer_sum_[at(label)] = layer_sum;
        },
        leaked_sums_, layer_sums_, crossing_sums_);
}

} // namespace vesica
