#include "simulation/start_state.hpp"

#include "io/case_file.hpp"
#include "io/checkpoint_store.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace vesica {

namespace {

[[noreturn]] void refuse(const Case& what, const std::string& key, const std::string& text) {
    const std::string value = key == "initial.step" ? fmt::format("{}", *what.initial->step)
                                                    : fmt::format("\"{}\"", what.initial->path);
    throw InputError(what.place(key), fmt::format("{} is {}; {}", key, value, text));
}

/// Beside the case file or, if it is not there, from the working directory.
std::filesystem::path find_start(const Case& what) {
    const std::filesystem::path beside =
        std::filesystem::path(what.source_file).parent_path() / what.initial->path;
    for (const std::filesystem::path& path : {beside, std::filesystem::path(what.initial->path)})
        if (std::filesystem::exists(path))
            return std::filesystem::absolute(path).lexically_normal();
    refuse(
        what, "initial.checkpoint",
        "there is no such file or directory; expected a run's directory or one of its checkpoints; try the "
        "directory `vesica run` named at its end");
}

IntactCheckpoint newest_of(const Case& what, const std::filesystem::path& store, Colleagues& colleagues) {
    try {
        return newest_intact_checkpoint(store, colleagues);
    } catch (const InputError& none) {
        refuse(what, "initial.checkpoint",
               std::string("expected a run that left a checkpoint; ") + none.what() +
                   "; try a run with [output] checkpoint = { every = ... }");
    }
}

IntactCheckpoint read_start(const Case& what, Colleagues& colleagues) {
    const std::filesystem::path path = find_start(what);
    try {
        if (!std::filesystem::is_directory(path)) {
            if (what.initial->step)
                refuse(what, "initial.step",
                       "expected none beside a single file; try the run's directory as checkpoint");
            return {read_checkpoint_notes(path, colleagues), path, {}};
        }
        const std::filesystem::path store = path / "checkpoints";
        if (!what.initial->step)
            return newest_of(what, store, colleagues);
        const std::filesystem::path chosen = checkpoint_path(store, *what.initial->step);
        if (!std::filesystem::exists(chosen))
            refuse(what, "initial.step",
                   fmt::format("there is no {}; expected the step of a checkpoint in {}; try without it, "
                               "which takes the newest",
                               chosen.filename().string(), store.string()));
        return {read_checkpoint_notes(chosen, colleagues), chosen, {}};
    } catch (const RunError& damaged) {
        refuse(what, "initial.checkpoint",
               std::string("expected a checkpoint that is intact; ") + damaged.what());
    }
}

void check_model(const Case& what, const Case& before, std::int64_t step, const std::filesystem::path& path) {
    const auto other = [&](const std::string& name, const std::string& found, const std::string& expected) {
        refuse(what, "initial.checkpoint",
               fmt::format("{} in {} is {}, but {} here; try the same in both", name, path.string(), found,
                           expected));
    };
    const auto size_text = [](const Vec3<int>& size) {
        return fmt::format("[{}, {}, {}]", size.x, size.y, size.z);
    };
    const auto precision_text = [](Precision precision) {
        return fmt::format("\"{}\"", name_of(precision));
    };
    const Parameters& now = what.parameters;
    const Parameters& then = before.parameters;
    if (!(then.size == now.size))
        other("lattice.size", size_text(then.size), size_text(now.size));
    const auto ends_text = [](const Parameters& parameters) {
        std::string bounded;
        for (int a = 0; a < 3; ++a)
            if (parameters.is_bounded(a))
                bounded += "xyz"[a];
        return bounded.empty() ? std::string("periodic along all axes") : "bounded along " + bounded;
    };
    if (!(then.lattice() == now.lattice()))
        refuse(what, "initial.checkpoint",
               fmt::format(
                   "the box in {} is {}, but {} here; try the same walls in both: the earlier case may have "
                   "[boundary] walls at rest, or this flow with a later start",
                   path.string(), ends_text(then), ends_text(now)));
    if (const ShearFlow* const slid = then.sliding()) {
        const double displacement =
            slid->times.total(step) * slid->rate * static_cast<double>(then.size[slid->gradient]);
        if (displacement != 0.0)
            refuse(what, "initial.checkpoint",
                   fmt::format("in {} the images above the box have moved on by {:g} cells (flow.shear with "
                               "lees-edwards); expected a state from before that flow, as a case begins with "
                               "images in their places; try vesica resume, or an earlier step",
                               path.string(), displacement));
    }
    if (then.obstacles != now.obstacles)
        refuse(what, "initial.checkpoint",
               fmt::format("[obstacles] in {} are not those here; try the same in both", path.string()));
    if (then.numerics.precision != now.numerics.precision)
        other("numerics.precision", precision_text(then.numerics.precision),
              precision_text(now.numerics.precision));
    if (then.fluid.density != now.fluid.density)
        other("fluid.density", fmt::format("{:g}", then.fluid.density),
              fmt::format("{:g}", now.fluid.density));
    if (then.vesicles.size() != now.vesicles.size())
        other("the number of vesicles", fmt::format("{}", then.vesicles.size()),
              fmt::format("{}", now.vesicles.size()));
}

std::vector<std::size_t> kinds_of_constraint(const Parameters& parameters) {
    std::vector<std::size_t> kinds;
    for (const VesicleParameters& vesicle : parameters.vesicles)
        kinds.push_back(parameters.types.at(vesicle.type).area.constraint.index());
    return kinds;
}

} // namespace

void StateChange::apply(EngineState& state) const {
    if (from_step_zero)
        state.step = 0;
    if (without_controllers)
        std::fill(state.controllers.begin(), state.controllers.end(), 0.0);
}

StartState find_start_state(const Case& what, Colleagues& colleagues) {
    const IntactCheckpoint found = read_start(what, colleagues);
    const Case before = read_case_text(found.checkpoint.case_text, found.path.string());
    check_model(what, before, found.checkpoint.engine.step, found.path);
    StartState start;
    start.path = found.path;
    start.step = found.checkpoint.engine.step;
    start.change.from_step_zero = true;
    start.change.without_controllers =
        kinds_of_constraint(what.parameters) != kinds_of_constraint(before.parameters);
    return start;
}

} // namespace vesica
