#pragma once

#include "case/case.hpp"
#include "io/surface_series.hpp"
#include "simulation/engine.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>

namespace vesica {

/// The surfaces phi = 0 of all vesicles, with what is known of the membrane on their points, in SI units if
/// the case has units.
class RunSurfaces {
public:
    /// `resumed` as for RunRecorder. Throws RunError.
    RunSurfaces(const Case& what, const std::filesystem::path& directory, std::optional<std::int64_t> resumed,
                int threads);

    /// Returns the file. The layers of a few vesicles at a time come to the rank that leads.
    std::filesystem::path write(const Engine& engine);

private:
    SurfaceSeries series_;
    std::optional<Scales> scales_;
    int vesicles_;
    int threads_;
};

/// The surface of one vesicle and what is known on its points: H, K, the outward normal, the parts of the
/// membrane's force per area along it (bending, tension, area, their sum: positive outwards) and the
/// velocity. Points in cells.
SurfaceArrays surface_of(const VesicleSnapshot& vesicle, int index, const std::optional<Scales>& scales);

} // namespace vesica
