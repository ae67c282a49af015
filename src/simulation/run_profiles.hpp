#pragma once

#include "case/case.hpp"
#include "io/metrics_file.hpp"
#include "io/output_directory.hpp"
#include "simulation/engine.hpp"

#include <memory>
#include <optional>

namespace vesica {

/// profiles.csv, a row for each bin across the flow at each time, and suspension.csv, a row at each time.
class RunProfiles {
public:
    /// `resumed`: the step of the checkpoint from which the run continues.
    RunProfiles(const Case& what, const OutputDirectory& directory, std::optional<std::int64_t> resumed);

    /// At every multiple of ProfileOutput::every.
    void write(const Engine& engine);
    void flush();

private:
    ProfileOutput output_;
    bool walls_across_;
    std::shared_ptr<const SolidVoxels> solids_;
    MetricsFile profiles_;
    MetricsFile suspension_;
};

} // namespace vesica
