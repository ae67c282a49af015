#pragma once

#include "io/checkpoint.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace vesica {

/// DIR/checkpoints: step_<n>.h5, of which the newest `keep` stay.
class CheckpointStore {
public:
    /// Creates the directory if needed. Throws RunError.
    CheckpointStore(std::filesystem::path directory, int keep);

    /// Writes, and only then removes older checkpoints beyond the `keep` newest up to this step. Those of
    /// later steps (a resumed run went back behind damaged ones) do not count and stay until they are written
    /// anew. Returns the file. Throws RunError.
    std::filesystem::path write(const CheckpointNotes& notes, const StatePlanes& state,
                                Colleagues& colleagues) const;
    std::filesystem::path write(const Checkpoint& checkpoint) const;

private:
    std::filesystem::path directory_;
    int keep_;
};

struct IntactCheckpoint {
    Checkpoint checkpoint; ///< without the arrays of the box (read_checkpoint_notes)
    std::filesystem::path path;
    std::vector<std::string> refused; ///< newer ones that could not serve: file and reason each
};

/// The newest checkpoint whose digest is right. Throws InputError when there is no
/// checkpoint, RunError with every reason when none is intact.
IntactCheckpoint newest_intact_checkpoint(const std::filesystem::path& directory, Colleagues& colleagues);
IntactCheckpoint newest_intact_checkpoint(const std::filesystem::path& directory);

std::filesystem::path checkpoint_path(const std::filesystem::path& directory, std::int64_t step);

} // namespace vesica
