#pragma once

#include "case/flow_parameters.hpp"
#include "case/solid_voxels.hpp"
#include "core/vec3.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

/// A case in lattice units (cell = step = 1): what the simulation is built from. No files, no SI units, no
/// places in the input: `case/case.hpp` and `io` take care of those.
namespace vesica {

struct TriangleMesh; // case/triangle_mesh.hpp

// Relaxation of the ghost modes in the t-orthogonal basis, where every ghost equilibrium is zero.

/// All ghost rates one.
struct RegularisedGhosts {
    friend bool operator==(const RegularisedGhosts&, const RegularisedGhosts&) = default;
};
/// Even ghosts relax like the stress; odd ones by the magic number.
struct TrtGhosts {
    double magic = 0.1875;

    friend bool operator==(const TrtGhosts&, const TrtGhosts&) = default;
};
struct SymmetricGhosts {      ///< free rates, one per cubic family of ghost modes
    double even_scalar = 1.0; ///< 3c^4 - 6c^2 + 1
    double even_tensor = 1.0; ///< (2c^2 - 3)(3c_x^2 - c^2), (2c^2 - 3)(c_y^2 - c_z^2)
    double odd_vector = 1.0;  ///< (3c^2 - 5) c_a
    double odd_twist = 1.0;   ///< (c_y^2 - c_z^2) c_x and cyclic

    friend bool operator==(const SymmetricGhosts&, const SymmetricGhosts&) = default;
};
struct PaperGhosts { ///< the basis of Spendlove et al. 2021, Table VI (corrected)
    double l10 = 1.0;
    double l11 = 1.0;
    double l14 = 1.0;
    double l17 = 1.0;

    friend bool operator==(const PaperGhosts&, const PaperGhosts&) = default;
};
/// Every mode relaxes with the stress' rate.
struct BgkGhosts {
    friend bool operator==(const BgkGhosts&, const BgkGhosts&) = default;
};

using GhostRates = std::variant<RegularisedGhosts, TrtGhosts, SymmetricGhosts, PaperGhosts, BgkGhosts>;

struct FluidParameters {
    double kinematic_viscosity = 1.0 / 6.0; ///< of the outer fluid, cells^2/step
    double density = 1.0;                   ///< reference density of both fluids
    double segregation = 0.67;              ///< beta; interface half-width 1/beta
    GhostRates ghosts = RegularisedGhosts{};

    friend bool operator==(const FluidParameters&, const FluidParameters&) = default;
};

struct HelfrichBending {
    double spontaneous_curvature = 0.0; ///< C0, 1/cells; E = (kappa/2) int (2H - C0)^2 dA

    friend bool operator==(const HelfrichBending&, const HelfrichBending&) = default;
};
struct PaperBending {
    double laplacian_coefficient = 1.5; ///< c in kappa_B (c Lap_s H + H^3 - HK), kappa_B = 4 kappa

    friend bool operator==(const PaperBending&, const PaperBending&) = default;
};

struct BendingParameters {
    double modulus = 0.0; ///< kappa (Helfrich); the paper's kappa_B is 4 kappa
    std::variant<HelfrichBending, PaperBending> form = HelfrichBending{};

    friend bool operator==(const BendingParameters&, const BendingParameters&) = default;
};

struct NoConstraint {
    friend bool operator==(const NoConstraint&, const NoConstraint&) = default;
};
/// sigma_A holds A = A_target(t).
struct MultiplierConstraint {
    friend bool operator==(const MultiplierConstraint&, const MultiplierConstraint&) = default;
};
struct PenaltyConstraint {
    double modulus = 0.0; ///< K_A: sigma_A = K_A (A - A_target)/A_target

    friend bool operator==(const PenaltyConstraint&, const PenaltyConstraint&) = default;
};
struct PaperConstraint {
    double alpha = 0.0; ///< sigma_A = (alpha/2) A (A - A_target)

    friend bool operator==(const PaperConstraint&, const PaperConstraint&) = default;
};

struct AreaParameters {
    std::variant<NoConstraint, MultiplierConstraint, PenaltyConstraint, PaperConstraint> constraint =
        MultiplierConstraint{};
    /// A_target over the area of the sphere of equal volume at the end of the ramp; absent: keep the initial
    /// area.
    std::optional<double> deflation;
    std::int64_t ramp = 0; ///< steps from the initial to the target area

    friend bool operator==(const AreaParameters&, const AreaParameters&) = default;
};

struct VesicleType {
    std::string name;
    double viscosity_ratio = 1.0; ///< inner / outer
    BendingParameters bending;
    AreaParameters area;
    double sigma = 0.0;      ///< constant tension
    Vec3<double> buoyancy{}; ///< force per volume on what is inside

    friend bool operator==(const VesicleType&, const VesicleType&) = default;
};

struct SphereShape {
    friend bool operator==(const SphereShape&, const SphereShape&) = default;
};
struct SpheroidShape {
    double aspect = 1.0; ///< length along the axis / width

    friend bool operator==(const SpheroidShape&, const SpheroidShape&) = default;
};
enum class HelfrichBranch { discocyte, prolate, stomatocyte };
struct HelfrichShape { ///< exact axisymmetric minimiser of the bending energy at C0 = 0
    HelfrichBranch branch = HelfrichBranch::discocyte;
    double reduced_volume = 0.65;

    friend bool operator==(const HelfrichShape&, const HelfrichShape&) = default;
};
struct EvansFungShape {
    friend bool operator==(const EvansFungShape&, const EvansFungShape&) = default;
};
struct MeshShape {
    std::string file; ///< STL or PLY, closed; scaled to the vesicle's radius when one is given
    std::shared_ptr<const TriangleMesh> mesh; ///< the file's triangles, in the file's units

    friend bool operator==(const MeshShape& a, const MeshShape& b) { return a.file == b.file; }
};
using ShapeParameters = std::variant<SphereShape, SpheroidShape, HelfrichShape, EvansFungShape, MeshShape>;

/// r -> r (1 + amplitude Y_lm) with real spherical harmonics about the vesicle's axis, normalised such that
/// int Y_lm^2 dOmega = 4 pi / (2 l + 1) (Schmidt), so that Y_20 = P_2(cos theta) and l = 2, m = 0, amplitude
/// A makes the pole distance R (1 + a).
struct HarmonicPerturbation {
    int l = 2;
    int m = 0;
    double amplitude = 0.0;

    friend bool operator==(const HarmonicPerturbation&, const HarmonicPerturbation&) = default;
};
/// Every harmonic with l in [lowest, highest], coefficients Gaussian with the given seed, of rms total
/// Amplitude.
struct RandomPerturbation {
    int lowest = 2;
    int highest = 6;
    double amplitude = 0.0;
    std::uint64_t seed = 1;

    friend bool operator==(const RandomPerturbation&, const RandomPerturbation&) = default;
};
using Perturbation = std::variant<HarmonicPerturbation, RandomPerturbation>;

struct VesicleParameters {
    std::size_t type = 0; ///< index into Parameters::types
    ShapeParameters shape = SphereShape{};
    Vec3<double> centre{};
    double radius = 0.0; ///< of the sphere of equal volume, cells
    Vec3<double> axis{0.0, 0.0, 1.0};
    std::optional<Vec3<double>> buoyancy; ///< instead of its type's
    std::vector<Perturbation> perturbations;
    bool joins_previous = false; ///< one body with the vesicle before: one colour, one membrane (benchmarks)

    friend bool operator==(const VesicleParameters&, const VesicleParameters&) = default;
};

enum class GeometryRecipe { mapped, paper };
enum class Precision { double_precision, single_precision };

/// As in a case file.
constexpr const char* name_of(Precision precision) {
    return precision == Precision::single_precision ? "single" : "double";
}

struct NumericsParameters {
    GeometryRecipe geometry = GeometryRecipe::mapped;
    double cutoff = 1e-2; ///< forces are tapered to zero below this 1 - phi^2
    Precision precision = Precision::double_precision;

    friend bool operator==(const NumericsParameters&, const NumericsParameters&) = default;
};

/// Solids in the box, from a file: a closed surface or voxels.
struct ObstacleParameters {
    std::string file;
    std::string dataset;                       ///< of voxels; may be empty
    bool solid_inside = true;                  ///< of a surface; outside otherwise
    double scale = 1.0;                        ///< cells per unit of a surface's file
    Vec3<double> position{};                   ///< of a surface's origin, cells
    std::shared_ptr<const TriangleMesh> mesh;  ///< of a surface's file
    std::shared_ptr<const SolidVoxels> voxels; ///< of a file of voxels, as large as the box

    friend bool operator==(const ObstacleParameters& a, const ObstacleParameters& b) {
        return a.file == b.file && a.dataset == b.dataset && a.solid_inside == b.solid_inside &&
               a.scale == b.scale && a.position == b.position;
    }
};

/// Everything that decides the trajectory. Two equal Parameters give the same bits.
struct Parameters {
    Vec3<int> size{};               ///< cells of the fluid's box
    std::array<AxisEnds, 3> ends{}; ///< of each axis
    FluidParameters fluid;
    FlowParameters flow;
    std::optional<ObstacleParameters> obstacles;
    /// Force per volume on pure inner fluid in a cell beside a solid, towards it; below zero, away from it.
    double wetting = -0.005;
    std::vector<VesicleType> types;
    std::vector<VesicleParameters> vesicles;
    NumericsParameters numerics;

    /// Layers of solid cells behind the upper end of an axis that is not periodic; the periodic lattice joins
    /// them to the lower end, so that each end has one of its own.
    static constexpr int wall_layers = 2;

    bool has_walls(int axis) const {
        return std::holds_alternative<WallEnds>(ends[static_cast<std::size_t>(axis)]);
    }
    bool is_open(int axis) const {
        return std::holds_alternative<OpenEnds>(ends[static_cast<std::size_t>(axis)]);
    }
    bool is_bounded(int axis) const { return has_walls(axis) || is_open(axis); }
    bool is_bounded() const { return is_bounded(0) || is_bounded(1) || is_bounded(2); }

    /// Cells of the lattice: the fluid's and the walls'.
    Vec3<int> lattice() const {
        Vec3<int> cells = size;
        for (int a = 0; a < 3; ++a)
            cells[a] += is_bounded(a) ? wall_layers : 0;
        return cells;
    }

    /// What stands for each of the vesicles in the engine: 0, 1, ... without gaps.
    std::vector<int> labels() const {
        std::vector<int> labels;
        for (const VesicleParameters& vesicle : vesicles)
            labels.push_back(labels.empty() ? 0 : labels.back() + (vesicle.joins_previous ? 0 : 1));
        return labels;
    }

    const Vec3<double>& buoyancy_of(const VesicleParameters& vesicle) const {
        return vesicle.buoyancy ? *vesicle.buoyancy : types.at(vesicle.type).buoyancy;
    }

    /// The flow whose box slides past its own images, if there is one.
    const ShearFlow* sliding() const {
        return flow.shear && flow.shear->with == ShearBy::lees_edwards ? &*flow.shear : nullptr;
    }

    friend bool operator==(const Parameters&, const Parameters&) = default;
};

struct SteadyCriterion {
    std::string quantity; ///< a column of metrics.csv
    double relative_change = 0.0;
    std::int64_t over = 0; ///< steps

    friend bool operator==(const SteadyCriterion&, const SteadyCriterion&) = default;
};

struct RunParameters {
    std::int64_t steps = 0;
    std::optional<SteadyCriterion> stop_when_steady;
    std::optional<double> wall_time; ///< seconds

    friend bool operator==(const RunParameters&, const RunParameters&) = default;
};

struct FieldOutput {
    std::int64_t every = 0;
    std::vector<std::string> names;
    Vec3<int> region_begin{}; ///< inclusive
    Vec3<int> region_end{};   ///< exclusive
    int stride = 1;
    bool average = false; ///< time average since the last output instead of the instant
    int compression = 1;  ///< deflate level after a shuffle of the bytes, 1..9; 0: none

    friend bool operator==(const FieldOutput&, const FieldOutput&) = default;
};

/// Means over cells at the same place across a flow.
struct ProfileOutput {
    std::int64_t every = 0;
    int along = 0;       ///< axis of the flow
    int across_axis = 2; ///< axis along which places differ; -1: by the distance from the box's middle line

    friend bool operator==(const ProfileOutput&, const ProfileOutput&) = default;
};

/// Points from one place to another, evenly spaced, both included.
struct TracerSeeds {
    Vec3<double> from{};
    Vec3<double> to{};
    int count = 1;

    friend bool operator==(const TracerSeeds&, const TracerSeeds&) = default;
};

/// Points that the fluid carries along.
struct TracerOutput {
    std::int64_t every = 0;   ///< steps between rows
    std::int64_t start = 0;   ///< step of the first release
    std::int64_t release = 0; ///< steps between releases at each seed; 0: one
    int membrane = 0;         ///< points round each vesicle, in the plane of the flow
    std::vector<TracerSeeds> seeds;

    bool released_at(std::int64_t step) const {
        const std::int64_t since = step - start;
        return since == 0 || (since > 0 && release > 0 && since % release == 0);
    }
    /// Steps between which they are carried at once: ten at most, and none passes a release or a row.
    bool carried_at(std::int64_t step) const {
        return step % 10 == 0 || (every > 0 && step % every == 0) || released_at(step);
    }

    friend bool operator==(const TracerOutput&, const TracerOutput&) = default;
};

struct OutputParameters {
    std::int64_t metrics_every = 0; ///< 0: never
    std::optional<FieldOutput> fields;
    std::int64_t surfaces_every = 0;
    std::optional<ProfileOutput> profiles;
    std::optional<TracerOutput> tracers;
    std::int64_t checkpoint_every = 0;
    int checkpoint_keep = 2;

    friend bool operator==(const OutputParameters&, const OutputParameters&) = default;
};

} // namespace vesica
