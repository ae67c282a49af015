#include "simulation/plan.hpp"

#include "core/input_error.hpp"
#include "simulation/plan_judgement.hpp"

#include <algorithm>
#include <cmath>

namespace vesica {

Plan make_plan(const Parameters& parameters, const RunParameters& run, const OutputParameters& output,
               const PlanOptions& options)
{
    Plan plan;
    const Vec3<int>& size = parameters.size;
    plan.cells = std::int64_t{size.x} * size.y * size.z;
    plan.relaxation_time = 3.0 * parameters.fluid.kinematic_viscosity + 0.5;
    plan.interface_width = 2.0 / parameters.fluid.segregation;

    std::vector<std::unique_ptr<const Shape>> shapes;
    for (std::size_t vesicle = 0; vesicle < parameters.vesicles.size(); ++vesicle) {
        shapes.push_back(make_shape(parameters.vesicles[vesicle]));
        plan.vesicles.push_back(plan_vesicle(parameters, vesicle, *shapes.back()));
        plan.expected_speed = std::max(plan.expected_speed, plan.vesicles.back().bending_speed.value_or(0.0));
    }
    constexpr double speed_of_sound = 0.57735026918962576; // 1/sqrt(3)
    plan.mach = plan.expected_speed / speed_of_sound;

    judge_fluid(parameters, plan, plan.remarks);
    for (std::size_t vesicle = 0; vesicle < parameters.vesicles.size(); ++vesicle)
        judge_vesicle(parameters, vesicle, plan.vesicles[vesicle], run, options, plan.remarks);
    judge_places(parameters, shapes, plan, plan.remarks);
    judge_schedule(parameters, run, output, plan.remarks);
    return plan;
}

void refuse_errors(const Plan& plan, const std::string& file)
{
    std::string message;
    for (const std::string& text : texts_of(plan.remarks, Remark::Severity::error)) {
        if (!message.empty()) message += '\n';
        message += file + ": " + text;
    }
    if (!message.empty()) throw InputError(message);
}

} // namespace vesica
