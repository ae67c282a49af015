#pragma once

#include "case/parameters.hpp"
#include "collision/moments.hpp"
#include "colour/recolouring.hpp"
#include "geometry/curvature.hpp"
#include "geometry/laplace_beltrami.hpp"
#include "geometry/normal.hpp"
#include "geometry/paper_frames.hpp"
#include "lattice/populations.hpp"
#include "membrane/layer_force.hpp"
#include "membrane/tension.hpp"
#include "parallel/for_each.hpp"
#include "parallel/lane_sum.hpp"
#include "simulation/engine_setup.hpp"
#include "simulation/layer_fields.hpp"
#include "simulation/layer_reach.hpp"
#include "simulation/membrane_model.hpp"

#include <algorithm>

namespace vesica {

/// Sums over a layer, independent of the order they are made in.
struct LayerSums {
    double raw_area = 0.0;              ///< sum (beta/2)(1 - phi^2)
    double gaussian_curvature = 0.0;    ///< int K dA
    double square_mean_curvature = 0.0; ///< int H^2 dA
};

/// What a thread's share of a transport amounts to; on a cache line of its own.
struct alignas(64) TransportSums {
    LaneSum<50> leaked; ///< red that left the band, in cells' worth of fluid
    LaneSum<38> layer;  ///< 1 - phi^2
    double seconds = 0.0;

    void merge(const TransportSums& other) {
        leaked.merge(other.leaked);
        layer.merge(other.layer);
        seconds += other.seconds;
    }
};

/// The diffuse interface: carries the colours, finds the surface's geometry and turns it into forces. A step
/// is transport, along with the fluid, and then locate, normals, curvatures, slopes, forces, each a pass over
/// the tiles of its level.
template <class Real>
class Layer {
public:
    using V = Pack<Real>;

    Layer(const Grid& grid, const LayerSettings& settings)
        : settings_(settings),
          spread_force_(settings.cutoff),
          band_(grid),
          inside_(static_cast<std::size_t>(grid.tiles()), 0),
          force_slots_(static_cast<std::size_t>(grid.tiles()), -1),
          colour_slots_(static_cast<std::size_t>(grid.tiles()), -1) {}

    const Band& band() const { return band_; }
    const LayerFields<Real>& fields() const { return fields_; }
    const Field<Real>& force() const { return force_; }
    const std::vector<std::uint8_t>& inside() const { return inside_; }
    const std::vector<std::int32_t>& force_slots() const { return force_slots_; }
    const std::vector<std::int32_t>& colour_slots() const { return colour_slots_; }
    const std::vector<Band::Seed>& core() const { return laid_out_core_; }
    const LayerSums& sums() const { return sums_; }
    const LayerSettings& settings() const { return settings_; }
    bool empty() const { return band_.tiles().empty(); }

    /// Per tile of the grid: bit k set where cell k belongs to a level of the band.
    std::vector<std::uint8_t> cells_of_level(int level) const {
        std::vector<std::uint8_t> bits(inside_.size(), 0);
        for (const BandTile& t : band_.tiles())
            bits[at(t.tile)] = t.bits[level];
        return bits;
    }

    std::size_t bytes() const {
        return band_.bytes() + fields_.bytes() + force_.bytes() + inside_.capacity() +
               (force_slots_.capacity() + colour_slots_.capacity()) * sizeof(std::int32_t) +
               core_bits_.capacity() + row_begins_.capacity() * sizeof(std::int32_t) +
               transport_sums_.capacity() * sizeof(TransportSums);
    }

    /// Lays the band out around `core`; chi_at(cell) gives the colours of a cell of the box by its grid
    /// index, and `inside` says which side every cell lies on.
    template <class ChiAt>
    void place(const std::vector<Band::Seed>& core, const ChiAt& chi_at, std::vector<std::uint8_t> inside,
               int threads) {
        inside_ = std::move(inside);
        lay_out(core);
        for_each_index(static_cast<std::int64_t>(band_.tiles().size()), threads, [&](std::int64_t index) {
            const BandTile& t = band_.tiles()[at(index)];
            for (int k = 0; k < tile_width; ++k) {
                Real& chi = fields_.chi[at(t.slot() + k)];
                const bool red = (inside_[at(t.tile)] >> k & 1) != 0;
                chi =
                    (t.bits[reach::colour] >> k & 1) != 0 ? chi_at(t.cell + k) : with_sign_bit(red, Real(0));
            }
        });
    }

    /// The colours move with the populations that are being streamed: between begin_transport() and
    /// end_transport() every row of the box is handed in once, when its populations have settled. Rows are
    /// numbered y + size.y z; threads do not meet.
    void begin_transport(int threads);
    void transport_rows(const PopulationView<Real>& f, Streaming streaming, int thread, std::int64_t first,
                        std::int64_t last);
    /// Returns the seconds it took, of the threads' mean.
    double end_transport();

    /// Density of every cell that needs it, from the populations; transport does the same on its way.
    void weigh(const PopulationView<Real>& f, Streaming streaming, int threads) {
        for_tiles(reach::receiving, threads, [&](const BandTile& t) {
            V g[direction_count];
            for (int i = 0; i < direction_count; ++i)
                g[i] = load_shifted(f, streaming, i, t.cell);
            density_of(g).store(fields_.density.data() + t.slot());
        });
    }

    /// Where the surface is: s, the layer's area, and whether the core has left its place.
    /// What leaked out of the band is given back, in proportion to 1 - phi^2: mass is exact.
    void locate(int threads) {
        constexpr double purest =
            1e-8; // fraction that a pure cell is read as: s stays finite beyond the colours
        const V correction = V(layer_sum_ > 0.0 ? leaked_ / layer_sum_ : 0.0);
        std::vector<LaneSum<38>> area(static_cast<std::size_t>(threads));
        struct alignas(64) Departed {
            unsigned bits = 0;
        };
        std::vector<Departed> departed(static_cast<std::size_t>(threads));
        core_bits_.resize(band_.tiles().size());
        for_tiles(Band::outermost, threads, [&](const BandTile& t, std::size_t index, int thread) {
            const V density = V::load(fields_.density.data() + t.slot());
            V chi = V::load(fields_.chi.data() + t.slot());
            const auto holds_both = V::mask(t.bits[reach::colour]);
            // The side stays as it is: a pure red cell is -0, and -0 plus a zero share of the correction
            // would be +0, blue.
            const V corrected =
                with_sign_bit<Real>(sign_bit(chi), chi + correction * layer_density(chi) / density);
            chi = select<Real>(holds_both, corrected, chi);
            chi.store(fields_.chi.data() + t.slot());
            red_fraction(chi).store(fields_.red.data() + t.slot());
            blue_fraction(chi).store(fields_.blue.data() + t.slot());
            signed_distance_of(chi, V(purest), settings_.beta).store(fields_.s.data() + t.slot());
            spread_force_.profile(phase_of(chi)).store(fields_.psi.data() + t.slot());
            const V layer = layer_density(chi);
            area[at(thread)].add(select<Real>(holds_both, V(0.5 * settings_.beta) * layer, V(0)));
            core_bits_[index] = bits_of((layer > V(settings_.cutoff)) & holds_both);
            departed[at(thread)].bits |= core_bits_[index] & ~unsigned{t.bits[reach::force]};
        });
        sums_.raw_area = merged(area);
        core_has_left_ = std::any_of(departed.begin(), departed.end(),
                                     [](const Departed& cells) { return cells.bits != 0; });
        leaked_ = 0.0;
        exchange({fields_.chi, fields_.red, fields_.blue, fields_.s, fields_.psi}, threads);
    }

    bool core_has_left() const { return core_has_left_; }

    /// Lays the band out around where the core is now. Colours stay; what the band lets go of is given back
    /// by the next locate().
    void follow_core(const PopulationView<Real>& f, Streaming streaming, int threads);

    /// n = grad s/|grad s| (mapped) or -grad phi/|grad phi| (paper), and the segregation flux.
    void normals(int threads) {
        if (mapped()) {
            for_tiles(reach::receiving, threads, [&](const BandTile& t) { // normals differentiate it
                sharpened<V>(around(fields_.s, t), 1.0).store(fields_.sharp.data() + t.slot());
            });
            exchange({fields_.sharp}, threads);
        }
        for_tiles(reach::colour, threads, [&](const BandTile& t) {
            const Vec3<V> n = unit_vector(outward_gradient(t));
            const V chi = V::load(fields_.chi.data() + t.slot());
            const V density = V::load(fields_.density.data() + t.slot());
            store(n, fields_.n, t);
            store(segregation_flux(chi, density, n, settings_.beta), fields_.w, t);
        });
        exchange({fields_.n[0], fields_.n[1], fields_.n[2], fields_.w[0], fields_.w[1], fields_.w[2]},
                 threads);
    }

    /// H and K from the normals' derivatives, mapped to phi = 0.
    void curvatures(int threads) {
        std::vector<LaneSum<38>> gaussian(static_cast<std::size_t>(threads));
        std::vector<LaneSum<38>> square(static_cast<std::size_t>(threads));
        for_tiles(reach::raw_curvature, threads, [&](const BandTile& t, std::size_t, int thread) {
            const Vec3<V> n = load(fields_.n, t);
            const Jacobian<V> G = jacobian<V>(around(fields_.n, t));
            const V s = V::load(fields_.s.data() + t.slot());
            const Curvatures<V> here = mapped() ? curvatures_of(G, n) : paper_curvatures_of(G, n);
            const Curvatures<V> surface = mapped() ? map_to_mid_surface(here, s) : here;
            surface.H.store(fields_.raw_H0.data() + t.slot());
            if (!mapped())
                surface.H.store(fields_.H0.data() + t.slot());
            surface.K.store(fields_.K0.data() + t.slot());
            (mapped() ? area_to_mid_surface(here, s) : V(1)).store(fields_.J.data() + t.slot());
            const V weight = V(0.5 * settings_.beta) * layer_density(V::load(fields_.chi.data() + t.slot()));
            const auto counted = V::mask(t.bits[reach::raw_curvature]);
            gaussian[at(thread)].add(select<Real>(counted, weight * here.K, V(0)));
            square[at(thread)].add(select<Real>(counted, weight * here.H * here.H, V(0)));
        });
        sums_.gaussian_curvature = merged(gaussian);
        sums_.square_mean_curvature = merged(square);
        exchange({fields_.raw_H0}, threads);
        if (!mapped())
            return;
        for_tiles(reach::curvature, threads, [&](const BandTile& t) {
            const TileAround<Real> H = around(fields_.raw_H0, t);
            sharpened<V>(H, 1.0).store(fields_.H0.data() + t.slot());    // the derivative that made H of n
            sharpened<V>(H, 3.0).store(fields_.sharp.data() + t.slot()); // and the two that make Lap_s H of H
        });
        exchange({fields_.sharp}, threads);
    }

    /// grad H0 along the surface.
    void slopes(int threads) {
        for_tiles(reach::slope, threads, [&](const BandTile& t) {
            if (!mapped()) {
                store(gradient<V>(around(fields_.raw_H0, t)), fields_.g, t);
                return;
            }
            const Vec3<V> n = load(fields_.n, t);
            const Vec3<V> g = tangential(gradient<V>(around(fields_.sharp, t)), n);
            const V s = V::load(fields_.s.data() + t.slot());
            const V J = V::load(fields_.J.data() + t.slot());
            store(flux_on_mid_surface(g, jacobian<V>(around(fields_.n, t)), n, s, J), fields_.g, t);
        });
        exchange({fields_.g[0], fields_.g[1], fields_.g[2]}, threads);
    }

    VESICA_INLINE V laplace_beltrami_of_H(const BandTile& t) const {
        const Vec3<V> n = load(fields_.n, t);
        const Jacobian<V> d = jacobian<V>(around(fields_.g, t));
        if (mapped())
            return surface_divergence(d, n) / V::load(fields_.J.data() + t.slot());
        const TileAround<Real> H = around(fields_.raw_H0, t);
        return paper_laplace_beltrami(laplacian<V>(H), d, load(fields_.g, t), n, H(Direction<0>{}));
    }

    /// Membrane forces, spread over the layer.
    void forces(const Membrane& membrane, int threads) {
        std::visit([&](const auto& bending) { forces_of(bending, TensionLaw{membrane.tension()}, threads); },
                   membrane.bending);
    }

    VESICA_INLINE Vec3<V> phase_gradient(const BandTile& t) const {
        return gradient<V>(PhaseAround<Real>{{fields_.chi.data(), t.rows}});
    }

    VESICA_INLINE static Vec3<V> load(const std::span<Real> (&a)[3], const BandTile& t) {
        return {V::load(a[0].data() + t.slot()), V::load(a[1].data() + t.slot()),
                V::load(a[2].data() + t.slot())};
    }

private:
    template <class Bending>
    void forces_of(const Bending& bending, const TensionLaw& tension, int threads) {
        const FieldView<Real> force = force_.view();
        for_tiles(reach::force, threads, [&](const BandTile& t) {
            const V H = V::load(fields_.H0.data() + t.slot());
            const V K = V::load(fields_.K0.data() + t.slot());
            const V normal_force = bending.force(H, K, laplace_beltrami_of_H(t)) + tension.force(H);
            const Vec3<V> slope = gradient<V>(around(fields_.psi, t));
            const Vec3<V> F = spread_force_(slope, normal_force);
            const auto here = V::mask(t.bits[reach::force]);
            select<Real>(here, F.x, V(0)).store(force.component(0) + t.slot());
            select<Real>(here, F.y, V(0)).store(force.component(1) + t.slot());
            select<Real>(here, F.z, V(0)).store(force.component(2) + t.slot());
        });
    }

    bool mapped() const { return settings_.recipe == GeometryRecipe::mapped; }

    static std::size_t at(std::int64_t index) { return static_cast<std::size_t>(index); }

    static std::uint8_t bits_of(const typename V::Mask& mask) {
        unsigned bits = 0;
        for (int k = 0; k < tile_width; ++k)
            bits |= (mask[k] ? 1u : 0u) << k;
        return static_cast<std::uint8_t>(bits);
    }

    VESICA_INLINE V density_of(const V (&g)[direction_count]) const {
        V sum = g[0];
        for_each_pair([&](auto i) VESICA_INLINE_LAMBDA { sum += g[i] + g[opposite(decltype(i)::value)]; });
        return V(settings_.reference_density) + sum;
    }

    static V load_shifted(const PopulationView<Real>& f, Streaming streaming, int i, std::int64_t cell) {
        return V::load(f.find(streaming, i, cell));
    }

    template <Streaming streaming>
    void transport_tiles(const PopulationView<Real>& f, std::size_t begin, std::size_t end,
                         TransportSums& sums);
    template <Streaming streaming>
    VESICA_INLINE void transport_tile(const PopulationView<Real>& f, const BandTile& t, TransportSums& sums);

    VESICA_INLINE Vec3<V> outward_gradient(const BandTile& t) const {
        if (mapped())
            return gradient<V>(around(fields_.sharp, t));
        return -phase_gradient(t);
    }

    void set_side(std::int64_t tile, int k, bool red) {
        const auto bit = static_cast<std::uint8_t>(1u << k);
        std::uint8_t& bits = inside_[at(tile)];
        bits = static_cast<std::uint8_t>(red ? bits | bit : bits & ~bit);
    }

    void lay_out(const std::vector<Band::Seed>& core);
    void number_rows();

    /// Cells that no longer hold both colours give up what they had of the minority.
    void let_go(const std::vector<BandTile>& tiles, const std::vector<Real>& chi,
                const std::vector<Real>& density, const std::vector<std::uint8_t>& kept);

    template <class Sum>
    static double merged(const std::vector<Sum>& parts) {
        Sum total;
        for (const Sum& part : parts)
            total.merge(part);
        return total.value();
    }

    VESICA_INLINE static void store(const Vec3<V>& value, std::span<Real> (&a)[3], const BandTile& t) {
        value.x.store(a[0].data() + t.slot());
        value.y.store(a[1].data() + t.slot());
        value.z.store(a[2].data() + t.slot());
    }

    VESICA_INLINE static TileAround<Real> around(const std::span<Real>& a, const BandTile& t) {
        return {a.data(), t.rows};
    }
    VESICA_INLINE static Vec3<TileAround<Real>> around(const std::span<Real> (&a)[3], const BandTile& t) {
        return {{a[0].data(), t.rows}, {a[1].data(), t.rows}, {a[2].data(), t.rows}};
    }

    /// body(tile) or body(tile, index, thread) for every tile with cells in `level`.
    template <class Body>
    void for_tiles(int level, int threads, const Body& body) const {
        const std::vector<std::int32_t>& list = band_.of_level(level);
        for_each_block(static_cast<std::int64_t>(list.size()), threads,
                       [&](int thread, std::int64_t begin, std::int64_t end) {
                           for (std::int64_t k = begin; k < end; ++k) {
                               const std::size_t index = at(list[at(k)]);
                               if constexpr (std::is_invocable_v<Body, const BandTile&>)
                                   body(band_.tiles()[index]);
                               else
                                   body(band_.tiles()[index], index, thread);
                           }
                       });
        static_cast<void>(threads);
    }

    /// Ghost cells of the band take the values of the cells they mirror.
    void exchange(std::initializer_list<std::span<Real>> arrays, int threads) {
        const std::vector<Band::GhostCopy>& copies = band_.ghost_copies();
        if (copies.empty())
            return;
        for_each_block(static_cast<std::int64_t>(copies.size()), threads,
                       [&](int, std::int64_t begin, std::int64_t end) {
                           for (const std::span<Real>& array : arrays)
                               for (std::int64_t k = begin; k < end; ++k)
                                   array[at(copies[at(k)].to)] = array[at(copies[at(k)].from)];
                       });
    }

    LayerSettings settings_;
    LayerForce spread_force_;
    Band band_;
    LayerFields<Real> fields_;
    Field<Real> force_;
    std::vector<std::uint8_t>
        inside_; ///< per tile: which cells lie on red's side, kept for cells outside the band
    std::vector<std::int32_t> force_slots_; ///< per tile: compact address of forces, -1 where there are none
    std::vector<std::int32_t>
        colour_slots_; ///< per tile: of colours, -1 for tiles addressed for ghosts alone
    std::vector<Band::Seed> laid_out_core_;
    std::vector<std::uint8_t> core_bits_; ///< per band tile: cells with a force now
    bool core_has_left_ = false;          ///< one of them lies where there is no room for a force
    std::vector<std::int32_t>
        row_begins_; ///< per row of the box: its first tile in the receiving level's list
    std::vector<TransportSums> transport_sums_; ///< per thread
    LayerSums sums_;
    double leaked_ = 0.0;    ///< red mass to be given back
    double layer_sum_ = 0.0; ///< sum (1 - phi^2) it is shared by
};

} // namespace vesica
