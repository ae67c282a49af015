#include "io/checkpoint_store.hpp"

#include "core/input_error.hpp"
#include "io/posix_file.hpp"
#include "io/step_name.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cassert>

namespace vesica {

std::filesystem::path checkpoint_path(const std::filesystem::path& directory, std::int64_t step) {
    return directory / step_name("step_", step, ".h5");
}

CheckpointStore::CheckpointStore(std::filesystem::path directory, int keep)
    : directory_(std::move(directory)), keep_(keep) {
    assert(keep_ >= 1);
    make_subdirectory(directory_);
}

std::filesystem::path CheckpointStore::write(const Checkpoint& checkpoint) const {
    Colleagues nobody;
    return write(checkpoint, PlanesOfState(checkpoint.engine), nobody);
}

std::filesystem::path CheckpointStore::write(const CheckpointNotes& notes, const StatePlanes& state,
                                             Colleagues& colleagues) const {
    const std::int64_t written = state.head().step;
    const auto path = checkpoint_path(directory_, written);
    write_checkpoint(path, notes, state, colleagues);
    auto steps = list_steps(directory_, "step_", ".h5");
    std::erase_if(steps, [&](std::int64_t step) { return step > written; });
    for (std::size_t i = 0; i + static_cast<std::size_t>(keep_) < steps.size(); ++i) {
        std::error_code ignored; // one checkpoint too many harms nobody
        std::filesystem::remove(checkpoint_path(directory_, steps[i]), ignored);
    }
    return path;
}

IntactCheckpoint newest_intact_checkpoint(const std::filesystem::path& directory) {
    Colleagues nobody;
    return newest_intact_checkpoint(directory, nobody);
}

IntactCheckpoint newest_intact_checkpoint(const std::filesystem::path& directory, Colleagues& colleagues) {
    std::vector<std::string> refused;
    const auto steps = list_steps(directory, "step_", ".h5");
    for (auto step = steps.rbegin(); step != steps.rend(); ++step) {
        const auto path = checkpoint_path(directory, *step);
        try {
            return {read_checkpoint_notes(path, colleagues), path, refused};
        } catch (const RunError& error) {
            refused.emplace_back(error.what());
        }
    }
    if (refused.empty())
        throw InputError(fmt::format("{}: holds no checkpoint", directory.string()));
    throw RunError(
        fmt::format("{}: holds no intact checkpoint:\n  {}", directory.string(), fmt::join(refused, "\n  ")));
}

} // namespace vesica
