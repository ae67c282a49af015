#include "simulation/plan.hpp"

#include "core/input_error.hpp"
#include "simulation/case_bodies.hpp"
#include "simulation/plan_cost.hpp"
#include "simulation/plan_judgement.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace vesica {

namespace {

/// The least that a case can take: nineteen populations and a colour per cell. An operating system that
/// promises more memory than it has would end the run later, without a word.
void judge_memory(const Parameters& parameters, double cells, Remarks& remarks) {
    const double number = parameters.numerics.precision == Precision::double_precision ? 8.0 : 4.0;
    const double least = 20.0 * number * cells;
    const double available = available_memory();
    if (available <= 0.0 || least <= available)
        return;
    const Vec3<int>& size = parameters.size;
    remarks.push_back(
        {Remark::Severity::error, "lattice.size",
         fmt::format("lattice.size is [{}, {}, {}], which takes at least {:.1f} GB of memory; expected at "
                     "most the {:.1f} GB at hand; try a smaller box, or precision = \"single\"",
                     size.x, size.y, size.z, 1e-9 * least, 1e-9 * available)});
}

/// What is said of the first that was packed goes for all of them.
void speak_of_suspension(std::size_t vesicle, Remarks& remarks) {
    const std::string name = fmt::format("vesicle[{}]", vesicle);
    for (Remark& remark : remarks)
        for (std::string* const text : {&remark.key, &remark.text})
            for (auto at = text->find(name); at != std::string::npos; at = text->find(name))
                text->replace(at, name.size(), "suspension");
}

} // namespace

Plan make_plan(const Case& what, const PlanOptions& options) {
    const Parameters& parameters = what.parameters;
    Plan plan;
    const Vec3<int>& size = parameters.size;
    plan.cells = std::int64_t{size.x} * size.y * size.z;
    plan.relaxation_time = 3.0 * parameters.fluid.kinematic_viscosity + 0.5;
    plan.interface_width = 2.0 / parameters.fluid.segregation;

    std::vector<std::unique_ptr<const Shape>> shapes;
    for (std::size_t vesicle = 0; vesicle < parameters.vesicles.size(); ++vesicle) {
        shapes.push_back(shape_of(what, vesicle));
        plan.vesicles.push_back(plan_vesicle(parameters, vesicle, *shapes.back()));
        const VesiclePlan& own = plan.vesicles.back();
        plan.expected_speed =
            std::max({plan.expected_speed, own.bending_speed.value_or(0.0), own.buoyant_speed});
    }
    plan.different = parameters.vesicles.size() - (what.packed > 0 ? what.packed - 1 : 0);
    plan.flow = plan_flow(parameters);
    plan.obstacles = obstacles_of(what);
    plan.expected_speed = std::max(plan.expected_speed, plan.flow.speed);
    constexpr double speed_of_sound = 0.57735026918962576; // 1/sqrt(3)
    plan.mach = plan.expected_speed / speed_of_sound;

    judge_fluid(parameters, plan, plan.remarks);
    judge_flow(parameters, plan, what.run, plan.remarks);
    const Vec3<int> lattice = parameters.lattice();
    judge_memory(parameters, static_cast<double>(lattice.x) * lattice.y * lattice.z, plan.remarks);
    for (std::size_t vesicle = 0; vesicle < plan.different; ++vesicle)
        judge_vesicle(parameters, vesicle, plan.vesicles[vesicle], what.run, options, plan.remarks);
    judge_places(what, shapes, plan, plan.remarks);
    if (what.packed > 0)
        speak_of_suspension(plan.different - 1, plan.remarks);
    judge_schedule(parameters, what.run, what.output, plan.remarks);

    for (Remark& remark : plan.remarks)
        remark.text = InputError(what.place(remark.key), remark.text).what();
    for (const std::string& warning : what.warnings)
        plan.remarks.push_back({Remark::Severity::warning, {}, warning});
    return plan;
}

void refuse_errors(const Plan& plan) {
    std::string message;
    for (const std::string& text : texts_of(plan.remarks, Remark::Severity::error)) {
        if (!message.empty())
            message += '\n';
        message += text;
    }
    if (!message.empty())
        throw InputError(message);
}

} // namespace vesica
