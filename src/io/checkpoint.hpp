#pragma once

#include "case/engine_state.hpp"
#include "io/checkpoint_sums.hpp"
#include "io/state_file.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace vesica {

/// What a checkpoint holds beside the state.
struct CheckpointNotes {
    std::string case_text; ///< the case in TOML, with all that the command line changed
    std::map<std::string, std::vector<double>> notes; ///< what schedules and measures remember, by name
    CheckpointSums sums;                              ///< written only; read_sums reads them
    std::string program_version;
};

/// All that `resume` needs.
struct Checkpoint : CheckpointNotes {
    EngineState engine;
};

/// Writes one file, whole or not at all; the same state gives the same bytes, however many ranks share it.
/// Numbers are kept bit for bit: arrays whose every value is a float are stored as floats in a single
/// run. With colleagues the state is that of the leading rank's part, and they write theirs. Throws RunError
/// (no space, which is asked for first; vanished directory).
void write_checkpoint(const std::filesystem::path& path, const CheckpointNotes& notes,
                      const StatePlanes& state, Colleagues& colleagues);
void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint);

/// Verifies the digest of the whole file before HDF5 opens it. Throws RunError naming the file and what is
/// wrong.
Checkpoint read_checkpoint(const std::filesystem::path& path);

/// The same without the arrays of the box, which read_state reads part by part.
Checkpoint read_checkpoint_notes(const std::filesystem::path& path, Colleagues& colleagues);

/// What a checkpoint says of itself, read without its arrays but verified in full.
struct CheckpointSummary {
    std::int64_t step = 0;
    Precision precision = Precision::double_precision;
    Vec3<int> size{};
    std::string program_version;
    std::uint32_t format_version = 0;
    std::uint64_t bytes = 0;
    std::vector<std::string> arrays; ///< name and shape, as text
    std::string case_text;
};
CheckpointSummary summarise_checkpoint(const std::filesystem::path& path);

} // namespace vesica
