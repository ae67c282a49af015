#pragma once

#include "simulation/engine.hpp"
#include "simulation/engine_setup.hpp"

#include <memory>

#define VESICA_ENGINE_ENTRY_OF(precision, isa) isa_entry_##isa##_make_##precision##_engine
#define VESICA_ENGINE_ENTRY(precision, isa) VESICA_ENGINE_ENTRY_OF(precision, isa)

namespace vesica {

// One entry per precision and instruction set the library was built for (VESICA_HAS_ISA_...).
std::unique_ptr<Engine> VESICA_ENGINE_ENTRY(double, baseline)(const EngineSetup& setup);
std::unique_ptr<Engine> VESICA_ENGINE_ENTRY(double, avx2)(const EngineSetup& setup);
std::unique_ptr<Engine> VESICA_ENGINE_ENTRY(double, avx512)(const EngineSetup& setup);
std::unique_ptr<Engine> VESICA_ENGINE_ENTRY(single, baseline)(const EngineSetup& setup);
std::unique_ptr<Engine> VESICA_ENGINE_ENTRY(single, avx2)(const EngineSetup& setup);
std::unique_ptr<Engine> VESICA_ENGINE_ENTRY(single, avx512)(const EngineSetup& setup);

} // namespace vesica
