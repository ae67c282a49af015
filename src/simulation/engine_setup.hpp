#pragma once

#include "case/parameters.hpp"
#include "measure/layer_moment.hpp"
#include "parallel/neighbourhood.hpp"
#include "simulation/flow_drive.hpp"
#include "simulation/initial_state.hpp"
#include "simulation/membrane_model.hpp"

#include <memory>
#include <string_view>
#include <vector>

namespace vesica {

struct LayerSettings {
    double beta = 0.67;
    double reference_density = 1.0;
    double cutoff = 1e-2;
    GeometryRecipe recipe = GeometryRecipe::mapped;
    double wetting = 0.0; ///< force per volume on red beside solids, towards them
    int labels = 1;       ///< vesicles, each with a colour of its own
};

/// A vesicle as the engine uses it.
struct VesicleSetup {
    Membrane membrane;
    double bending_modulus = 0.0;
    double spontaneous_curvature = 0.0;
    double viscosity_ratio = 1.0;
    double inner_rate = 1.0; ///< lambda of the stress
    Vec3<double> buoyancy{}; ///< force per volume on what is inside
};

/// A case's parameters as the engine uses them, the same for every precision and instruction set.
struct EngineSetup {
    std::shared_ptr<const Neighbourhood> neighbourhood; ///< the block and what lies around it
    double reference_density = 1.0;
    FlowDrive drive;
    double outer_rate = 1.0; ///< lambda of the stress
    GhostRates ghosts;
    LayerSettings layer;
    LayerMoments layer_moments;                    ///< of the relaxed layer
    double outer_viscosity = 0.0;                  ///< dynamic
    std::vector<VesicleSetup> vesicles;            ///< by label
    std::shared_ptr<const InitialColours> colours; ///< null: one fluid
    Precision precision = Precision::double_precision;
    int threads = 1;
    std::string_view instruction_set;
};

/// The initial colours of a block; null without vesicles. Throws InputError.
std::shared_ptr<const InitialColours> initial_colours(const Parameters& parameters, const Block& block,
                                                      int threads);

EngineSetup make_engine_setup(const Parameters& parameters, int threads,
                              std::shared_ptr<const Neighbourhood> neighbourhood);

} // namespace vesica
