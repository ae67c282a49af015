// Compiled once per instruction set; see cmake/instruction_sets.cmake.
#include "simulation/engine_checkpoint.hpp"
#include "simulation/engine_entries.hpp"
#include "simulation/engine_fields.hpp"
#include "simulation/engine_snapshot.hpp"
#include "simulation/engine_velocities.hpp"

namespace vesica {

std::unique_ptr<Engine> VESICA_ENGINE_ENTRY(double, VESICA_ISA)(const EngineSetup& setup) {
    return std::make_unique<LatticeEngine<double>>(setup);
}

} // namespace vesica
