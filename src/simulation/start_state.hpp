#pragma once

#include "case/case.hpp"
#include "case/engine_state.hpp"

#include <filesystem>

namespace vesica {

/// The state a case with [initial] starts from, as its step 0, and where it was found.
struct StartState {
    EngineState engine;
    std::filesystem::path path; ///< absolute, of the checkpoint
    std::int64_t step = 0;      ///< of the run it came from
};

/// Reads the checkpoint a case's [initial] names. Its box, precision, density and number of vesicles must be
/// the case's; a constraint of the area of another kind starts anew. Throws InputError, at the key's place,
/// where the checkpoint is missing, damaged or of another model.
StartState read_start_state(const Case& what);

} // namespace vesica
