#pragma once

#include "case/case.hpp"
#include "io/checkpoint_store.hpp"
#include "io/metrics_file.hpp"
#include "io/output_directory.hpp"
#include "io/run_log.hpp"
#include "io/run_summary.hpp"
#include "simulation/progress.hpp"
#include "simulation/run_fields.hpp"
#include "simulation/run_loop.hpp"
#include "simulation/run_metrics.hpp"
#include "simulation/run_profiles.hpp"
#include "simulation/run_surfaces.hpp"
#include "simulation/run_tracers.hpp"
#include "simulation/stop.hpp"

#include <filesystem>
#include <map>
#include <optional>

namespace vesica {

/// Who writes with the recorder: other ranks, or nobody.
struct RunHands {
    Colleagues& colleagues;
    FieldCrew& fields;
    int threads = 1;
};

/// Writes what a run leaves behind, and listens to who wants it to stop.
class RunRecorder : public RunObserver {
public:
    /// `resumed`: the step of the checkpoint from which the run continues; what was written beyond it is
    /// removed.
    RunRecorder(const Case& what, const OutputDirectory& directory, RunLog& log, RunMetrics& metrics,
                Progress& progress, const StopRequest& stop, const RunHands& hands,
                std::optional<std::int64_t> resumed);

    /// Takes up the averages a checkpoint was in the middle of.
    void restore(const CheckpointNotes& notes, const std::filesystem::path& checkpoint) {
        if (fields_)
            fields_->restore(notes, checkpoint);
        if (tracers_)
            tracers_->restore(notes.notes);
    }

    void record(Event event, const Engine& engine) override;
    void progressed(std::int64_t step) override { progress_.update(step); }
    bool is_steady() const override { return metrics_.is_steady(); }
    std::optional<std::string> stop_reason() const override { return stop_.reason(); }

    /// What it has cost so far.
    const OutputSummary& output() const { return output_; }

private:
    void write_metrics(const Engine& engine);
    /// Returns the file.
    std::filesystem::path write_checkpoint(const Engine& engine);
    void carry_out(Event event, const Engine& engine, OutputSummary::Kind& cost);

    const Case& case_;
    RunLog& log_;
    RunMetrics& metrics_;
    Progress& progress_;
    const StopRequest& stop_;
    RunHands hands_;
    std::filesystem::path directory_;
    MetricsFile metrics_file_;
    std::optional<RunFields> fields_;
    std::optional<RunSurfaces> surfaces_;
    std::optional<RunProfiles> profiles_;
    std::optional<RunTracers> tracers_;
    CheckpointStore checkpoints_;
    OutputSummary output_;
    std::map<std::filesystem::path, double> tables_; ///< bytes of those that grow
};

} // namespace vesica
