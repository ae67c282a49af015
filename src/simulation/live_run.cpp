#include "simulation/live_run.hpp"

#include "core/version.hpp"
#include "io/case_file.hpp"
#include "io/checkpoint_store.hpp"
#include "simulation/run_account.hpp"
#include "simulation/run_surfaces.hpp"
#include "simulation/start_state.hpp"

#include <fmt/format.h>

#include <utility>

namespace vesica {

namespace {

Colleagues& colleagues_of(const EngineOptions& options, Colleagues& nobody) {
    return options.crew != nullptr ? *options.crew : nobody;
}

IntactCheckpoint find_checkpoint(const std::filesystem::path& from, Colleagues& colleagues) {
    if (!std::filesystem::exists(from))
        throw InputError(
            fmt::format("{}: there is no such file or directory; expected a checkpoint, or the directory of "
                        "a run that left one; try [output] checkpoint = {{ every = ... }}",
                        from.string()));
    if (std::filesystem::is_directory(from))
        return newest_intact_checkpoint(from / "checkpoints", colleagues);
    return {read_checkpoint_notes(from, colleagues), from, {}};
}

} // namespace

LiveRun::LiveRun(Case what, Plan plan, const EngineOptions& options, int threads,
                 std::unique_ptr<Engine> engine)
    : case_(std::move(what)),
      plan_(std::move(plan)),
      options_(options),
      threads_(threads),
      engine_(std::move(engine)),
      schedule_(case_.output),
      metrics_(case_.parameters, case_.run, case_.output.metrics_every, engine_->snapshot()) {}

std::unique_ptr<LiveRun> LiveRun::begin(const Case& original, const EngineOptions& options,
                                        const PlanOptions& plan_options) {
    Case what = settled(original);
    Plan plan = make_plan(what, plan_options);
    refuse_errors(plan);
    if (options.crew != nullptr)
        layout_for(what.parameters.lattice(), options.crew->ranks().count(), options.blocks,
                   slide_of(what.parameters));
    Colleagues nobody;
    std::optional<StartState> start;
    std::optional<std::filesystem::path> from;
    if (what.initial) {
        start = find_start_state(what, colleagues_of(options, nobody));
        from = start->path;
        what.initial = InitialCheckpoint{start->path.string(), std::nullopt};
    }
    const int threads = threads_for(options);
    auto engine = build_engine(what, options, threads, from);
    if (start)
        load_state(*engine, options, start->path, start->change, what.parameters.lattice());
    std::unique_ptr<LiveRun> run(
        new LiveRun(std::move(what), std::move(plan), options, threads, std::move(engine)));
    if (run->schedule_.due(Event::metrics, 0))
        run->sample();
    return run;
}

std::unique_ptr<LiveRun> LiveRun::resume(const std::filesystem::path& from, const EngineOptions& options) {
    Colleagues nobody;
    const IntactCheckpoint found = find_checkpoint(from, colleagues_of(options, nobody));
    Case what = read_case_text(found.checkpoint.case_text, found.path.string());
    const Vec3<int> box = what.parameters.lattice();
    Plan plan = make_plan(what, PlanOptions{true}); // what has been begun is not refused any more
    const int threads = threads_for(options);
    auto engine = build_engine(what, options, threads, found.path);
    std::unique_ptr<LiveRun> run(
        new LiveRun(std::move(what), std::move(plan), options, threads, std::move(engine)));
    load_state(*run->engine_, options, found.path, {}, box);
    run->metrics_.restore(found.checkpoint.notes);
    return run;
}

void LiveRun::advance() {
    engine_->step();
    if (!schedule_.anything_due(step()))
        return;
    if (schedule_.anything_to_write(step()))
        refuse_trouble();
    if (schedule_.due(Event::metrics, step()))
        metrics_.sample(engine_->snapshot(), threads_);
}

void LiveRun::refuse_trouble() const {
    if (auto trouble = engine_->trouble())
        throw RunError(failure_text(case_, plan_, {RunEnd::failed, step(), {}, std::move(trouble)}));
}

bool LiveRun::is_sampled() const {
    const std::vector<MetricsRow>& last = metrics_.last();
    return !last.empty() && static_cast<std::int64_t>(last.front().step) == step();
}

const std::vector<MetricsRow>& LiveRun::sample() {
    if (is_sampled())
        return metrics_.last();
    refuse_trouble();
    return metrics_.sample(engine_->snapshot(), threads_);
}

SurfaceArrays LiveRun::surface(int vesicle) const {
    const Snapshot snapshot = engine_->snapshot();
    const auto count = snapshot.vesicles.size();
    if (vesicle < 0 || static_cast<std::size_t>(vesicle) >= count)
        throw InputError(count == 0 ? fmt::format("vesicle is {}, but this case has none", vesicle)
                                    : fmt::format("vesicle is {}; expected a whole number from 0 to {}",
                                                  vesicle, count - 1));
    return surface_of(snapshot.vesicles[static_cast<std::size_t>(vesicle)], vesicle, std::nullopt);
}

void LiveRun::save(const std::filesystem::path& path) {
    refuse_trouble();
    CheckpointNotes notes;
    notes.case_text = resolved_toml(case_);
    notes.notes = metrics_.notes();
    notes.program_version = version;
    write_checkpoint(path, notes, *engine_->planes(), colleagues_of(options_, nobody_));
}

} // namespace vesica
