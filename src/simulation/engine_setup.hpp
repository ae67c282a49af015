#pragma once

#include "case/parameters.hpp"
#include "measure/layer_moment.hpp"
#include "parallel/neighbourhood.hpp"
#include "simulation/flow_drive.hpp"
#include "simulation/initial_state.hpp"
#include "simulation/membrane_model.hpp"

#include <memory>
#include <string_view>

namespace vesica {

/// lambda of the stress: constant, or between two fluids.
struct StressRates {
    double outer = 1.0;
    double inner = 1.0;
};

struct LayerSettings {
    double beta = 0.67;
    double reference_density = 1.0;
    double cutoff = 1e-2;
    GeometryRecipe recipe = GeometryRecipe::mapped;
    double wetting = 0.0; ///< force per volume on red beside solids, towards them
};

/// A case's parameters as the engine uses them, the same for every precision and instruction set.
struct EngineSetup {
    std::shared_ptr<const Neighbourhood> neighbourhood; ///< the block and what lies around it
    double reference_density = 1.0;
    FlowDrive drive;
    StressRates rates;
    GhostRates ghosts;
    LayerSettings layer;
    LayerMoments layer_moments; ///< of the relaxed layer
    double spontaneous_curvature = 0.0;
    double bending_modulus = 0.0;
    double outer_viscosity = 0.0; ///< dynamic
    double viscosity_ratio = 1.0;
    Membrane membrane;
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
