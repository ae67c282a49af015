#pragma once

#include "core/cell_box.hpp"
#include "core/scales.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace vesica {

/// A statement about the run that can be wrong: "mass is conserved", found and allowed in words.
struct Verdict {
    std::string name;
    bool passed = false;
    std::string text;
};

/// How several ranks shared a run out, and what travelled between them.
struct ParallelSummary {
    struct Rank {
        CellBox block{};
        std::int64_t interface_cells = 0; ///< at the end
        double working = 0.0;             ///< seconds of stepping
        double waiting = 0.0;             ///< seconds of it for others
    };

    Vec3<int> blocks{};      ///< along each axis
    std::vector<Rank> ranks; ///< none: one process
    std::int64_t steps = 0;
    std::int64_t population_messages = 0; ///< all ranks, all steps
    std::int64_t population_bytes = 0;
    std::int64_t band_messages = 0;
    std::int64_t band_bytes = 0;

    /// The busiest rank's work by the mean: 1 is perfect, and its inverse the most that can be had of them.
    double imbalance() const;
    double waiting_share() const; ///< of all ranks' seconds of stepping
    std::string text() const;     ///< a line for people
};

/// What output took, by kind: fields, surfaces, ...
struct OutputSummary {
    struct Kind {
        std::int64_t files = 0; ///< begun; a table that grows is one
        double bytes = 0.0;     ///< written, of files that were replaced since too
        double seconds = 0.0;   ///< of gathering and writing
    };

    std::map<std::string, Kind> kinds;
    double run_seconds = 0.0; ///< of stepping and output together

    Kind total() const;
    double share() const;     ///< of the run's time
    std::string text() const; ///< a line for people
};

/// What summary.json tells of a run.
struct RunSummary {
    std::string title;
    std::string end;    ///< finished, steady, stopped or failed
    std::string reason; ///< why it ended so; empty when finished
    std::int64_t first_step = 0;
    std::int64_t last_step = 0;
    std::vector<Verdict> verdicts;
    std::vector<std::string> warnings;

    Vec3<int> size{};
    std::string precision; ///< double or single
    std::string device;    ///< cpu or cuda
    std::string instruction_set;
    int threads = 1;
    int ranks = 1;
    ParallelSummary parallel;
    double bytes_allocated = 0.0;
    double mlups = 0.0;                    ///< million lattice updates per second of stepping
    std::map<std::string, double> seconds; ///< wall time by what it was spent on
    OutputSummary output;
    std::map<std::string, double> profile;       ///< of the steps: seconds by part, costs of a cell
    std::map<std::string, std::string> versions; ///< vesica, compiler, hdf5, ...

    std::optional<Scales> scales;                ///< absent: lattice units only
    std::map<std::string, double> dimensionless; ///< Reynolds, capillary numbers, ...

    std::vector<std::string> columns;              ///< of the metrics
    std::vector<std::vector<double>> last_metrics; ///< a row per vesicle
};

/// Writes the summary as JSON, whole or not at all. Numbers that are not finite become null, which is all
/// JSON has for them. Throws RunError.
void write_summary(const std::filesystem::path& path, const RunSummary& summary);

} // namespace vesica
