#pragma once

#include "simulation/engine.hpp"
#include "simulation/engine_setup.hpp"

#include <memory>

#define VESICA_ENGINE_ENTRY_OF(isa) isa_entry_##isa##_make_engine
#define VESICA_ENGINE_ENTRY(isa) VESICA_ENGINE_ENTRY_OF(isa)

namespace vesica {

// One entry per instruction set the library was built for (VESICA_HAVE_ISA_...).
std::unique_ptr<Engine> VESICA_ENGINE_ENTRY(baseline)(const EngineSetup& setup);
std::unique_ptr<Engine> VESICA_ENGINE_ENTRY(avx2)(const EngineSetup& setup);
std::unique_ptr<Engine> VESICA_ENGINE_ENTRY(avx512)(const EngineSetup& setup);

} // namespace vesica
