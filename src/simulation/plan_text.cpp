#include "simulation/plan_text.hpp"

#include "simulation/progress.hpp"
#include "simulation/suspension.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace vesica {

namespace {

/// Rows of a name, a lattice value and an SI value; the columns are as wide as they need to be.
class SideBySide {
public:
    explicit SideBySide(const std::optional<Scales>& scales) : scales_(scales) {}

    void heading(const std::string& text) { rows_.push_back({text, {}, {}, true}); }
    void text(const std::string& name, const std::string& value, const std::string& si = {}) {
        rows_.push_back({name, value, si, false});
    }
    void value(const std::string& name, double lattice, const Dimension& dimension) {
        std::string si;
        if (scales_ && !(dimension == dimension::none))
            si = to_text(scales_->to_si(lattice, dimension));
        text(name, fmt::format("{:.6g}", lattice), si);
    }
    void value(const std::string& name, const std::optional<double>& lattice, const Dimension& dimension,
               const char* without) {
        if (lattice)
            value(name, *lattice, dimension);
        else
            text(name, fmt::format("n/a ({})", without));
    }

    std::string str() const {
        std::size_t names = 0;
        std::size_t values = 0;
        for (const Row& row : rows_) {
            if (row.heading)
                continue;
            names = std::max(names, row.name.size());
            values = std::max(values, row.value.size());
        }
        std::string text;
        for (const Row& row : rows_) {
            if (row.heading)
                text += fmt::format("\n{}\n", row.name);
            else if (row.si.empty())
                text += fmt::format("  {:<{}}  {}\n", row.name, names, row.value);
            else
                text += fmt::format("  {:<{}}  {:<{}}  {}\n", row.name, names, row.value, values, row.si);
        }
        return text;
    }

private:
    struct Row {
        std::string name;
        std::string value;
        std::string si;
        bool heading = false;
    };
    std::optional<Scales> scales_;
    std::vector<Row> rows_;
};

std::string name_of(const GhostRates& ghosts) {
    struct Name {
        std::string operator()(const RegularisedGhosts&) const { return "mrt, symmetric basis, regularised"; }
        std::string operator()(const TrtGhosts& g) const {
            return fmt::format("mrt, symmetric basis, two rates with magic {:g}", g.magic);
        }
        std::string operator()(const SymmetricGhosts& g) const {
            return fmt::format("mrt, symmetric basis, even {:g} {:g}, odd {:g} {:g}", g.even_scalar,
                               g.even_tensor, g.odd_vector, g.odd_twist);
        }
        std::string operator()(const PaperGhosts& g) const {
            return fmt::format("mrt, the paper's basis, {:g} {:g} {:g} {:g}", g.l10, g.l11, g.l14, g.l17);
        }
        std::string operator()(const BgkGhosts&) const { return "bgk"; }
    };
    return std::visit(Name{}, ghosts);
}

std::string bytes_text(double bytes) {
    if (bytes < 1e6)
        return fmt::format("{:.0f} kB", std::ceil(bytes / 1e3));
    if (bytes < 1e9)
        return fmt::format("{:.0f} MB", bytes / 1e6);
    return fmt::format("{:.1f} GB", bytes / 1e9);
}

void describe_fluid(const Case& what, const Plan& plan, SideBySide& table) {
    const Parameters& parameters = what.parameters;
    const FluidParameters& fluid = parameters.fluid;
    const Vec3<int>& size = parameters.size;
    table.heading("Lattice and fluid");
    std::string box;
    if (what.scales)
        box = fmt::format("{} x {} x {}", to_text(what.scales->to_si(size.x, dimension::length)),
                          to_text(what.scales->to_si(size.y, dimension::length)),
                          to_text(what.scales->to_si(size.z, dimension::length)));
    table.text("box", fmt::format("{} x {} x {} = {} cells", size.x, size.y, size.z, plan.cells), box);
    table.value("cell", 1.0, dimension::length);
    table.value("step", 1.0, dimension::time);
    table.value("steps", static_cast<double>(what.run.steps), dimension::time);
    table.value("kinematic viscosity", fluid.kinematic_viscosity, dimension::kinematic_viscosity);
    table.value("density", fluid.density, dimension::density);
    table.value("relaxation time", plan.relaxation_time, dimension::none);
    table.text("collision", name_of(fluid.ghosts));
    table.text("precision", name_of(parameters.numerics.precision));
    table.value("interface width 2/beta", plan.interface_width, dimension::length);
    table.value("fastest speed expected", plan.expected_speed, dimension::velocity);
    table.value("Mach number", plan.mach, dimension::none);
    if (plan.flow.rate)
        table.value(parameters.flow.shear       ? "shear rate gamma"
                    : parameters.flow.extension ? "rate of extension"
                                                : "shear rate gamma, at the channel's walls",
                    *plan.flow.rate, dimension::rate);
    if (parameters.flow.poiseuille)
        table.value("pressure gradient", parameters.flow.poiseuille->pressure_gradient,
                    dimension::force_density);
    if (what.inertia) {
        table.value("Reynolds number on the lattice", what.inertia->reynolds, dimension::none);
        table.value("Reynolds number in reality", what.inertia->true_reynolds, dimension::none);
    }
}

void describe_vesicle(const Case& what, const Plan& plan, std::size_t index, SideBySide& table) {
    const VesiclePlan& vesicle = plan.vesicles[index];
    const VesicleType& type = what.parameters.types[what.parameters.vesicles[index].type];
    const char* const stiff = "no bending";
    const char* const tense = "no tension";
    table.heading(fmt::format("vesicle[{}], {}", index, type.name));
    table.value("radius R0 of the sphere of equal volume", vesicle.radius, dimension::length);
    table.value("volume", vesicle.volume, dimension::volume);
    table.value("area", vesicle.area, dimension::area);
    table.value("target area", vesicle.target_area, dimension::area);
    table.value("reduced volume", vesicle.reduced_volume, dimension::none);
    table.value("target reduced volume", vesicle.target_reduced_volume, dimension::none);
    table.value("bending modulus kappa", type.bending.modulus, dimension::energy);
    table.value("tension sigma", type.sigma, dimension::tension);
    table.value("viscosity ratio", vesicle.viscosity_ratio, dimension::none);
    table.value("relaxation time inside", vesicle.inner_relaxation_time, dimension::none);
    table.value("confinement 2 R0/box", vesicle.confinement, dimension::none);
    table.value("smallest radius of curvature", vesicle.smallest_radius, dimension::length);
    if (vesicle.target_smallest_radius)
        table.value("... of the discocyte it is deflated to", *vesicle.target_smallest_radius,
                    dimension::length);
    table.value("beta times the smaller (resolution)", vesicle.resolution, dimension::none);
    table.value("cells per interface over R0", plan.interface_width / vesicle.radius, dimension::none);
    table.value("bending time eta R0^3/kappa", vesicle.bending_time, dimension::time, stiff);
    if (vesicle.bending_time)
        table.value("bending times in the run", static_cast<double>(what.run.steps) / *vesicle.bending_time,
                    dimension::none);
    if (vesicle.bending_time && type.area.deflation)
        table.value("bending times in the ramp", static_cast<double>(type.area.ramp) / *vesicle.bending_time,
                    dimension::none);
    table.value("bending speed kappa/(eta R0^2)", vesicle.bending_speed, dimension::velocity, stiff);
    table.value("Re, with the bending speed", vesicle.reynolds, dimension::none, stiff);
    table.value("Ca_sigma, with the bending speed", vesicle.bending_over_tension, dimension::none,
                vesicle.bending_time ? tense : stiff);
    if (plan.flow.rate) {
        const FlowGroups groups = flow_groups(what.parameters, *plan.flow.rate, vesicle.radius, type);
        table.value("Re = rho gamma R0^2/eta", groups.reynolds, dimension::none);
        table.value("Ca_kappa = eta gamma R0^3/kappa", groups.capillary_bending, dimension::none, stiff);
        table.value("Ca_sigma = eta gamma R0/sigma", groups.capillary_tension, dimension::none, tense);
    } else {
        table.text("Ca_kappa = eta gamma R0^3/kappa", "n/a (no flow)");
    }
    if (vesicle.buoyant_speed > 0.0)
        table.value("buoyant speed (2/9) b R0^2/eta", vesicle.buoyant_speed, dimension::velocity);
    table.value("capillary time eta R0/sigma", vesicle.capillary_time, dimension::time, tense);
}

void describe_cost(const Case& what, const Plan& plan, const RunCost& cost, int threads, SideBySide& table) {
    const double stepping = cost.seconds_per_step * static_cast<double>(what.run.steps);
    const double seconds = stepping + cost.output.seconds;
    table.heading(cost.of_this_case ? "Cost, measured now on this case"
                                    : "Cost, measured now on a small box");
    table.text("memory", bytes_text(cost.bytes));
    table.text("fields, surfaces and checkpoints on disk, at most", bytes_text(cost.output.bytes));
    table.text("speed", fmt::format("{:.2f} MLUPS on {} thread{}",
                                    1e-6 * static_cast<double>(plan.cells) / cost.seconds_per_step, threads,
                                    threads == 1 ? "" : "s"));
    table.text("run time", duration_text(seconds));
    table.text("... of it for output, about",
               fmt::format("{}, {:.1f} %", duration_text(cost.output.seconds),
                           seconds > 0.0 ? 100.0 * cost.output.seconds / seconds : 0.0));
}

void describe_suspension(const Case& what, const Plan& plan, SideBySide& table) {
    const SuspensionParameters& suspension = *what.suspension;
    const auto fluid = static_cast<double>(
        fluid_cells(suspension.region_begin, suspension.region_end, plan.obstacles.get()));
    double volume = 0.0;
    for (std::size_t k = plan.vesicles.size() - what.packed; k < plan.vesicles.size(); ++k)
        volume += plan.vesicles[k].volume;
    table.heading("suspension");
    table.text("packed", fmt::format("{} vesicles", what.packed));
    table.text("haematocrit", fmt::format("{:.4f}", volume / fluid));
}

void append(std::string& text, const char* heading, const std::vector<std::string>& lines) {
    if (lines.empty())
        return;
    text += fmt::format("\n{}\n", heading);
    for (const std::string& line : lines)
        text += "  " + line + "\n";
}

} // namespace

std::string plan_text(const Case& what, const Plan& plan, const std::optional<RunCost>& cost, int threads) {
    SideBySide table(what.scales);
    describe_fluid(what, plan, table);
    // A screenful of the first is worth more than a thousand; those that were packed are alike.
    constexpr std::size_t most = 4;
    const std::size_t described = std::min(plan.different, most);
    for (std::size_t index = 0; index < described; ++index)
        describe_vesicle(what, plan, index, table);
    if (described < plan.vesicles.size())
        table.heading(fmt::format("and {} vesicles more", plan.vesicles.size() - described));
    if (what.packed > 0)
        describe_suspension(what, plan, table);
    if (cost)
        describe_cost(what, plan, *cost, threads, table);

    std::string text = what.title.empty() ? what.source_file : what.title;
    text +=
        what.scales ? "\nlattice units, and SI beside them\n" : "\nlattice units (no [units] in the case)\n";
    text += table.str();
    const auto warnings = texts_of(plan.remarks, Remark::Severity::warning);
    append(text, "Notes", texts_of(plan.remarks, Remark::Severity::note));
    append(text, "Warnings", warnings);
    append(text, "Errors", texts_of(plan.remarks, Remark::Severity::error));
    const auto errors = texts_of(plan.remarks, Remark::Severity::error).size();
    const auto count = [](std::size_t n, const char* what_it_is) {
        return fmt::format("{} {}{}", n, what_it_is, n == 1 ? "" : "s");
    };
    if (errors > 0)
        text += fmt::format("\nrefused: {}, {}\n", count(errors, "error"), count(warnings.size(), "warning"));
    else
        text += fmt::format("\naccepted, {}\n",
                            warnings.empty() ? "no warnings" : count(warnings.size(), "warning"));
    return text;
}

std::string model_text() {
    return "In the model\n"
           "  two viscous fluids of equal density, but for the inner one's buoyancy, separated by a diffuse "
           "interface (colour-gradient "
           "lattice\n"
           "  Boltzmann, D3Q19); a membrane with bending elasticity, spontaneous curvature, tension and a\n"
           "  constraint on its total area\n"
           "\n"
           "Not in the model, so nothing of it will be seen\n"
           "  thermal noise                the membrane does not flicker\n"
           "  area-difference elasticity   the two leaflets are one\n"
           "  adhesion                     membranes do not attract each other (walls: boundary.wetting)\n"
           "  osmosis                      the volume stays what it is, whatever the pressure\n"
           "  shear elasticity             a red cell's cytoskeleton is missing: its membrane flows in its "
           "plane\n"
           "  local inextensibility        the whole area is kept, not that of every patch\n";
}

} // namespace vesica
