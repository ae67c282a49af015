#include "simulation/run_recorder.hpp"

#include "core/version.hpp"
#include "io/case_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

namespace vesica {

namespace {

MetricsFile metrics_file_for(const Case& what, const OutputDirectory& directory,
                             std::optional<std::int64_t> resumed) {
    const std::filesystem::path path = directory / "metrics.csv";
    if (!resumed)
        return MetricsFile(path, metrics_columns());
    // A run that ended off its schedule has a last row there that a longer run would not have written.
    const std::int64_t every = what.output.metrics_every;
    const std::int64_t last = every > 0 ? *resumed / every * every : -1;
    return MetricsFile::resume(path, metrics_columns(), last);
}

/// Under which name the cost of an event is told.
const char* kind_of(Event event) {
    switch (event) {
    case Event::sample:
    case Event::fields:
        return "fields";
    case Event::surfaces:
        return "surfaces";
    case Event::profiles:
        return "profiles";
    case Event::tracers:
    case Event::carry:
        return "tracers";
    case Event::checkpoint:
        return "checkpoints";
    case Event::metrics:
    case Event::trouble:
        break;
    }
    return "metrics";
}

double bytes_of(const std::filesystem::path& file) {
    std::error_code unknown; // an account must not end a run
    const auto bytes = std::filesystem::file_size(file, unknown);
    return unknown ? 0.0 : static_cast<double>(bytes);
}

} // namespace

RunRecorder::RunRecorder(const Case& what, const OutputDirectory& directory, RunLog& log, RunMetrics& metrics,
                         Progress& progress, const StopRequest& stop, const RunHands& hands,
                         std::optional<std::int64_t> resumed)
    : case_(what),
      log_(log),
      metrics_(metrics),
      progress_(progress),
      stop_(stop),
      hands_(hands),
      directory_(directory.path()),
      metrics_file_(metrics_file_for(what, directory, resumed)),
      checkpoints_(directory / "checkpoints", std::max(1, what.output.checkpoint_keep)) {
    if (what.output.fields)
        fields_.emplace(what, directory.path(), resumed, hands.fields);
    if (what.output.surfaces_every > 0)
        surfaces_.emplace(what, directory.path(), resumed, hands.threads);
    for (const char* const name :
         {"metrics.csv", "profiles.csv", "suspension.csv", "pairs.csv", "tracers.csv"})
        if (resumed)
            tables_[directory_ / name] = bytes_of(directory_ / name);
    if (what.output.profiles)
        profiles_.emplace(what, directory, resumed);
    if (what.output.tracers)
        tracers_.emplace(what, directory, resumed);
}

void RunRecorder::record(Event event, const Engine& engine) {
    const auto begin = std::chrono::steady_clock::now();
    OutputSummary::Kind& cost = output_.kinds[kind_of(event)];
    carry_out(event, engine, cost);
    cost.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void RunRecorder::carry_out(Event event, const Engine& engine, OutputSummary::Kind& cost) {
    const auto add_file = [&](const std::filesystem::path& file) {
        ++cost.files;
        cost.bytes += bytes_of(file);
    };
    const auto add_table = [&](const char* name) {
        const std::filesystem::path file = directory_ / name;
        const double before = tables_[file];
        tables_[file] = bytes_of(file);
        cost.files += before == 0.0 ? 1 : 0;
        cost.bytes += std::max(0.0, tables_[file] - before);
    };
    switch (event) {
    case Event::trouble:
        break;
    case Event::sample:
        if (fields_)
            fields_->sample();
        break;
    case Event::metrics:
        write_metrics(engine);
        add_table("metrics.csv");
        break;
    case Event::fields:
        if (fields_)
            add_file(fields_->write(engine.steps_done()));
        break;
    case Event::surfaces:
        if (surfaces_)
            add_file(surfaces_->write(engine));
        break;
    case Event::profiles:
        profiles_->write(engine);
        add_table("profiles.csv");
        add_table("suspension.csv");
        add_table("pairs.csv");
        break;
    case Event::tracers:
        if (tracers_)
            tracers_->write(engine);
        add_table("tracers.csv");
        break;
    case Event::carry:
        if (tracers_)
            tracers_->carry(engine);
        break;
    case Event::checkpoint:
        add_file(write_checkpoint(engine));
        break;
    }
}

void RunRecorder::write_metrics(const Engine& engine) {
    std::vector<std::vector<double>> rows;
    for (const MetricsRow& row : metrics_.sample(engine.snapshot(), hands_.threads))
        rows.push_back(metrics_values(row));
    metrics_file_.append(rows);
}

std::filesystem::path RunRecorder::write_checkpoint(const Engine& engine) {
    metrics_file_.flush();
    CheckpointNotes checkpoint;
    checkpoint.case_text = resolved_toml(case_);
    checkpoint.notes = metrics_.notes();
    if (fields_)
        fields_->keep_in(checkpoint);
    if (profiles_)
        profiles_->flush();
    if (tracers_) {
        tracers_->flush();
        checkpoint.notes.merge(tracers_->notes());
    }
    checkpoint.program_version = version;
    const std::filesystem::path path = checkpoints_.write(checkpoint, *engine.planes(), hands_.colleagues);
    log_.information(fmt::format("step {}: checkpoint {}", engine.steps_done(), path.filename().string()));
    return path;
}

} // namespace vesica
