#pragma once

#include "boundary/bounce_back.hpp"
#include "boundary/lees_edwards.hpp"
#include "collision/paper_mrt.hpp"
#include "collision/symmetric_mrt.hpp"
#include "lattice/unwrap.hpp"
#include "simulation/colour_sums.hpp"
#include "simulation/engine.hpp"
#include "simulation/engine_extremes.hpp"
#include "simulation/engine_setup.hpp"
#include "simulation/fluid_step.hpp"
#include "simulation/layer_forces.hpp"
#include "simulation/layer_geometry.hpp"
#include "simulation/layer_placement.hpp"
#include "simulation/layer_transport.hpp"
#include "simulation/step_profile.hpp"
#include "simulation/wall_forces.hpp"

#include <optional>

namespace vesica {

template <class Real>
using AnyFluidStep =
    std::variant<FluidStep<Real, RegularisedCollision>, FluidStep<Real, SymmetricMrt<TwoRelaxationTimes>>,
                 FluidStep<Real, SymmetricMrt<FreeGhostRates>>, FluidStep<Real, PaperMrt>,
                 FluidStep<Real, SymmetricMrt<SingleRelaxationTime>>>;

/// The case's words for the ghost rates become a collision, once.
template <class Real>
struct MakeFluidStep {
    const Grid& grid;
    const PopulationView<Real>& f;
    const EngineSetup& setup;

    AnyFluidStep<Real> operator()(const RegularisedGhosts&) const { return make(RegularisedCollision{}); }
    AnyFluidStep<Real> operator()(const TrtGhosts& ghosts) const {
        return make(SymmetricMrt<TwoRelaxationTimes>{{ghosts.magic}});
    }
    AnyFluidStep<Real> operator()(const SymmetricGhosts& ghosts) const {
        return make(SymmetricMrt<FreeGhostRates>{
            {ghosts.odd_vector, ghosts.odd_twist, ghosts.even_scalar, ghosts.even_tensor}});
    }
    AnyFluidStep<Real> operator()(const PaperGhosts& ghosts) const {
        return make(PaperMrt{ghosts.l10, ghosts.l11, ghosts.l14, ghosts.l17});
    }
    AnyFluidStep<Real> operator()(const BgkGhosts&) const {
        return make(SymmetricMrt<SingleRelaxationTime>{});
    }

private:
    template <class Collision>
    AnyFluidStep<Real> make(const Collision& collision) const {
        return FluidStep<Real, Collision>(grid, f, collision, setup.outer_rate, setup.reference_density);
    }
};

/// The simulation in one precision, for one instruction set: the block of one rank, in step with the others.
template <class Real>
class LatticeEngine final : public Engine {
public:
    using V = Pack<Real>;

    explicit LatticeEngine(const EngineSetup& setup)
        : setup_(setup),
          block_(setup.neighbourhood->block()),
          grid_(block_.own.size),
          populations_(direction_count, grid_.cells()),
          f_(populations_.view(), grid_),
          solids_(solids_of(setup.drive, block_)),
          walls_(walls_of(setup.drive)),
          fluid_(std::visit(MakeFluidStep<Real>{grid_, f_, setup}, setup.ghosts)),
          layer_(setup.neighbourhood, setup.layer, solids()) {
        for (const VesicleSetup& vesicle : setup_.vesicles) {
            membranes_.push_back(vesicle.membrane);
            const double thinning = thinness_of(vesicle.inner_rate) - thinness_of(setup_.outer_rate);
            inner_.push_back({pure_rate<Real>(setup_.outer_rate, thinning), thinning, vesicle.buoyancy});
            has_contrast_ = has_contrast_ || vesicle.inner_rate != setup_.outer_rate;
            is_buoyant_ = is_buoyant_ || vesicle.buoyancy != Vec3<double>{};
        }
        if (!block_.is_whole())
            others_.emplace(*setup_.neighbourhood, f_, grid_);
        if (block_.slide)
            sliding_.emplace(f_, grid_, block_, setup_.reference_density);
        fill_at_rest();
        remember_walls();
        slide_layer();
        if (setup_.colours != nullptr) {
            layer_.place(
                setup_.colours->core(),
                [&](std::int64_t cell, int label) {
                    return static_cast<Real>(setup_.colours->chi_at(cell, label));
                },
                setup_.colours->interior(), setup_.threads);
            layer_.weigh(f_, streaming_, setup_.threads);
            layer_.locate(setup_.threads);
            find_geometry();
            push_fluid();
        }
    }

    void step() override {
        collide_and_stream(); // feeling the membrane's force; the colours are carried along
        if (!layer_.empty()) {
            slide_layer();
            locate_surface(); // where it is, how large it is
            find_geometry();  // normals, curvatures
            push_fluid();     // bending, tension, the area's constraint
        }
        concede_waiting();
        clock_.leave(static_cast<double>(grid_.volume()), static_cast<double>(layer_.band().cell_count()));
    }

    std::int64_t steps_done() const override { return step_; }
    Snapshot snapshot() const override;
    std::vector<VesicleSnapshot> vesicles(int first, int count) const override;
    DenseField field(std::string_view name) const override;
    FieldPart own_field(std::string_view name) const override {
        return {block_.own.begin, field_of_block(name)};
    }
    std::vector<Vec3<double>> velocities(const std::vector<Vec3<double>>& places) const override;
    std::optional<Trouble> trouble() const override;
    EngineState save() const override;
    std::unique_ptr<StatePlanes> planes() const override;
    void load(const EngineState& state) override;

    std::size_t bytes_allocated() const override {
        return populations_.bytes() + layer_.bytes() + solids_.bytes() + walls_.bytes();
    }
    double interface_fraction() const override {
        return static_cast<double>(layer_.band().cell_count()) / static_cast<double>(grid_.volume());
    }
    RankTraffic traffic() const override;
    std::string_view instruction_set() const override { return setup_.instruction_set; }
    const StepProfile& profile() const override { return clock_.profile(); }

private:
    class Planes;

    const Ranks& ranks() const { return setup_.neighbourhood->ranks(); }

    /// What was waited for other ranks since the last time is no part of the work.
    double seconds_waiting() const {
        return ranks().seconds_summing() + layer_.messages().seconds_waiting() +
               (others_ ? others_->messages().seconds_waiting() : 0.0);
    }
    void concede_waiting() {
        const double waited = seconds_waiting();
        clock_.concede(StepPart::waiting, waited - waited_);
        waited_ = waited;
    }
    void enter(StepPart part) {
        concede_waiting();
        clock_.enter(part);
    }

    void locate_surface() {
        enter(StepPart::locate);
        layer_.locate(setup_.threads);
        if (layer_.core_has_left()) {
            enter(StepPart::follow);
            layer_.follow_core(f_, streaming_, setup_.threads);
            layer_.locate(setup_.threads);
        }
    }

    void find_geometry() {
        enter(StepPart::normals);
        layer_.normals(setup_.threads);
        enter(StepPart::curvatures);
        layer_.curvatures(setup_.threads);
        enter(StepPart::slopes);
        layer_.slopes(setup_.threads);
    }

    void push_fluid() {
        enter(StepPart::forces);
        hold_areas();
        answer_buoyancy();
        layer_.forces(membranes_, setup_.threads);
    }

    void collide_and_stream() {
        waited_ = seconds_waiting();
        clock_.begin(StepPart::fluid);
        layer_.begin_transport(setup_.threads);
        const Streaming streamed = after_step(streaming_);
        const auto carry_colours = [&](int thread, std::int64_t first_row, std::int64_t last_row) {
            layer_.transport_rows(f_, streamed, thread, first_row, last_row);
        };
        RankBoundary<Real>* const others = others_ ? &*others_ : nullptr;
        if (solids_)
            walls_.set_walls(setup_.drive.walls(step_));
        FlowInfluence<Real> flow{body_force(), solids(), solids_ ? &walls_ : nullptr};
        if (sliding_) {
            sliding_->set(setup_.drive.displacement(step_), setup_.drive.slide_speed(step_));
            flow.sliding = &*sliding_;
            flow.on_departure = [this] {
                layer_.count_departing(f_, streaming_, setup_.threads);
            };
        }
        std::visit(
            [&](const auto& fluid) {
                fluid(streaming_, influence(), flow, others, setup_.threads, carry_colours);
            },
            fluid_);
        if (sliding_)
            layer_.count_arriving(f_, streamed, setup_.threads);
        clock_.concede(StepPart::transport, layer_.end_transport());
        streaming_ = streamed;
        ++step_;
    }

    /// Where the images are now is where the layer's ghosts are looked for.
    void slide_layer() {
        if (sliding_)
            layer_.slide_to(setup_.drive.displacement(step_));
    }

    void hold_areas() {
        for (std::size_t label = 0; label < membranes_.size(); ++label)
            membranes_[label].hold_area(corrected_area(layer_.sums(static_cast<int>(label))), step_);
    }

    /// The measured area without the layer's excess, as measure/layer_moment.hpp states it.
    double corrected_area(const LayerSums& sums) const {
        const double spheres = std::round(sums.gaussian_curvature / (4.0 * pi));
        const LayerMoments& excess = setup_.layer_moments;
        return sums.raw_area - 4.0 * pi * spheres * excess.area - excess.bending * sums.square_mean_curvature;
    }

    LayerInfluence<Real> influence() const {
        LayerInfluence<Real> influence;
        if (layer_.empty())
            return influence;
        influence.force_slot = layer_.force_slots().data();
        influence.force = layer_.force().view();
        influence.contrast = has_contrast_;
        influence.buoyant = is_buoyant_;
        influence.inner = inner_.data();
        influence.colour_slot = layer_.colour_slots().data();
        influence.label = layer_.slot_labels().data();
        influence.interior = layer_.interior().data();
        influence.shared = &layer_.shared();
        influence.chi = layer_.fields().chi.data();
        return influence;
    }

    static SolidCells solids_of(const FlowDrive& drive, const Block& block) {
        if (!drive.has_solids())
            return {};
        return SolidCells(block, [&](const Vec3<int>& cell) { return drive.is_solid(cell); });
    }
    BounceBack<Real> walls_of(const FlowDrive& drive) const {
        if (!drive.has_solids())
            return {};
        return BounceBack<Real>(
            f_, grid_, block_, solids_, FlowDrive::wall_count,
            [&](const Vec3<int>& cell, int direction) { return drive.link(cell, direction); },
            setup_.reference_density);
    }
    const SolidCells* solids() const { return solids_ ? &solids_ : nullptr; }

    /// The walls as they were in the last step; before the first they have done nothing.
    void remember_walls() {
        if (!solids_)
            return;
        auto walls = setup_.drive.walls(step_ - 1);
        for (WallState& wall : walls)
            wall.strength = step_ > 0 ? wall.strength : 0.0;
        walls_.set_walls(walls);
    }

    /// In a periodic box nothing else would hold what the vesicles' buoyancy gives the fluid.
    void answer_buoyancy() {
        if (setup_.drive.has_solids() || !is_buoyant_)
            return;
        answer_ = {};
        for (std::size_t label = 0; label < inner_.size(); ++label)
            answer_ = answer_ + (-layer_.sums(static_cast<int>(label)).red /
                                 static_cast<double>(setup_.drive.fluid_cells())) *
                                    inner_[label].buoyancy;
    }
    /// What pushes every cell at present.
    Vec3<double> body_force() const { return setup_.drive.body_force(step_) + answer_; }

    void fill_at_rest() {
        const FieldView<Real> f = populations_.view();
        const std::int64_t row = grid_.row_stride();
        for_each_index(grid_.rows(), setup_.threads, [&](std::int64_t r) {
            for (int i = 0; i < direction_count; ++i)
                std::fill_n(f.component(i) + r * row, row, Real(0));
        });
    }

    Moments<double> moments_at(std::int64_t cell) const {
        double g[direction_count];
        for (int i = 0; i < direction_count; ++i)
            g[i] = static_cast<double>(*f_.find(streaming_, i, cell));
        return moments_of(g);
    }

    /// Everything that pushes a cell.
    Vec3<double> whole_force_at(std::int64_t cell) const {
        Vec3<double> force = force_at(cell) + body_force();
        if (is_buoyant_ && !layer_.empty())
            layer_.for_each_share(cell, [&](int label, double share) {
                force = force + share * inner_[static_cast<std::size_t>(label)].buoyancy;
            });
        return force;
    }

    /// The membrane's.
    Vec3<double> force_at(std::int64_t cell) const {
        const std::int32_t slot =
            layer_.empty() ? -1 : layer_.force_slots()[static_cast<std::size_t>(cell / tile_width)];
        if (slot < 0)
            return {};
        const auto at = slot + cell % tile_width;
        const FieldView<const Real> F = layer_.force().view();
        return {static_cast<double>(F.component(0)[at]), static_cast<double>(F.component(1)[at]),
                static_cast<double>(F.component(2)[at])};
    }

    Extremes extremes() const;
    DenseField field_of_block(std::string_view name) const;
    DenseField gathered(const DenseField& part) const;
    DenseField cropped(DenseField field) const;
    std::optional<Vec3<int>> cell_at_open_end() const;
    int vesicle_at(const Vec3<int>& place) const;
    std::vector<Vec3<double>> middles() const;
    VesicleSnapshot described(std::size_t label) const;
    std::optional<SlidingImages> sliding_images() const;
    struct LayerCell;
    struct LabelledSpan;
    struct LabelRange {
        int begin = 0;
        int end = 0;

        bool has(int label) const { return label >= begin && label < end; }
    };
    std::vector<LayerCell> layer_cells(const LabelRange& labels) const;
    double distance_to_obstacle(const InterfaceCell& cell, std::int64_t index) const;
    std::vector<LabelledSpan> inside_spans(const LabelRange& labels) const;
    std::vector<ColourSums> colour_sums(const std::vector<LayerCell>& cells,
                                        const std::vector<LabelledSpan>& inside,
                                        const std::vector<Unwrap>& unwraps) const;

    /// body(place in the block's canonical order z, y, x; index in the grid)
    template <class Body>
    void for_each_cell_of_block(const Body& body) const {
        std::size_t at = 0;
        for (int z = 0; z < grid_.size().z; ++z)
            for (int y = 0; y < grid_.size().y; ++y)
                for (int x = 0; x < grid_.size().x; ++x)
                    body(at++, grid_.index(x, y, z));
    }

    static constexpr double pi = 3.14159265358979323846;

    EngineSetup setup_;
    Block block_;
    Grid grid_;
    Field<Real> populations_;
    PopulationView<Real> f_;
    SolidCells solids_;
    BounceBack<Real> walls_;
    Vec3<double> answer_{}; ///< to the buoyancy, per volume
    AnyFluidStep<Real> fluid_;
    Layer<Real> layer_;
    std::optional<RankBoundary<Real>> others_; ///< none where the block meets no images in messages
    std::optional<LeesEdwards<Real>> sliding_; ///< where the box slides past its images
    std::vector<Membrane> membranes_;          ///< by label
    std::vector<InnerFluid> inner_;            ///< by label
    bool has_contrast_ = false;                ///< some fluid inside is of another viscosity
    bool is_buoyant_ = false;
    Streaming streaming_ = Streaming::arrived;
    std::int64_t step_ = 0;
    StepClock clock_;
    double waited_ = 0.0; ///< for other ranks, as far as it has been conceded
};

} // namespace vesica
