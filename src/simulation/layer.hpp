#pragma once

#include "case/parameters.hpp"
#include "collision/moments.hpp"
#include "colour/recolouring.hpp"
#include "geometry/curvature.hpp"
#include "geometry/laplace_beltrami.hpp"
#include "geometry/normal.hpp"
#include "geometry/paper_frames.hpp"
#include "lattice/populations.hpp"
#include "lattice/sliding_faces.hpp"
#include "membrane/layer_force.hpp"
#include "membrane/tension.hpp"
#include "parallel/for_each.hpp"
#include "parallel/neighbourhood.hpp"
#include "simulation/band_halo.hpp"
#include "simulation/engine_setup.hpp"
#include "simulation/layer_fields.hpp"
#include "simulation/layer_reach.hpp"
#include "simulation/layer_sums.hpp"
#include "simulation/membrane_model.hpp"
#include "simulation/shared_tiles.hpp"
#include "simulation/solid_margin.hpp"

#include <algorithm>
#include <array>
#include <functional>

namespace vesica {

/// The diffuse interface: carries the colours, finds the surface's geometry and turns it into forces. A step
/// is transport, along with the fluid, and then locate, normals, curvatures, slopes, forces, each a pass over
/// the tiles of its level. Every vesicle has a label, a phase field of its own against everything else, and a
/// band round it; where bands overlap a tile is worked on once for each.
template <class Real>
class Layer {
public:
    /// In the neighbourhood's block; all ranks make every call that is not const together. `solids` may be
    /// null (for all ranks) and must outlive the layer.
    Layer(std::shared_ptr<const Neighbourhood> neighbourhood, const LayerSettings& settings,
          const SolidCells* solids = nullptr)
        : neighbourhood_(std::move(neighbourhood)),
          settings_(settings),
          solids_(solids),
          spread_force_(settings.cutoff),
          band_(neighbourhood_->block(), solids),
          faces_(band_.grid(), neighbourhood_->block()),
          halo_(*neighbourhood_),
          interior_(static_cast<std::size_t>(band_.grid().tiles()), -1),
          force_slots_(static_cast<std::size_t>(band_.grid().tiles()), -1),
          colour_slots_(static_cast<std::size_t>(band_.grid().tiles()), -1),
          sums_(at(settings.labels)),
          leaked_(at(settings.labels), 0.0),
          layer_sum_(at(settings.labels), 0.0) {}
    /// In the whole of a periodic box.
    Layer(const Grid& box, const LayerSettings& settings)
        : Layer(std::make_shared<const Neighbourhood>(box.size()), settings) {}

    const Band& band() const { return band_; }
    const LayerFields<Real>& fields() const { return fields_; }
    const Field<Real>& force() const { return force_; }
    /// Per tile: the label of the vesicle it lies in, beyond that one's band; -1: none.
    const std::vector<std::int32_t>& interior() const { return interior_; }
    /// Per tile: where its forces begin in force(), -1 where there are none.
    const std::vector<std::int32_t>& force_slots() const { return force_slots_; }
    /// Where the force of one vesicle on a tile is, -1: there is none.
    std::int32_t force_slot(const BandTile& t) const {
        return own_force_slots_[at(&t - band_.tiles().data())];
    }
    /// Per tile: compact address of its colours in the one band that has it; outside_bands; or where it has
    /// several colours a shared_slot().
    const std::vector<std::int32_t>& colour_slots() const { return colour_slots_; }
    const SharedTiles& shared() const { return shared_; }
    /// Per compact tile: the label whose it is, -1 for those that no tile of the band has.
    const std::vector<std::int32_t>& slot_labels() const { return slot_labels_; }
    const std::vector<Band::Seed>& core() const { return laid_out_core_; }
    int labels() const { return settings_.labels; }
    const LayerSums& sums(int label) const { return sums_[at(label)]; }
    const LayerSettings& settings() const { return settings_; }
    bool empty() const { return empty_; } ///< on all ranks
    const Messages& messages() const { return halo_.messages(); }

    /// Per tile of the grid: bit k set where cell k belongs to a level of a band.
    std::vector<std::uint8_t> cells_of_level(int level) const {
        std::vector<std::uint8_t> bits(interior_.size(), 0);
        for (const BandTile& t : band_.tiles())
            bits[at(t.tile)] = static_cast<std::uint8_t>(bits[at(t.tile)] | t.bits[level]);
        return bits;
    }

    /// The vesicle inside which a cell lies without belonging to its band; -1: none.
    int owner_beyond_band(std::int64_t cell) const;
    /// body(CellColour) for all that a cell's state holds, by label: those whose band has it, and the vesicle
    /// inside which it lies.
    template <class Body>
    void for_each_cell_colour(std::int64_t cell, Body&& body) const;
    /// The most of them that any cell of the whole box has, at least one.
    int colours_per_cell() const { return colours_per_cell_; }
    /// Of the bands that have a cell in a level, the tile of the one whose membrane lies nearest; null: none.
    const BandTile* nearest_tile(std::int64_t cell, int level) const;
    /// body(label, rho_k/rho) for all vesicles that have a share of a cell.
    template <class Body>
    void for_each_share(std::int64_t cell, const Body& body) const;
    /// body(label, value of a compact array there) for all labels whose band has the cell's tile.
    template <class Body>
    void for_each_colour(std::int64_t cell, const std::span<Real>& array, const Body& body) const {
        for_each_tile_at(cell,
                         [&](const BandTile& t) { body(t.label, array[at(t.slot() + cell % tile_width)]); });
    }
    /// body(tile) for the tiles of all bands that a cell lies in, by label.
    template <class Body>
    void for_each_tile_at(std::int64_t cell, const Body& body) const {
        band_.for_each_label(cell / tile_width, [&](int, std::int32_t slot) {
            const std::int32_t index = slot_tiles_[at(slot / tile_width)];
            if (index >= 0) // an address may be there for the sake of ghosts alone
                body(band_.tiles()[at(index)]);
        });
    }

    std::size_t bytes() const;

    /// Lays the band out around `core`; chi_at(cell, label) gives the colours of a cell of the box by its
    /// grid index, and `interior`, per tile, the label of the vesicle that all of it lies in, or -1.
    template <class ChiAt>
    void place(const std::vector<Band::Seed>& core, const ChiAt& chi_at, std::vector<std::int32_t> interior,
               int threads) {
        forget_slots();
        interior_ = std::move(interior);
        lay_out(core, threads, [&](const BandTile& t, Real* chi) {
            for (int k = 0; k < tile_width; ++k)
                chi[k] = chi_at(t.cell + k, t.label);
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
    void weigh(const PopulationView<Real>& f, Streaming streaming, int threads);

    /// Where the surface is: s, the layer's area, and whether the core has left its place.
    /// What leaked out of the band is given back, in proportion to 1 - phi^2: mass is exact.
    void locate(int threads);

    /// Whether the band must be laid out anew.
    bool core_has_left() const { return core_has_left_ || (meets_images_ && slid_ != displacement_.whole); }

    /// The images above the box have moved on so far, cells.
    void slide_to(double displacement) {
        displacement_ = Displacement::of(displacement, band_.grid().size()[faces_.slide().velocity]);
    }
    /// Red that crosses sliding faces is counted on either side: what the blending between cells adds or
    /// takes leaks, and is given back. After the cells along the faces have done their step:
    void count_departing(const PopulationView<Real>& f, Streaming streaming, int threads);
    /// When everything has arrived, before end_transport():
    void count_arriving(const PopulationView<Real>& f, Streaming streaming, int threads);

    /// Lays the band out around where the core is now. Colours stay; what the band lets go of is given back
    /// by the next locate().
    void follow_core(const PopulationView<Real>& f, Streaming streaming, int threads);

    /// n = grad s/|grad s| (mapped) or -grad phi/|grad phi| (paper), and the segregation flux.
    void normals(int threads);
    /// H and K from the normals' derivatives, mapped to phi = 0.
    void curvatures(int threads);
    /// grad H0 along the surface.
    void slopes(int threads);

    /// H0 as Lap_s H asks for it: without the leading error of the derivative that made H of n.
    template <class Tiles>
    VESICA_INLINE typename Tiles::V mean_curvature(const Tiles& t) const {
        return mapped() ? sharpened<typename Tiles::V>(around(fields_.raw_H0, t), 1.0)
                        : t.load(fields_.raw_H0);
    }
    template <class Tiles>
    VESICA_INLINE typename Tiles::V laplace_beltrami_of_H(const Tiles& t) const {
        using V = typename Tiles::V;
        const Vec3<V> n = t.load(fields_.n);
        const Jacobian<V> d = jacobian<V>(around(fields_.g, t));
        if (mapped())
            return surface_divergence(d, n) / t.load(fields_.J);
        const auto H = around(fields_.raw_H0, t);
        return paper_laplace_beltrami(laplacian<V>(H), d, t.load(fields_.g), n, H(Direction<0>{}));
    }

    /// Forces of the labels' membranes, spread over their layers. Membranes are of one bending form.
    void forces(std::span<const Membrane> membranes, int threads);

    template <class Tiles>
    VESICA_INLINE Vec3<typename Tiles::V> phase_gradient(const Tiles& t) const {
        return gradient<typename Tiles::V>(PhaseAround<Real, Tiles::V::width>{around(fields_.chi, t)});
    }

private:
    static constexpr double purest =
        1e-8; ///< fraction that a pure cell is read as: s stays finite beyond the colours

    template <class Bending>
    void forces_of(std::span<const Membrane> membranes, int threads);
    void part_shared_colours(int threads);
    template <class Tiles>
    Vec3<typename Tiles::V> wetting_force(const Tiles& t) const;

    bool mapped() const { return settings_.recipe == GeometryRecipe::mapped; }

    static std::size_t at(std::int64_t index) { return static_cast<std::size_t>(index); }

    template <class V>
    static std::uint32_t bits_of(const typename V::Mask& mask) {
        std::uint32_t bits = 0;
        for (int k = 0; k < V::width; ++k)
            bits |= (mask[k] ? 1u : 0u) << k;
        return bits;
    }

    template <class V>
    VESICA_INLINE V density_of(const V (&g)[direction_count]) const {
        V sum = g[0];
        for_each_pair([&](auto i) VESICA_INLINE_LAMBDA { sum += g[i] + g[opposite(decltype(i)::value)]; });
        return V(settings_.reference_density) + sum;
    }

    template <Streaming streaming>
    void transport_tiles(const PopulationView<Real>& f, std::size_t begin, std::size_t end, int thread);
    template <Streaming streaming, class Tiles>
    VESICA_INLINE void transport_tile(const PopulationView<Real>& f, const Tiles& t, TransportSums& sums);

    template <class Tiles, class Fraction, class Flux, class Gather>
    auto gather_beside_solids(const Tiles& t, const Fraction& fraction, const Vec3<Flux>& w,
                              const Gather& gather) const;

    template <class Tiles>
    VESICA_INLINE Vec3<typename Tiles::V> outward_gradient(const Tiles& t) const {
        if (mapped())
            return gradient<typename Tiles::V>(around(fields_.sharp, t));
        return -phase_gradient(t);
    }

    /// Before the band is laid out anew.
    void forget_slots();
    /// colour(tile, chi) says which colours its eight cells have.
    template <class Colour>
    void lay_out(const std::vector<Band::Seed>& core, int threads, const Colour& colour);
    void number_slots();
    void number_rows();
    void count_colours();
    void count_plain_red();

    /// Cells that no longer hold both colours give up what they had of the minority.
    void let_go(const std::vector<BandTile>& tiles, const std::vector<Real>& chi,
                const std::vector<Real>& density);
    unsigned fluid_bits(std::int64_t tile) const {
        const unsigned own = band_.grid().interior_bits(band_.grid().tile_origin(tile));
        return solids_ != nullptr ? own & ~unsigned{solids_->of_tile(tile)} : own;
    }
    const BandTile* find_tile(const std::vector<BandTile>& tiles, std::int64_t tile, int label) const;

    const Ranks& ranks() const { return neighbourhood_->ranks(); }

    /// All that the areas' constraints ask for, and all that is to be given back: of all ranks.
    void set_integrals();
    void set_leaked();

    /// body(tiles) or body(tiles, index of the first, thread) for all tiles with cells in `level`.
    template <class Body>
    void for_tiles(int level, int threads, const Body& body) const {
        for_listed_tiles(band_.of_level(level), threads, body);
    }
    template <class Body>
    void for_listed_tiles(const std::vector<std::int32_t>& list, int threads, const Body& body) const {
        for_each_block(static_cast<std::int64_t>(list.size()), threads,
                       [&](int thread, std::int64_t begin, std::int64_t end) {
                           for_each_run<Real>(band_, list, begin, end,
                                              [&](const auto& tiles, std::size_t index) {
                                                  if constexpr (std::is_invocable_v<Body, decltype(tiles)>)
                                                      body(tiles);
                                                  else
                                                      body(tiles, index, thread);
                                              });
                       });
    }

    // What ghosts stand for: simulation/layer_ghosts.hpp.
    template <class Body>
    void share(int level, int threads, std::initializer_list<std::span<Real>> arrays, const Body& body);
    void extend_into_solids(std::initializer_list<std::span<Real>> arrays, int level, double slope,
                            int threads);
    void copy_ghosts(std::initializer_list<std::span<Real>> arrays, int threads);

    // Sliding faces: simulation/layer_slide.hpp.
    void join_images(const std::function<int(std::int64_t)>& owner_of);
    void list_face_tiles();
    void blend_slid_ghosts(std::initializer_list<std::span<Real>> arrays, int level, int threads);
    void colour_slid_ghosts(int threads);
    template <Streaming streaming>
    void count_departing(const PopulationView<Real>& f, int threads);
    template <Streaming streaming>
    void count_arriving(const PopulationView<Real>& f, int threads);
    template <class Count>
    void count_crossing(int threads, const Count& count);

    std::shared_ptr<const Neighbourhood> neighbourhood_;
    LayerSettings settings_;
    const SolidCells* solids_ = nullptr;
    LayerForce spread_force_;
    Band band_;
    SlidingFaces faces_;
    Displacement displacement_; ///< of the images above, now
    int slid_ = 0;              ///< the whole cells of it that the band was laid out for
    bool meets_images_ = false; ///< beyond a sliding face, on any rank
    BandHalo<Real> halo_;
    SolidMargin<Real> margin_;
    bool near_solids_ = false; ///< on any rank
    LayerFields<Real> fields_;
    Field<Real> force_;
    std::vector<std::int32_t> interior_;
    std::vector<std::int32_t> force_slots_;
    std::vector<std::int32_t> own_force_slots_; ///< per band tile
    std::vector<std::int32_t> colour_slots_;
    SharedTiles shared_;
    std::vector<std::int32_t> slot_labels_;
    std::vector<std::int32_t> slot_tiles_; ///< per compact tile: its index in the band, -1
    std::vector<Band::Seed> laid_out_core_;
    std::vector<std::uint8_t> laid_out_bits_; ///< per band tile: its cells in that core
    std::vector<std::uint8_t> core_bits_;     ///< per band tile: cells with a force now
    bool empty_ = true;
    bool have_arrived_ = false; ///< colours: they have streamed, and wait where s will be
    int colours_per_cell_ = 1;
    bool core_has_left_ = false; ///< one of them lies where there is no room for a force
    std::vector<std::int32_t>
        row_begins_; ///< per row of the box: its first tile in the receiving level's list
    std::vector<double> transport_seconds_; ///< per thread
    /// A tile along a sliding face where there is some red.
    struct FaceTile {
        std::int64_t cell = 0;
        int towards = 0;
        std::uint8_t bits = 0;
        std::int32_t index = -1; ///< of the band's tile; -1: outside
        std::int32_t label = 0;
    };
    std::vector<FaceTile> face_tiles_;
    // Of this rank's block:
    LabelSums<50> leaked_sums_;
    LabelSums<38> layer_sums_;
    LabelSums<38> crossing_sums_; ///< red that left through sliding faces less what came
    LabelSums<38> area_sums_;
    LabelSums<38> red_sums_; ///< rho_R/rho of the band's cells
    LabelSums<38> gaussian_sums_;
    LabelSums<38> square_sums_;
    LabelSums<20> plain_red_; ///< the other cells inside, laid out with the band
    SumsOverRanks over_ranks_;
    // Of all ranks, per label:
    std::vector<LayerSums> sums_;
    std::vector<double> leaked_;    ///< red mass to be given back
    std::vector<double> layer_sum_; ///< sum (1 - phi^2) it is shared by
    std::vector<Real> corrections_; ///< its share, per 1 - phi^2
};

} // namespace vesica

#include "simulation/layer_ghosts.hpp"
#include "simulation/layer_location.hpp"
#include "simulation/layer_slide.hpp"
