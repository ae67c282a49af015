#pragma once

#include "core/scales.hpp"
#include "io/surface_file.hpp"

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

namespace vesica {

/// DIR/surfaces: surface_<step>.vtp with all vesicles, and surfaces.pvd, which ParaView opens as a series in
/// time.
class SurfaceSeries {
public:
    /// Starts a series in the run's directory. Points are multiplied by the scale's cell. Throws RunError.
    SurfaceSeries(const std::filesystem::path& run_directory, Scales scales);

    /// Takes over the steps up to `last_step` and removes later ones.
    static SurfaceSeries resume(const std::filesystem::path& run_directory, Scales scales,
                                std::int64_t last_step);

    /// Adds one step; points in cells. Returns the file. Throws RunError; the series is then what it was.
    std::filesystem::path write(std::int64_t step, std::vector<SurfaceArrays> surfaces);

private:
    void write_index() const;

    std::filesystem::path directory_;
    Scales scales_;
    std::vector<std::int64_t> steps_;
};

} // namespace vesica
