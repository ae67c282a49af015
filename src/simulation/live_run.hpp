#pragma once

#include "io/surface_file.hpp"
#include "simulation/plan.hpp"
#include "simulation/run_metrics.hpp"
#include "simulation/run_start.hpp"
#include "simulation/schedule.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

namespace vesica {

/// A run in memory, step by step at its caller's pace: what run_case and resume_run do, without a directory.
/// It measures and looks for trouble on the case's own schedule whatever its caller asks for between, so that
/// its samples are the rows that the same case leaves in metrics.csv, bit for bit.
class LiveRun {
public:
    /// Throws InputError if the case cannot serve.
    static std::unique_ptr<LiveRun> begin(const Case& what, const EngineOptions& options,
                                          const PlanOptions& plan);

    /// From a checkpoint, or the newest intact one of a run's directory. Throws InputError, RunError.
    static std::unique_ptr<LiveRun> resume(const std::filesystem::path& from, const EngineOptions& options);

    /// One step. Throws RunError once the state is broken; its last good state is lost.
    void advance();

    /// The metrics of the present state, vesicle by vesicle. Throws RunError if it is broken.
    const std::vector<MetricsRow>& sample();

    /// Whether the case's criterion for a steady state was met at the last sample of its schedule.
    bool is_steady() const { return metrics_.is_steady(); }

    /// The surface of a vesicle in lattice units. Throws InputError where there is no such vesicle.
    SurfaceArrays surface(int vesicle) const;

    /// A checkpoint as `vesica run` writes it. Throws RunError.
    void save(const std::filesystem::path& path);

    std::int64_t step() const { return engine_->steps_done(); }
    const Case& what() const { return case_; }
    const Engine& engine() const { return *engine_; }
    int threads() const { return threads_; }

private:
    LiveRun(Case what, Plan plan, const EngineOptions& options, int threads, std::unique_ptr<Engine> engine);
    void refuse_trouble() const;
    bool is_sampled() const;

    Case case_;
    Plan plan_;
    EngineOptions options_;
    int threads_;
    std::unique_ptr<Engine> engine_;
    Schedule schedule_;
    RunMetrics metrics_;
    Colleagues nobody_;
};

} // namespace vesica
