#include "simulation/run_account.hpp"

#include "core/version.hpp"
#include "simulation/run_verdicts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <variant>

namespace vesica {

namespace {

const char* name_of(RunEnd end) {
    switch (end) {
    case RunEnd::finished:
        return "finished";
    case RunEnd::steady:
        return "steady";
    case RunEnd::stopped:
        return "stopped";
    case RunEnd::failed:
        return "failed";
    }
    return "failed";
}

std::map<std::string, double> groups_of(const Plan& plan) {
    std::map<std::string, double> groups = {{"mach_of_bending", plan.mach},
                                            {"relaxation_time", plan.relaxation_time}};
    for (std::size_t index = 0; index < plan.vesicles.size(); ++index) {
        const VesiclePlan& vesicle = plan.vesicles[index];
        const auto set = [&](const char* name, double value) {
            groups[fmt::format("vesicle_{}_{}", index, name)] = value;
        };
        set("confinement", vesicle.confinement);
        set("viscosity_ratio", vesicle.viscosity_ratio);
        set("target_reduced_volume", vesicle.target_reduced_volume);
        set("resolution", vesicle.resolution);
        if (vesicle.reynolds)
            set("reynolds_of_bending", *vesicle.reynolds);
        if (vesicle.bending_time)
            set("bending_time", *vesicle.bending_time);
        if (vesicle.bending_over_tension)
            set("bending_over_tension", *vesicle.bending_over_tension);
    }
    return groups;
}

/// Whether a run can break of what the plan says: of physics, not of schedules, outputs or a symmetric start.
bool can_break(const Remark& remark) {
    const std::string& key = remark.key;
    return remark.severity == Remark::Severity::warning && !key.empty() && !key.starts_with("run.") &&
           !key.starts_with("output.") && !key.ends_with(".perturbation");
}

/// The first reason that fits; the judgements of the plan come before guesses.
std::string likely_cause(const Case& what, const Plan& plan, const Trouble& trouble) {
    if (trouble.cause.find("inlet or outlet") != std::string::npos)
        return "it was carried there; try a longer box or fewer steps";
    const auto warning = std::find_if(plan.remarks.begin(), plan.remarks.end(), can_break);
    if (warning != plan.remarks.end())
        return fmt::format("the plan warned: {}", warning->text);
    if (plan.relaxation_time < 0.55)
        return fmt::format(
            "a relaxation time of {:.3f} is close to 1/2; try a larger fluid.kinematic_viscosity",
            plan.relaxation_time);
    if (trouble.vesicle < 0 || static_cast<std::size_t>(trouble.vesicle) >= plan.vesicles.size())
        return "the fluid became too fast for the lattice; try smaller forces or a larger "
               "fluid.kinematic_viscosity";
    const auto index = static_cast<std::size_t>(trouble.vesicle);
    const VesicleType& type = what.parameters.types[what.parameters.vesicles[index].type];
    if (type.area.deflation && trouble.step <= type.area.ramp)
        return fmt::format("the area changes too fast; try a larger vesicle_type.{}.area.ramp", type.name);
    if (plan.vesicles[index].resolution < 5.0)
        return fmt::format(
            "the membrane bends more sharply than the lattice resolves; try a larger vesicle[{}].radius",
            index);
    return fmt::format("the membrane's forces are too stiff for the lattice; try a smaller "
                       "vesicle_type.{}.bending.modulus or a larger fluid.kinematic_viscosity",
                       type.name);
}

} // namespace

double RunAccount::mlups(double cells, std::int64_t last_step) const {
    return stepping > 0.0 ? 1e-6 * cells * static_cast<double>(last_step - first_step) / stepping : 0.0;
}

RunSummary RunAccount::summary(const Case& what, const Plan& plan, const LoopResult& result,
                               const std::vector<MetricsRow>& last) const {
    RunSummary summary;
    summary.title = what.title;
    summary.end = name_of(result.end);
    summary.reason = result.trouble ? failure_text(what, plan, result) : result.reason;
    summary.first_step = first_step;
    summary.last_step = result.step;
    summary.verdicts = judge_run(what.parameters, what.run, result.end, last);
    summary.warnings = texts_of(plan.remarks, Remark::Severity::warning);
    summary.size = what.parameters.size;
    summary.precision = name_of(what.parameters.numerics.precision);
    summary.device = "cpu";
    summary.instruction_set = instruction_set;
    summary.threads = threads;
    summary.ranks = std::max(1, static_cast<int>(parallel.ranks.size()));
    summary.parallel = parallel;
    summary.bytes_allocated = bytes_allocated;
    summary.mlups = mlups(static_cast<double>(plan.cells), result.step);
    summary.seconds = {
        {"total", total}, {"setting_up", setting_up}, {"stepping", stepping}, {"recording", recording}};
    summary.output = output;
    summary.profile = profile.numbers(threads);
    summary.versions = {{"vesica", std::string(version)},
                        {"commit", std::string(commit)},
                        {"compiler", std::string(compiler)},
                        {"build_type", std::string(build_type)}};
    summary.scales = what.scales;
    summary.dimensionless = groups_of(plan);
    summary.dimensionless["interface_fraction"] = interface_fraction;
    summary.columns = metrics_columns();
    for (const MetricsRow& row : last)
        summary.last_metrics.push_back(metrics_values(row));
    return summary;
}

std::string failure_text(const Case& what, const Plan& plan, const LoopResult& result) {
    if (!result.trouble)
        return result.reason;
    const Trouble& trouble = *result.trouble;
    const std::string who = trouble.vesicle >= 0
                                ? fmt::format(", in the membrane of vesicle[{}]", trouble.vesicle)
                                : std::string(", outside the membranes");
    return fmt::format("the run failed at step {}, cell ({}, {}, {}){}: {}; likely cause: {}", trouble.step,
                       trouble.cell.x, trouble.cell.y, trouble.cell.z, who, trouble.cause,
                       likely_cause(what, plan, trouble));
}

} // namespace vesica
