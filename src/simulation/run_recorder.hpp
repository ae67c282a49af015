#pragma once

#include "case/case.hpp"
#include "io/checkpoint_store.hpp"
#include "io/field_series.hpp"
#include "io/metrics_file.hpp"
#include "io/output_directory.hpp"
#include "io/run_log.hpp"
#include "io/surface_series.hpp"
#include "simulation/progress.hpp"
#include "simulation/run_fields.hpp"
#include "simulation/run_loop.hpp"
#include "simulation/run_metrics.hpp"
#include "simulation/run_profiles.hpp"
#include "simulation/run_tracers.hpp"
#include "simulation/stop.hpp"

#include <optional>

namespace vesica {

/// Writes what a run leaves behind, and listens to who wants it to stop.
class RunRecorder : public RunObserver {
public:
    /// `resumed`: the step of the checkpoint from which the run continues; what was written beyond it is
    /// removed.
    RunRecorder(const Case& what, const OutputDirectory& directory, RunLog& log, RunMetrics& metrics,
                Progress& progress, const StopRequest& stop, Colleagues& colleagues,
                std::optional<std::int64_t> resumed);

    /// Takes up the averages a checkpoint was in the middle of.
    void restore(const RunMetrics::Notes& notes) {
        if (fields_)
            fields_->restore(notes);
        if (tracers_)
            tracers_->restore(notes);
    }

    void record(Event event, const Engine& engine) override;
    void progressed(std::int64_t step) override { progress_.update(step); }
    bool is_steady() const override { return metrics_.is_steady(); }
    std::optional<std::string> stop_reason() const override { return stop_.reason(); }

    /// Seconds spent in record.
    double seconds() const { return seconds_; }

private:
    void write_metrics(const Engine& engine);
    void write_surfaces(const Engine& engine);
    void write_checkpoint(const Engine& engine);

    const Case& case_;
    RunLog& log_;
    RunMetrics& metrics_;
    Progress& progress_;
    const StopRequest& stop_;
    Colleagues& colleagues_;
    MetricsFile metrics_file_;
    std::optional<RunFields> fields_;
    std::optional<SurfaceSeries> surfaces_;
    std::optional<RunProfiles> profiles_;
    std::optional<RunTracers> tracers_;
    CheckpointStore checkpoints_;
    double seconds_ = 0.0;
};

} // namespace vesica
