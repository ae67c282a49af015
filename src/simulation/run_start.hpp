#pragma once

#include "case/case.hpp"
#include "simulation/crew.hpp"
#include "simulation/plan_cost.hpp"

#include <filesystem>
#include <memory>
#include <optional>

namespace vesica {

/// What a case's engine is built with.
struct EngineOptions {
    int threads = 0;       ///< of each rank; 0: as many as default_threads()
    EngineFactory factory; ///< empty: make_engine
    Crew* crew = nullptr;  ///< where several ranks share the box; its settings:
    std::optional<Vec3<int>> blocks;
    Balance balance = Balance::interface;
};

/// The case as it is run: its suspension packed, its files found from anywhere, since a checkpoint lies in
/// another folder than the case file. Throws InputError.
Case settled(Case what);

/// With a crew, of each rank.
int threads_for(const EngineOptions& options);

/// `from` is the checkpoint whose state the engine will take up, if any. Throws InputError, and RunError
/// where memory does not suffice.
std::unique_ptr<Engine> build_engine(const Case& what, const EngineOptions& options, int threads,
                                     const std::optional<std::filesystem::path>& from);

/// Takes up a verified checkpoint's state.
void load_state(Engine& engine, const EngineOptions& options, const std::filesystem::path& checkpoint,
                const StateChange& change, const Vec3<int>& box);

} // namespace vesica
