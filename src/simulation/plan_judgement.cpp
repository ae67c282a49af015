#include "simulation/plan_judgement.hpp"

#include "case/resolution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vesica {

namespace {

using Severity = Remark::Severity;

/// The bending modulus that the recolouring feels like at nu = 1/6.
constexpr double recolouring_modulus = 0.0024;

template <class... Arguments>
void add(Remarks& remarks, Severity severity, const std::string& key, fmt::format_string<Arguments...> text,
         Arguments&&... arguments) {
    remarks.push_back({severity, key, key + fmt::format(text, std::forward<Arguments>(arguments)...)});
}

void judge_bends(double segregation, const std::string& name, const VesiclePlan& plan, Remarks& remarks) {
    const bool target_decides =
        plan.target_smallest_radius && *plan.target_smallest_radius < plan.smallest_radius;
    const double smallest = target_decides ? *plan.target_smallest_radius : plan.smallest_radius;
    const std::string where =
        target_decides ? fmt::format("the rim of the discocyte of reduced volume {:.3f} it is deflated to",
                                     plan.target_reduced_volume)
                       : std::string("the sharpest bend of its initial shape");
    const double better = std::ceil(plan.radius * resolution_note / plan.resolution);
    const auto say = [&](Severity severity, double bound) {
        add(remarks, severity, name + ".radius",
            " is {:g}: {} has a radius of curvature of {:.2f} cells, and beta times it is {:.2f}; expected "
            "at least "
            "{:g}; try a radius of {:.0f} or more",
            plan.radius, where, smallest, plan.resolution, bound, better);
    };
    switch (judge_resolution(segregation, smallest)) {
    case Resolution::fine:
        break;
    case Resolution::note:
        say(Severity::note, resolution_note);
        break;
    case Resolution::warning:
        say(Severity::warning, resolution_warning);
        break;
    case Resolution::error:
        say(Severity::error, resolution_error);
        break;
    }
}

void judge_stiffness(const VesicleType& type, const PlanOptions& options, Remarks& remarks) {
    const double kappa = type.bending.modulus;
    if (kappa <= 0.0)
        return;
    const double share = recolouring_modulus / kappa;
    const std::string key = "vesicle_type." + type.name + ".bending.modulus";
    const bool soft = share > 0.1;
    if (soft)
        add(remarks, options.accept_soft_membranes ? Severity::warning : Severity::error, key,
            " is {:g}: the recolouring resists bending by itself like a modulus of about {:g}, {:.0f} % of "
            "this one; "
            "expected at least {:g}; try a larger modulus{}",
            kappa, recolouring_modulus, 100.0 * share, 10.0 * recolouring_modulus,
            options.accept_soft_membranes ? "" : ", or --accept-soft-membranes");
    else if (share > 0.05)
        add(remarks, Severity::note, key, " is {:g}: the recolouring adds about {:.0f} % to it by itself",
            kappa, 100.0 * share);
}

void judge_constraint(const VesicleType& type, const std::string& name, double eta, const VesiclePlan& plan,
                      Remarks& remarks) {
    const AreaParameters& area = type.area;
    const std::string key = "vesicle_type." + type.name;
    const double kappa = type.bending.modulus;
    const bool deflated = plan.target_area > 1.001 * plan.area;
    if (std::holds_alternative<MultiplierConstraint>(area.constraint) && type.sigma != 0.0)
        add(remarks, Severity::note, key + ".tension.sigma",
            " is {:g}: with the area held by a multiplier it decides nothing, the multiplier takes it up",
            type.sigma);
    if (area.deflation && std::holds_alternative<NoConstraint>(area.constraint))
        add(remarks, Severity::warning, key + ".area.deflation",
            " is {:g}, but the area's constraint is none: nothing holds that area; try constraint = "
            "\"multiplier\"",
            *area.deflation);
    if (plan.target_reduced_volume > 1.0 + 1e-9)
        add(remarks, Severity::error, key + ".area",
            " aims at a reduced volume of {:.4f}; expected at most 1, for no surface encloses more than a "
            "sphere; try "
            "a deflation of 1 or more",
            plan.target_reduced_volume);
    const double K = plan.penalty_modulus;
    if (K <= 0.0)
        return;
    const double fastest = eta * plan.radius;
    if (K > fastest)
        add(remarks, Severity::warning, key + ".area",
            " has a penalty modulus K_A of {:.3g} for {}; expected below eta R0 = {:.3g}, above which the "
            "tension "
            "overshoots from step to step; try a smaller one, or constraint = \"multiplier\"",
            K, name, fastest);
    if (deflated && kappa > 0.0 && K > 50.0 * kappa / (plan.radius * plan.radius) && area.ramp == 0)
        add(remarks, Severity::warning, key + ".area",
            " jumps to its target under K_A = {:.3g}, which buckles high modes (starfish, holes); expected "
            "below "
            "50 kappa/R0^2 = {:.3g}; try a ramp of {:.0f} steps",
            K, 50.0 * kappa / (plan.radius * plan.radius), std::ceil(5.0 * *plan.bending_time));
}

void judge_path(const VesicleType& type, const VesicleParameters& vesicle, const std::string& name,
                const VesiclePlan& plan, const RunParameters& run, Remarks& remarks) {
    if (!plan.bending_time)
        return;
    const double tau = *plan.bending_time;
    const double change = plan.target_area / plan.area - 1.0;
    if (std::abs(change) < 1e-3)
        return;
    const auto ramp = static_cast<double>(type.area.ramp);
    if (ramp < 5.0 * tau)
        add(remarks, Severity::warning, "vesicle_type." + type.name + ".area.ramp",
            " is {}: {} goes to its area in {:.1f} bending times (eta R0^3/kappa = {:.0f} steps); expected "
            "at least 5 "
            "for a smooth shape; try ramp = {:.0f}",
            type.area.ramp, name, ramp / tau, tau, std::ceil(5.0 * tau / 100.0) * 100.0);
    if (run.steps > 0 && type.area.ramp >= run.steps)
        add(remarks, Severity::warning, "run.steps",
            " is {}: the run ends before the ramp of {} is over; expected more than {}; try run.steps = {}",
            run.steps, name, type.area.ramp, 3 * type.area.ramp);
    else if (run.steps > 0 && static_cast<double>(run.steps) - ramp < 5.0 * tau)
        add(remarks, Severity::note, name, " has {:.1f} bending times to relax in after its ramp",
            (static_cast<double>(run.steps) - ramp) / tau);
    if (std::holds_alternative<SphereShape>(vesicle.shape) && vesicle.perturbations.empty() && change > 0.0)
        add(remarks, Severity::warning, name + ".perturbation",
            " is missing: a perfect sphere has nothing that could grow when its area does; try "
            "[[vesicle.perturbation]] with l = 2, m = 0, amplitude = -0.01");
    if (plan.target_reduced_volume > 0.75 && plan.target_reduced_volume < 0.99)
        add(remarks, Severity::note, name,
            " is deflated to a reduced volume of {:.3f}: above .750 oblate shapes are unstable, it will "
            "become a "
            "prolate unless a symmetry of the lattice holds it",
            plan.target_reduced_volume);
}

} // namespace

void judge_fluid(const Parameters& parameters, const Plan& plan, Remarks& remarks) {
    const double beta = parameters.fluid.segregation;
    if (beta > 1.0 / std::numbers::sqrt2)
        add(remarks, Severity::error, "fluid.segregation",
            " is {:g}; expected at most 0.7071, above which a colour's populations turn negative; "
            "try 0.67",
            beta);
    if (plan.relaxation_time < 0.52)
        add(remarks, Severity::warning, "fluid.kinematic_viscosity",
            " is {:g}, a relaxation time of {:.4f}; expected at least 0.52 for a stable run; "
            "try 0.1666667",
            parameters.fluid.kinematic_viscosity, plan.relaxation_time);
    if (plan.relaxation_time > 3.5)
        add(remarks, Severity::warning, "fluid.kinematic_viscosity",
            " is {:g}, a relaxation time of {:.3f}; expected at most 3.5, above which the "
            "lattice's own errors grow; try 0.5",
            parameters.fluid.kinematic_viscosity, plan.relaxation_time);
    constexpr double speed_of_sound = 0.57735026918962576; // 1/sqrt(3)
    double own = 0.0;
    for (const VesiclePlan& vesicle : plan.vesicles)
        own = std::max(own, vesicle.bending_speed.value_or(0.0));
    if (own > 0.1 * speed_of_sound)
        add(remarks, Severity::warning, "fluid",
            ": the fastest vesicle moves its membrane at about Mach {:.2f}; expected at most 0.1; try a "
            "smaller bending.modulus or a larger kinematic_viscosity",
            own / speed_of_sound);
}

void judge_flow(const Parameters& parameters, const Plan& plan, const RunParameters& run, Remarks& remarks) {
    const FlowParameters& flow = parameters.flow;
    constexpr double fastest = 0.057735026918962576; // Mach 0.1
    const std::string key = flow.shear        ? "flow.shear.rate"
                            : flow.extension  ? "flow.extension.rate"
                            : flow.poiseuille ? flow.poiseuille->mean_velocity
                                                    ? "flow.poiseuille.mean_velocity"
                                                    : "flow.poiseuille.pressure_gradient"
                            : flow.body_force ? "flow.body_force"
                                              : "boundary";
    const double strength = flow.shear       ? flow.shear->rate
                            : flow.extension ? flow.extension->rate
                            : flow.poiseuille
                                ? flow.poiseuille->mean_velocity.value_or(flow.poiseuille->pressure_gradient)
                                : plan.flow.speed;
    if (plan.flow.speed > fastest)
        add(remarks, Severity::error, key,
            " is {:.4g}, which makes speeds of {:.3g} cells per step, Mach {:.2f}; expected at most Mach "
            "0.1, above "
            "which the fluid is compressed; try {:.2g}, or a smaller box",
            strength, plan.flow.speed, plan.flow.speed / (10.0 * fastest),
            strength * 0.9 * fastest / plan.flow.speed);
    for (std::size_t index = 0; index < plan.different; ++index) {
        const VesicleType& type = parameters.types[parameters.vesicles[index].type];
        const double radius = plan.vesicles[index].radius;
        if (plan.vesicles[index].buoyant_speed > fastest)
            add(remarks, Severity::error,
                parameters.vesicles[index].buoyancy ? fmt::format("vesicle[{}].buoyancy", index)
                                                    : "vesicle_type." + type.name + ".buoyancy",
                " moves vesicle[{}] at up to {:.3g} cells per step, Mach {:.2f}; expected at most Mach 0.1; "
                "try {:.2g} "
                "of it",
                index, plan.vesicles[index].buoyant_speed,
                plan.vesicles[index].buoyant_speed / (10.0 * fastest),
                fastest / plan.vesicles[index].buoyant_speed);
        if (!plan.flow.rate || *plan.flow.rate <= 0.0)
            continue;
        const double reynolds = flow_groups(parameters, *plan.flow.rate, radius, type).reynolds;
        if (reynolds > 0.1 * (1.0 + 1e-9))
            add(remarks, Severity::warning, key,
                " is {:.4g}: vesicle[{}] has Re = rho gamma R0^2/eta = {:.2g}; expected at most 0.1, as in "
                "small "
                "vessels; raise kinematic_viscosity to {:.2g} or lower it to {:.2g}",
                strength, index, reynolds, parameters.fluid.kinematic_viscosity * reynolds / 0.1,
                strength * 0.1 / reynolds);
    }
    const auto judge_times = [&](const std::string& table, const FlowTimes& times) {
        if (run.steps > 0 && times.start >= run.steps)
            add(remarks, Severity::warning, table + ".start",
                " is {}: the run ends before, after {} steps; expected less; try start = 0", times.start,
                run.steps);
    };
    for (int axis = 0; axis < 3; ++axis)
        if (const auto* open = std::get_if<OpenEnds>(&parameters.ends[static_cast<std::size_t>(axis)]))
            judge_times(fmt::format("boundary.{}.{}", "xyz"[axis], open -> enters_below ? "lower" : "upper"),
                        open->times);
    for (int axis = 0; axis < 3; ++axis)
        if (const auto* walls = std::get_if<WallEnds>(&parameters.ends[static_cast<std::size_t>(axis)])) {
            const std::string table = fmt::format("boundary.{}.", "xyz"[axis]);
            if (walls->lower_velocity != Vec3<double>{})
                judge_times(table + "lower", walls->lower_times);
            if (walls->upper_velocity != Vec3<double>{})
                judge_times(table + "upper", walls->upper_times);
        }
    if (parameters.wetting != Parameters{}.wetting && !parameters.is_bounded() && !parameters.obstacles)
        add(remarks, Severity::warning, "boundary.wetting",
            " is {:g}, but there are no walls or obstacles; expected some; try removing it",
            parameters.wetting);
    if (flow.shear)
        judge_times("flow.shear", flow.shear->times);
    if (flow.poiseuille)
        judge_times("flow.poiseuille", flow.poiseuille->times);
    if (flow.extension)
        judge_times("flow.extension", flow.extension->times);
    if (flow.body_force) {
        judge_times("flow.body_force", flow.body_force->times);
        if (!parameters.is_bounded() && !parameters.obstacles)
            add(remarks, Severity::warning, "flow.body_force",
                " pushes a fluid that nothing holds: it grows faster for ever; expected walls; try "
                "[boundary.z] with "
                "lower and upper = {{ type = \"wall\" }}");
    }
}

void judge_vesicle(const Parameters& parameters, std::size_t vesicle, const VesiclePlan& plan,
                   const RunParameters& run, const PlanOptions& options, Remarks& remarks) {
    const VesicleParameters& what = parameters.vesicles[vesicle];
    const VesicleType& type = parameters.types[what.type];
    const std::string name = fmt::format("vesicle[{}]", vesicle);
    const double eta = parameters.fluid.density * parameters.fluid.kinematic_viscosity;
    judge_bends(parameters.fluid.segregation, name, plan, remarks);
    const auto same_type = [&](const VesicleParameters& other) {
        return other.type == what.type;
    };
    const auto first = std::find_if(parameters.vesicles.begin(), parameters.vesicles.end(), same_type);
    if (&*first == &what)
        judge_stiffness(type, options, remarks);
    if (plan.reynolds && *plan.reynolds > 1.0)
        add(remarks, Severity::warning, name,
            ": the Reynolds number of its own motion, kappa/(rho nu^2 R0), is {:.2g}; expected at most 1; "
            "try a "
            "smaller bending.modulus or a larger kinematic_viscosity",
            *plan.reynolds);
    const bool differs = type.viscosity_ratio != 1.0; // or the fluid's own viscosity has been judged
    if (differs && (plan.inner_relaxation_time > 3.5 || plan.inner_relaxation_time < 0.52))
        add(remarks, Severity::warning, "vesicle_type." + type.name + ".viscosity_ratio",
            " is {:g}: the relaxation time inside is {:.3f}; expected between 0.52 and "
            "3.5; try a kinematic_viscosity of {:.3g}",
            type.viscosity_ratio, plan.inner_relaxation_time, 1.0 / (3.0 * std::sqrt(type.viscosity_ratio)));
    judge_constraint(type, name, eta, plan, remarks);
    judge_path(type, what, name, plan, run, remarks);
}

} // namespace vesica
