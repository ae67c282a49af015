#pragma once

#include "case/case.hpp"
#include "case/engine_state.hpp"
#include "io/state_file.hpp"

#include <filesystem>

namespace vesica {

/// What becomes of a checkpoint's state when an engine takes it up.
struct StateChange {
    bool from_step_zero = false;
    bool without_controllers = false; ///< a constraint of another kind has other memories

    void apply(EngineState& state) const;
};

/// The state a case with [initial] starts from, as its step 0.
struct StartState {
    std::filesystem::path path; ///< absolute, of the checkpoint
    std::int64_t step = 0;      ///< of the run it came from
    StateChange change;
};

/// Verifies the checkpoint a case's [initial] names. Its box, precision, density and number of vesicles must
/// be the case's; a constraint of the area of another kind starts anew. Throws InputError, at the key's
/// place, where the checkpoint is missing, damaged or of another model.
StartState find_start_state(const Case& what, Colleagues& colleagues);

} // namespace vesica
