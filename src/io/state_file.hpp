#pragma once

#include "case/engine_state.hpp"
#include "io/block_digest.hpp"
#include "parallel/ranks.hpp"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace vesica {

/// Where in a file under construction the arrays of a state belong: each in one piece, in the whole box's
/// canonical order.
struct StateFile {
    std::filesystem::path temporary; ///< the name it has so far
    std::filesystem::path target;    ///< in whose name errors are told
    std::uint64_t populations = 0;   ///< bytes from the beginning of the file
    std::uint64_t minority = 0;
    std::uint64_t band = 0;
    std::uint64_t label = 0; ///< where slots have labels
    bool floats = false;     ///< how populations and minority are stored
};

/// Writes the arrays of each rank's part and waits until they are on the device; all ranks together, and if
/// one of them cannot, all throw its RunError.
void write_state(const StateFile& file, const StatePlanes& part, const Ranks& ranks);

/// Reads a part of the state in a checkpoint, which has been verified before. Throws RunError.
EngineState read_state(const std::filesystem::path& checkpoint, const CellBox& part);

/// EngineState::band of a part alone, of all colours together.
std::vector<std::uint8_t> read_band(const std::filesystem::path& checkpoint, const CellBox& part);

/// What the rank that writes or reads a checkpoint needs of the others; by itself it needs nobody.
class Colleagues {
public:
    Colleagues() = default;
    Colleagues(const Colleagues&) = delete;
    Colleagues& operator=(const Colleagues&) = delete;
    virtual ~Colleagues() = default;

    /// write_state on all ranks, each with its part.
    virtual void write_state(const StateFile& file, const StatePlanes& own_part) {
        vesica::write_state(file, own_part, Ranks());
    }
    /// digest_of_file, the blocks shared out.
    virtual Digest digest(const std::filesystem::path& file, std::uint64_t offset, std::uint64_t length,
                          const std::filesystem::path& target);
};

} // namespace vesica
