#include "simulation/run_start.hpp"

#include "io/state_file.hpp"
#include "simulation/suspension.hpp"

#include <fmt/format.h>

#include <new>
#include <utility>

namespace vesica {

Case settled(Case what) {
    pack_suspension(what);
    const std::filesystem::path folder = std::filesystem::path(what.source_file).parent_path();
    for (VesicleParameters& vesicle : what.parameters.vesicles)
        if (auto* mesh = std::get_if<MeshShape>(&vesicle.shape))
            mesh->file = std::filesystem::absolute(folder / mesh->file).string();
    if (auto& obstacles = what.parameters.obstacles)
        obstacles->file = std::filesystem::absolute(folder / obstacles->file).string();
    return what;
}

int threads_for(const EngineOptions& options) {
    if (options.threads > 0)
        return options.threads;
    return options.crew != nullptr ? options.crew->default_threads() : default_threads();
}

std::unique_ptr<Engine> build_engine(const Case& what, const EngineOptions& options, int threads,
                                     const std::optional<std::filesystem::path>& from) {
    try {
        if (options.crew != nullptr)
            return options.crew->build(what, {options.threads, options.blocks, options.balance}, from);
        return options.factory ? options.factory(what.parameters, threads)
                               : make_engine(what.parameters, threads);
    } catch (const std::bad_alloc&) {
        const Vec3<int>& size = what.parameters.size;
        throw RunError(
            fmt::format("{}: not enough memory for {} x {} x {} cells; `vesica check` says how much it takes",
                        what.source_file, size.x, size.y, size.z));
    }
}

void load_state(Engine& engine, const EngineOptions& options, const std::filesystem::path& checkpoint,
                const StateChange& change, const Vec3<int>& box) {
    if (options.crew != nullptr) {
        options.crew->load(checkpoint, change);
        return;
    }
    EngineState state = read_state(checkpoint, {{}, box});
    change.apply(state);
    engine.load(state);
}

} // namespace vesica
