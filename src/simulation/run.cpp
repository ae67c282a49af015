#include "simulation/run.hpp"

#include "core/version.hpp"
#include "io/atomic_file.hpp"
#include "io/case_file.hpp"
#include "simulation/run_account.hpp"
#include "simulation/run_recorder.hpp"
#include "simulation/start_state.hpp"

#include <fmt/format.h>

#include <chrono>
#include <new>

namespace vesica {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// What a run and its resumption have in common: from a built engine to the summary.
class Session {
public:
    Session(const Case& what, const Plan& plan, const RunOptions& options, OutputDirectory directory,
            int threads, Clock::time_point begin)
        : case_(what),
          plan_(plan),
          options_(options),
          directory_(std::move(directory)),
          log_(directory_ / "log.txt"),
          threads_(threads),
          begin_(begin) {}

    RunLog& log() { return log_; }
    const OutputDirectory& directory() const { return directory_; }

    void say(const std::string& text) {
        log_.information(text);
        if (options_.out != nullptr)
            *options_.out << text << std::endl;
    }

    /// What the plan warns of, for those who did not ask for it.
    void warn() {
        for (const std::string& warning : texts_of(plan_.remarks, Remark::Severity::warning)) {
            log_.warning(warning);
            if (options_.out != nullptr)
                *options_.out << "warning: " << warning << std::endl;
        }
    }

    /// Building the initial state of a large box takes its time.
    void announce_building() {
        constexpr std::int64_t quick = 2'000'000; // cells
        if (plan_.cells > quick)
            say(fmt::format("setting up {:.1f} million cells and {} vesicle{} ...",
                            1e-6 * static_cast<double>(plan_.cells), case_.parameters.vesicles.size(),
                            case_.parameters.vesicles.size() == 1 ? "" : "s"));
    }

    /// `resumed` is the checkpoint the run goes on from, if any.
    RunOutcome run(Engine& engine, RunMetrics& metrics, const IntactCheckpoint* resumed) {
        account_.setting_up = seconds_since(begin_);
        account_.first_step = engine.steps_done();
        account_.threads = threads_;
        account_.instruction_set = std::string(engine.instruction_set());
        say(fmt::format("{}: {} x {} x {} cells, steps {} to {}, {}{} thread{} ({}), into {}", title(),
                        case_.parameters.size.x, case_.parameters.size.y, case_.parameters.size.z,
                        engine.steps_done(), case_.run.steps, ranks_text(), threads_,
                        threads_ == 1 ? "" : "s", engine.instruction_set(), directory_.path().string()));
        const LoopResult result = loop(engine, metrics, resumed);
        account_.bytes_allocated = static_cast<double>(engine.bytes_allocated());
        account_.interface_fraction = engine.interface_fraction();
        account_.profile = engine.profile();
        if (options_.crew != nullptr)
            account_.parallel = options_.crew->report();
        return conclude(result, metrics);
    }

private:
    std::string ranks_text() const {
        if (options_.crew == nullptr)
            return {};
        const Vec3<int> blocks = options_.crew->report().blocks;
        return fmt::format("{} ranks in {} x {} x {} blocks of ", options_.crew->ranks().count(), blocks.x,
                           blocks.y, blocks.z);
    }

    std::string title() const { return case_.title.empty() ? case_.source_file : case_.title; }

    LoopResult loop(Engine& engine, RunMetrics& metrics, const IntactCheckpoint* resumed) {
        const StopRequest stop(case_.run.wall_time, begin_);
        Progress progress(progress_settings(engine), options_.out, Clock::now());
        const auto loop_begin = Clock::now();
        std::unique_ptr<FieldCrew> fields = options_.crew != nullptr
                                                ? options_.crew->fields()
                                                : std::make_unique<LoneFieldCrew>(case_, threads_, engine);
        LoopResult result;
        try {
            const auto from =
                resumed != nullptr ? std::optional(resumed->checkpoint.engine.step) : std::nullopt;
            const RunHands hands{options_.crew != nullptr ? *options_.crew : nobody_, *fields, threads_};
            RunRecorder recorder(case_, directory_, log_, metrics, progress, stop, hands, from);
            if (resumed != nullptr)
                recorder.restore(resumed->checkpoint, resumed->path);
            const auto settle = [&] {
                account_.output = recorder.output();
            };
            try {
                result = run_loop(engine, case_.run.steps, Schedule(case_.output), recorder);
            } catch (...) {
                settle();
                throw;
            }
            settle();
        } catch (const RunError& failure) {
            result = {RunEnd::failed, engine.steps_done(), failure.what(), std::nullopt};
        } catch (const std::bad_alloc&) {
            result = {RunEnd::failed, engine.steps_done(), "not enough memory", std::nullopt};
        }
        progress.finish();
        account_.output.run_seconds = seconds_since(loop_begin);
        account_.recording = account_.output.total().seconds;
        account_.stepping = std::max(0.0, account_.output.run_seconds - account_.recording);
        return result;
    }

    Progress::Settings progress_settings(const Engine& engine) const {
        Progress::Settings settings;
        settings.first_step = engine.steps_done();
        settings.last_step = case_.run.steps;
        settings.cells = static_cast<double>(plan_.cells);
        if (case_.scales)
            settings.seconds_per_step = case_.scales->step;
        settings.terminal = options_.terminal;
        return settings;
    }

    RunOutcome conclude(const LoopResult& result, const RunMetrics& metrics) {
        RunOutcome outcome{ExitStatus::done, result.end, result.step, {}};
        const std::string where = directory_.path().string();
        std::string ended;
        switch (result.end) {
        case RunEnd::finished:
            ended = fmt::format("done: {} steps", result.step);
            break;
        case RunEnd::steady:
            ended = fmt::format("done: steady after {} steps", result.step);
            break;
        case RunEnd::stopped:
            outcome.status = ExitStatus::stopped;
            outcome.message = fmt::format("stopped after step {}: {}; a checkpoint is written; continue with "
                                          "`vesica resume {}`",
                                          result.step, result.reason, where);
            break;
        case RunEnd::failed:
            outcome.status = ExitStatus::run_failed;
            outcome.message =
                failure_text(case_, plan_, result) + "; everything written before is in " + where;
            break;
        }
        account_.total = seconds_since(begin_);
        const RunSummary summary = account_.summary(case_, plan_, result, metrics.last());
        try {
            write_summary(directory_ / "summary.json", summary);
        } catch (const RunError& failure) {
            // A full disk may have ended the run already; the first reason is the one to tell.
            if (outcome.status == ExitStatus::done)
                outcome = {ExitStatus::run_failed, result.end, result.step, failure.what()};
        }
        for (const Verdict& verdict : summary.verdicts)
            if (!verdict.passed && result.end != RunEnd::stopped && result.end != RunEnd::failed)
                say(fmt::format("verdict: {}: {}", verdict.name, verdict.text));
        if (outcome.status == ExitStatus::done)
            say(fmt::format("{} in {}, {:.2f} MLUPS; results are in {}", ended, duration_text(account_.total),
                            account_.mlups(static_cast<double>(plan_.cells), result.step), where));
        else
            log_.error(outcome.message);
        if (!account_.output.kinds.empty())
            say(account_.output.text());
        if (!account_.parallel.ranks.empty())
            say(account_.parallel.text());
        if (options_.profile)
            say(account_.profile.text(threads_));
        return outcome;
    }

    const Case& case_;
    const Plan& plan_;
    const RunOptions& options_;
    OutputDirectory directory_;
    // From the first file on a run ends with a checkpoint, though that waits for the initial state to be
    // built.
    StopSignals signals_;
    RunLog log_;
    int threads_;
    Clock::time_point begin_;
    RunAccount account_;
    Colleagues nobody_;
};

} // namespace

RunOutcome run_case(const Case& original, const RunOptions& options) {
    const auto begin = Clock::now();
    Case what = settled(original);
    const Plan plan = make_plan(what, options.plan);
    refuse_errors(plan);
    if (options.crew != nullptr) // a box that cannot be cut is refused before anything is written
        layout_for(what.parameters.lattice(), options.crew->ranks().count(), options.blocks,
                   slide_of(what.parameters));
    Colleagues nobody;
    Colleagues& colleagues = options.crew != nullptr ? *options.crew : nobody;
    std::optional<StartState> start;
    if (what.initial) {
        start = find_start_state(what, colleagues);
        what.initial = InitialCheckpoint{start->path.string(), std::nullopt};
    }
    // The directory first: a refusal should not take as long as building the initial state does.
    OutputDirectory directory = OutputDirectory::create(options.directory, options.overwrite);
    if (options.begun)
        options.begun();
    const int threads = threads_for(options);
    Session session(what, plan, options, std::move(directory), threads, begin);
    write_atomically(session.directory() / "case.toml", what.source_text);
    write_atomically(session.directory() / "resolved.toml", resolved_toml(what));
    session.log().information(fmt::format("vesica {} ({}, {})", version, commit, compiler));
    session.warn();
    session.announce_building();

    const auto engine =
        build_engine(what, options, threads, start ? std::optional(start->path) : std::nullopt);
    if (start) {
        load_state(*engine, options, start->path, start->change, what.parameters.lattice());
        session.log().information(
            fmt::format("starts from step {} of {}", start->step, start->path.string()));
    }
    RunMetrics metrics(what.parameters, what.run, what.output.metrics_every, engine->snapshot());
    return session.run(*engine, metrics, nullptr);
}

RunOutcome resume_run(const std::optional<std::int64_t>& steps, const RunOptions& options) {
    const auto begin = Clock::now();
    OutputDirectory directory = OutputDirectory::open(options.directory);
    Colleagues nobody;
    Colleagues& colleagues = options.crew != nullptr ? *options.crew : nobody;
    IntactCheckpoint found = newest_intact_checkpoint(options.directory / "checkpoints", colleagues);
    Case what = read_case_text(found.checkpoint.case_text, found.path.string());
    const std::int64_t done = found.checkpoint.engine.step;
    if (steps && *steps < done)
        throw InputError(
            fmt::format("--steps is {}; expected at least {}, the step of {}; try a larger one, for it means "
                        "steps in total",
                        *steps, done, found.path.string()));
    if (steps)
        what.run.steps = *steps;

    // What a case has been begun with is not refused any more.
    const Plan plan = make_plan(what, PlanOptions{true});
    const int threads = threads_for(options);
    Session session(what, plan, options, std::move(directory), threads, begin);
    for (const std::string& refused : found.refused)
        session.log().warning(refused);
    session.log().information(fmt::format("vesica {} ({}, {}) resumes from {}", version, commit, compiler,
                                          found.path.filename().string()));
    session.announce_building();
    const auto engine = build_engine(what, options, threads, found.path);
    RunMetrics metrics(what.parameters, what.run, what.output.metrics_every, engine->snapshot());
    load_state(*engine, options, found.path, {}, what.parameters.lattice());
    metrics.restore(found.checkpoint.notes);
    return session.run(*engine, metrics, &found);
}

} // namespace vesica
