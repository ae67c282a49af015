#pragma once

#include "case/case.hpp"
#include "io/metrics_file.hpp"
#include "io/output_directory.hpp"
#include "measure/pair_statistics.hpp"
#include "simulation/engine.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace vesica {

/// profiles.csv, a row for each bin across the flow at each time, suspension.csv, a row at each time, and
/// where there are several vesicles pairs.csv, a row for each bin of the distance between two centres.
class RunProfiles {
public:
    /// `resumed`: the step of the checkpoint from which the run continues.
    RunProfiles(const Case& what, const OutputDirectory& directory, std::optional<std::int64_t> resumed);

    /// At every multiple of ProfileOutput::every.
    void write(const Engine& engine);
    void flush();

private:
    std::vector<std::vector<double>> pair_rows(const std::vector<Vec3<double>>& centres, const PairBox& box,
                                               double step) const;

    ProfileOutput output_;
    bool walls_across_;
    std::shared_ptr<const SolidVoxels> solids_;
    MetricsFile profiles_;
    MetricsFile suspension_;
    PairBox box_;
    double pair_width_ = 0.0; ///< of the bins
    std::optional<MetricsFile> pairs_;
};

} // namespace vesica
