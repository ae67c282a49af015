#pragma once

#include "case/dense_field.hpp"
#include "case/engine_state.hpp"
#include "case/parameters.hpp"
#include "measure/snapshot.hpp"
#include "parallel/neighbourhood.hpp"
#include "simulation/step_profile.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vesica {

/// The first sign of a run going wrong.
struct Trouble {
    std::int64_t step = 0;
    Vec3<int> cell{};
    int vesicle = -1;  ///< -1: not in a vesicle's layer
    std::string cause; ///< density, speed, force or tension, with the number found and the one expected
};

/// The cells of a field that one rank has: its block, from `begin` on, with what lies behind walls.
struct FieldPart {
    Vec3<int> begin{};
    DenseField cells;
};

/// What a rank has sent to its neighbours since its engine was built.
struct RankTraffic {
    std::int64_t population_messages = 0;
    std::int64_t population_bytes = 0;
    std::int64_t band_messages = 0;
    std::int64_t band_bytes = 0;
};

/// One running simulation in one precision on one instruction set. Its implementation is chosen once, at
/// construction; a call per step is the only indirection. Where several ranks share a box, each has the
/// engine of its block, and step, snapshot, field, trouble and load are calls that all of them make together.
class Engine {
public:
    Engine() = default;
    Engine(const Engine&) = delete;
    Engine& operator=(const Engine&) = delete;
    virtual ~Engine() = default;

    virtual void step() = 0;
    virtual std::int64_t steps_done() const = 0;

    /// Of the whole box, for the rank that leads; the others have no vesicles in theirs.
    virtual Snapshot snapshot() const = 0;
    /// Some of its vesicles, so that nobody need hold all of them at once.
    virtual std::vector<VesicleSnapshot> vesicles(int first, int count) const;

    /// `name` is one of field_names(): phase, density, velocity, pressure, force, mean_curvature,
    /// gaussian_curvature, ... ; whole box for the rank that leads, empty for the others. Quantities that
    /// exist near the interface only are 0 elsewhere.
    virtual DenseField field(std::string_view name) const = 0;
    /// This rank's part of it, by itself.
    virtual FieldPart own_field(std::string_view name) const { return {{}, field(name)}; }

    /// The fluid's velocities at points, which need not lie in the box but in any of its images; between the
    /// cells around by their distances. NaN where there is no fluid. All ranks ask for the same.
    virtual std::vector<Vec3<double>> velocities(const std::vector<Vec3<double>>& places) const = 0;

    /// Looks for NaN or runaway values; cheap enough to be called every hundred steps.
    virtual std::optional<Trouble> trouble() const = 0;

    /// The state of this rank's block; and plane by plane, as long as the engine does not step.
    virtual EngineState save() const = 0;
    virtual std::unique_ptr<StatePlanes> planes() const;
    virtual void load(const EngineState& state) = 0;

    virtual std::size_t bytes_allocated() const = 0;
    virtual double interface_fraction() const = 0; ///< cells worked on near interfaces / all cells
    virtual std::string_view instruction_set() const = 0;
    virtual const StepProfile& profile() const = 0; ///< of the steps since construction
    virtual RankTraffic traffic() const { return {}; }
};

const std::vector<std::string>& field_names();

/// Builds the engine for these parameters and fills it with the initial state.
/// `instruction_set` is empty for the best one this machine has, or baseline, avx2, avx512.
std::unique_ptr<Engine> make_engine(const Parameters& parameters, int threads,
                                    std::string_view instruction_set = {});

/// The part of it that works on this rank's block; all ranks build theirs together.
std::unique_ptr<Engine> make_engine(const Parameters& parameters, int threads,
                                    std::shared_ptr<const Neighbourhood> neighbourhood,
                                    std::string_view instruction_set = {});

} // namespace vesica
