#include "simulation/plan.hpp"

#include "case/triangle_mesh.hpp"
#include "core/input_error.hpp"
#include "simulation/flow_drive.hpp"
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

/// The shape of a vesicle. What the reader could not know to be impossible is refused here, at its place.
std::unique_ptr<const Shape> shape_of(const Case& what, std::size_t index) {
    const VesicleParameters& vesicle = what.parameters.vesicles[index];
    try {
        return make_shape(vesicle);
    } catch (const InputError& refusal) {
        const std::string message = refusal.what();
        const std::string name = fmt::format("vesicle[{}].", index);
        const auto* mesh = std::get_if<MeshShape>(&vesicle.shape);
        if (mesh != nullptr && mesh->mesh && message.starts_with(mesh->mesh->source))
            throw InputError(what.place(name + "file"),
                             fmt::format("{}file is \"{}\"; {}", name, mesh->file, message));
        const std::string key = message.substr(0, message.find_first_of(" ."));
        throw InputError(what.place(name + key), name + message);
    }
}

/// The cells that obstacles make solid. What the reader could not know to be impossible is refused here.
std::shared_ptr<const SolidVoxels> obstacles_of(const Case& what) {
    try {
        auto solids = solid_voxels(what.parameters);
        const std::size_t count = solids != nullptr ? solids->count() : 1;
        const Vec3<int>& size = what.parameters.size;
        if (count == 0)
            throw InputError("no cell of the box is solid; expected some; try another obstacles.scale or "
                             "obstacles.position, which are in cells");
        if (solids != nullptr && count == static_cast<std::size_t>(size.x) *
                                              static_cast<std::size_t>(size.y) *
                                              static_cast<std::size_t>(size.z))
            throw InputError(
                "every cell of the box is solid; expected some fluid; try obstacles.solid = \"inside\" or "
                "\"outside\", or another obstacles.scale");
        return solids;
    } catch (const InputError& refusal) {
        throw InputError(
            what.place("obstacles.file"),
            fmt::format("obstacles.file is \"{}\"; {}", what.parameters.obstacles->file, refusal.what()));
    }
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
    plan.flow = plan_flow(parameters);
    plan.obstacles = obstacles_of(what);
    plan.expected_speed = std::max(plan.expected_speed, plan.flow.speed);
    constexpr double speed_of_sound = 0.57735026918962576; // 1/sqrt(3)
    plan.mach = plan.expected_speed / speed_of_sound;

    judge_fluid(parameters, plan, plan.remarks);
    judge_flow(parameters, plan, what.run, plan.remarks);
    const Vec3<int> lattice = parameters.lattice();
    judge_memory(parameters, static_cast<double>(lattice.x) * lattice.y * lattice.z, plan.remarks);
    for (std::size_t vesicle = 0; vesicle < parameters.vesicles.size(); ++vesicle)
        judge_vesicle(parameters, vesicle, plan.vesicles[vesicle], what.run, options, plan.remarks);
    judge_places(parameters, shapes, plan, plan.remarks);
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
