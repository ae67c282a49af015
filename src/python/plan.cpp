#include "simulation/plan.hpp"

#include "python/bindings.hpp"
#include "python/without_gil.hpp"
#include "simulation/plan_text.hpp"
#include "simulation/run_start.hpp"
#include "simulation/start_state.hpp"

#include <pybind11/stl.h>

#include <optional>
#include <string>

namespace py = pybind11;

namespace vesica {

namespace {

struct CheckedCase {
    Case what;
    Plan plan;
    std::optional<RunCost> cost;
    std::string text;
};

CheckedCase check_case(const Case& original, int threads, bool with_cost, bool accept_soft_membranes) {
    CheckedCase checked;
    checked.what = settled(original);
    checked.plan = make_plan(checked.what, PlanOptions{accept_soft_membranes});
    refuse_errors(checked.plan);
    Colleagues nobody;
    if (checked.what.initial)
        find_start_state(checked.what, nobody);
    if (threads < 1)
        threads = default_threads();
    if (with_cost)
        checked.cost =
            measure_cost(checked.what.parameters, checked.what.run, checked.what.output, threads,
                         [](const Parameters& parameters, int n) { return make_engine(parameters, n); });
    checked.text = plan_text(checked.what, checked.plan, checked.cost, threads);
    return checked;
}

py::dict groups_of(const CheckedCase& checked, std::size_t index) {
    const VesiclePlan& vesicle = checked.plan.vesicles[index];
    const Parameters& parameters = checked.what.parameters;
    const VesicleType& type = parameters.types[parameters.vesicles[index].type];
    py::dict groups;
    groups["type"] = type.name;
    groups["radius"] = vesicle.radius;
    groups["volume"] = vesicle.volume;
    groups["area"] = vesicle.area;
    groups["target_area"] = vesicle.target_area;
    groups["reduced_volume"] = vesicle.reduced_volume;
    groups["target_reduced_volume"] = vesicle.target_reduced_volume;
    groups["resolution"] = vesicle.resolution;
    groups["viscosity_ratio"] = vesicle.viscosity_ratio;
    groups["inner_relaxation_time"] = vesicle.inner_relaxation_time;
    groups["confinement"] = vesicle.confinement;
    groups["bending_time"] = vesicle.bending_time;
    groups["bending_speed"] = vesicle.bending_speed;
    groups["capillary_time"] = vesicle.capillary_time;
    groups["reynolds"] = vesicle.reynolds;
    groups["capillary_bending"] = py::none();
    groups["capillary_tension"] = vesicle.bending_over_tension;
    if (checked.plan.flow.rate) {
        const FlowGroups flow = flow_groups(parameters, *checked.plan.flow.rate, vesicle.radius, type);
        groups["reynolds"] = flow.reynolds;
        groups["capillary_bending"] = flow.capillary_bending;
        groups["capillary_tension"] = flow.capillary_tension;
    }
    return groups;
}

py::dict described(const CheckedCase& checked) {
    const Plan& plan = checked.plan;
    py::list vesicles;
    for (std::size_t index = 0; index < plan.vesicles.size(); ++index)
        vesicles.append(groups_of(checked, index));
    py::dict result;
    result["text"] = checked.text;
    result["warnings"] = texts_of(plan.remarks, Remark::Severity::warning);
    result["notes"] = texts_of(plan.remarks, Remark::Severity::note);
    result["cells"] = plan.cells;
    result["relaxation_time"] = plan.relaxation_time;
    result["interface_width"] = plan.interface_width;
    result["expected_speed"] = plan.expected_speed;
    result["mach"] = plan.mach;
    result["shear_rate"] = plan.flow.rate;
    result["vesicles"] = vesicles;
    result["seconds_per_step"] = py::none();
    result["bytes"] = py::none();
    if (checked.cost) {
        result["seconds_per_step"] = checked.cost->seconds_per_step;
        result["bytes"] = checked.cost->bytes;
    }
    return result;
}

} // namespace

void bind_plan(py::module_& module) {
    module.def(
        "check_case",
        [](const Case& what, int threads, bool with_cost, bool accept_soft_membranes) {
            return described(
                without_gil([&] { return check_case(what, threads, with_cost, accept_soft_membranes); }));
        },
        py::arg("case"), py::arg("threads"), py::arg("with_cost"), py::arg("accept_soft_membranes"),
        "What `vesica check` finds, as a dictionary.");
}

} // namespace vesica
