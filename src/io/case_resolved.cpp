#include "io/case_file.hpp"
#include "io/case_keys.hpp"

#include <fmt/format.h>

#include <cassert>

namespace vesica {
namespace {

std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            result += '\\';
            result += c;
        } else if (code < 0x20 || code == 0x7f) {
            result += fmt::format("\\u{:04x}", code);
        } else {
            result += c;
        }
    }
    return result + '"';
}

/// The shortest text that reads back as the same double, and as a float of TOML.
std::string number_text(double value) {
    const std::string text = fmt::format("{}", value);
    return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

/// Writes keys line by line, each with its SI value and whether it is a default.
class Resolver {
public:
    explicit Resolver(const Case& resolved) : case_(resolved) {}

    void header(const std::string& text, const std::string& path) {
        if (!text_.empty())
            text_ += "\n";
        text_ += text + "\n";
        path_ = path;
        generic_ = path;
        if (path.starts_with("vesicle_type."))
            generic_ = "vesicle_type.*";
        for (auto open = generic_.find('['); open != std::string::npos; open = generic_.find('[', open + 1))
            generic_.erase(open + 1, generic_.find(']', open) - open - 1);
    }

    void text(const std::string& key, const std::string& value) { line(key, quoted(value), ""); }

    void number(const std::string& key, double value) {
        const Dimension dimension = dimension_of(key);
        line(key, number_text(value), in_si(value, dimension));
    }

    void steps(const std::string& key, std::int64_t value) {
        line(key, fmt::format("{}", value), in_si(static_cast<double>(value), dimension::time));
    }

    void whole(const std::string& key, std::int64_t value) { line(key, fmt::format("{}", value), ""); }

    void raw(const std::string& key, const std::string& value, const std::string& comment = {}) {
        line(key, value, comment);
    }

    void point(const std::string& key, const Vec3<double>& value) {
        const Dimension dimension = dimension_of(key);
        std::string comment;
        if (case_.scales && dimension != dimension::none)
            comment = fmt::format("[{}, {}, {}]", in_si(value.x, dimension), in_si(value.y, dimension),
                                  in_si(value.z, dimension));
        line(key,
             fmt::format("[{}, {}, {}]", number_text(value.x), number_text(value.y), number_text(value.z)),
             comment);
    }

    std::string finish() { return std::move(text_); }

private:
    Dimension dimension_of(const std::string& key) const {
        const CaseKey* known = find_case_key(generic_.empty() ? key : generic_ + "." + key);
        assert(known);
        return known ? known->dimension : dimension::none;
    }

    std::string in_si(double lattice, const Dimension& dimension) const {
        if (!case_.scales || dimension == dimension::none)
            return {};
        return to_text(case_.scales->to_si(lattice, dimension));
    }

    void line(const std::string& key, const std::string& value, std::string comment) {
        const std::string path = path_.empty() ? key : path_ + "." + key;
        const CaseKey* known = find_case_key(generic_.empty() ? key : generic_ + "." + key);
        if (known && !known->default_value.empty() && !case_.places.contains(path))
            comment += comment.empty() ? "default" : ", default";
        const std::string statement = fmt::format("{} = {}", key, value);
        text_ += comment.empty() ? statement + "\n" : fmt::format("{:<40} # {}\n", statement, comment);
    }

    const Case& case_;
    std::string text_;
    std::string path_;
    std::string generic_;
};

struct WriteGhosts {
    Resolver& out;

    void rates(const std::string& basis, std::initializer_list<std::pair<const char*, double>> values) const {
        out.text("collision.basis", basis);
        for (const auto& [name, rate] : values)
            out.number(std::string("collision.ghost_rates.") + name, rate);
    }

    void operator()(const BgkGhosts&) const { out.text("collision.model", "bgk"); }

    void operator()(const RegularisedGhosts&) const {
        out.text("collision.model", "mrt");
        out.text("collision.basis", "symmetric");
        out.text("collision.ghost_rates", "regularised");
    }

    void operator()(const TrtGhosts& trt) const {
        out.text("collision.model", "mrt");
        out.text("collision.basis", "symmetric");
        out.text("collision.ghost_rates", "trt");
        out.number("collision.magic", trt.magic);
    }

    void operator()(const SymmetricGhosts& ghosts) const {
        out.text("collision.model", "mrt");
        rates("symmetric", {{"even_scalar", ghosts.even_scalar},
                            {"even_tensor", ghosts.even_tensor},
                            {"odd_vector", ghosts.odd_vector},
                            {"odd_twist", ghosts.odd_twist}});
    }

    void operator()(const PaperGhosts& ghosts) const {
        out.text("collision.model", "mrt");
        rates("paper", {{"l10", ghosts.l10}, {"l11", ghosts.l11}, {"l14", ghosts.l14}, {"l17", ghosts.l17}});
    }
};

void write_units(Resolver& out, const Case& resolved) {
    if (!resolved.scales)
        return;
    out.header("[units]", "units");
    out.raw("cell", quoted(number_text(resolved.scales->cell) + " m"));
    out.raw("time_step", quoted(number_text(resolved.scales->step) + " s"));
    if (!resolved.inertia)
        return;
    const InertiaScaling& inertia = *resolved.inertia;
    out.raw("# inertia is scaled: Re",
            fmt::format("{:.6g} instead of {:.6g}, fluid.density {} instead of {}", inertia.reynolds,
                        inertia.true_reynolds, to_text({resolved.scales->density, dimension::density}),
                        to_text({inertia.true_density, dimension::density})));
}

void write_fluid(Resolver& out, const Case& resolved) {
    const FluidParameters& fluid = resolved.parameters.fluid;
    out.header("[fluid]", "fluid");
    // Where inertia is scaled, the dynamic viscosity is the fluid's own and the kinematic one is not.
    std::string viscosity;
    if (resolved.scales) {
        viscosity = fmt::format(
            "{}, {}",
            to_text(resolved.scales->to_si(fluid.kinematic_viscosity, dimension::kinematic_viscosity)),
            to_text(resolved.scales->to_si(fluid.kinematic_viscosity * fluid.density,
                                           dimension::dynamic_viscosity)));
    }
    out.raw("kinematic_viscosity", number_text(fluid.kinematic_viscosity), viscosity);
    if (resolved.scales) {
        // The unit makes the scale of mass; on the lattice the density is 1 by definition.
        out.raw("density", quoted(number_text(resolved.scales->density) + " kg/m^3"), "1.0 in lattice units");
    } else {
        out.number("density", fluid.density);
    }
    out.number("segregation", fluid.segregation);
    std::visit(WriteGhosts{out}, fluid.ghosts);
}

void write_type(Resolver& out, const VesicleType& type) {
    out.header("[vesicle_type." + type.name + "]", "vesicle_type." + type.name);
    out.number("viscosity_ratio", type.viscosity_ratio);
    out.number("bending.modulus", type.bending.modulus);
    if (const auto* helfrich = std::get_if<HelfrichBending>(&type.bending.form)) {
        out.text("bending.form", "helfrich");
        out.number("bending.spontaneous_curvature", helfrich->spontaneous_curvature);
    } else {
        out.text("bending.form", "paper");
        out.number("bending.laplacian_coefficient",
                   std::get<PaperBending>(type.bending.form).laplacian_coefficient);
    }
    if (std::holds_alternative<NoConstraint>(type.area.constraint)) {
        out.text("area.constraint", "none");
    } else {
        if (const auto* penalty = std::get_if<PenaltyConstraint>(&type.area.constraint)) {
            out.text("area.constraint", "penalty");
            out.number("area.modulus", penalty->modulus);
        } else if (const auto* paper = std::get_if<PaperConstraint>(&type.area.constraint)) {
            out.text("area.constraint", "paper");
            out.number("area.alpha", paper->alpha);
        } else {
            out.text("area.constraint", "multiplier");
        }
        if (type.area.deflation)
            out.number("area.deflation", *type.area.deflation);
        out.steps("area.ramp", type.area.ramp);
    }
    out.number("tension.sigma", type.sigma);
    out.point("buoyancy", type.buoyancy);
}

struct WriteShape {
    Resolver& out;

    void operator()(const SphereShape&) const { out.text("shape", "sphere"); }
    void operator()(const SpheroidShape& spheroid) const {
        out.text("shape", "spheroid");
        out.number("aspect", spheroid.aspect);
    }
    void operator()(const HelfrichShape& shape) const {
        out.text("shape", shape.branch == HelfrichBranch::discocyte ? "discocyte"
                          : shape.branch == HelfrichBranch::prolate ? "prolate"
                                                                    : "stomatocyte");
        out.number("reduced_volume", shape.reduced_volume);
    }
    void operator()(const EvansFungShape&) const { out.text("shape", "evans-fung"); }
    void operator()(const MeshShape& mesh) const {
        out.text("shape", "mesh");
        out.text("file", mesh.file);
    }
};

void write_vesicle(Resolver& out, const VesicleParameters& vesicle, const std::vector<VesicleType>& types,
                   std::size_t index) {
    const std::string path = fmt::format("vesicle[{}]", index);
    out.header("[[vesicle]]", path);
    out.text("type", types[vesicle.type].name);
    std::visit(WriteShape{out}, vesicle.shape);
    out.point("centre", vesicle.centre);
    if (vesicle.radius > 0.0)
        out.number("radius", vesicle.radius);
    out.point("axis", vesicle.axis);
    for (std::size_t i = 0; i < vesicle.perturbations.size(); ++i) {
        out.header("[[vesicle.perturbation]]", fmt::format("{}.perturbation[{}]", path, i));
        if (const auto* mode = std::get_if<HarmonicPerturbation>(&vesicle.perturbations[i])) {
            out.whole("l", mode->l);
            out.whole("m", mode->m);
            out.number("amplitude", mode->amplitude);
        } else {
            const auto& random = std::get<RandomPerturbation>(vesicle.perturbations[i]);
            out.raw("l", fmt::format("[{}, {}]", random.lowest, random.highest));
            out.number("amplitude", random.amplitude);
            out.whole("seed", static_cast<std::int64_t>(random.seed));
        }
    }
}

const char* axis_name(int axis) {
    return axis == 0 ? "x" : axis == 1 ? "y" : "z";
}

void write_times(Resolver& out, const FlowTimes& times) {
    out.steps("start", times.start);
    if (times.stop != FlowTimes::never)
        out.steps("stop", times.stop);
    out.steps("ramp", times.ramp);
}

void write_open(Resolver& out, const OpenEnds& open, int axis) {
    const std::string table = fmt::format("boundary.{}.", axis_name(axis));
    const std::string inlet = table + (open.enters_below ? "lower" : "upper");
    const std::string outlet = table + (open.enters_below ? "upper" : "lower");
    out.header("[" + inlet + "]", inlet);
    out.text("type", "inlet");
    Vec3<double> velocity{};
    velocity[axis] = open.enters_below ? open.velocity : -open.velocity;
    out.point("velocity", velocity);
    out.text("profile", open.parabolic ? "parabolic" : "uniform");
    out.steps("ramp", open.times.ramp);
    out.header("[" + outlet + "]", outlet);
    out.text("type", "outlet");
    out.number("pressure", open.outlet_pressure);
}

void write_boundary(Resolver& out, const Parameters& parameters) {
    out.header("[boundary]", "boundary");
    out.number("wetting", parameters.wetting);
    for (int axis = 0; axis < 3; ++axis) {
        const auto* walls = std::get_if<WallEnds>(&parameters.ends[static_cast<std::size_t>(axis)]);
        if (const auto* open = std::get_if<OpenEnds>(&parameters.ends[static_cast<std::size_t>(axis)]))
            write_open(out, *open, axis);
        const bool of_flow =
            (parameters.flow.shear && parameters.flow.shear->gradient == axis) || parameters.flow.extension;
        if (walls == nullptr || of_flow)
            continue;
        for (const auto& [side, velocity] :
             {std::pair("lower", walls->lower_velocity), std::pair("upper", walls->upper_velocity)}) {
            const std::string path = fmt::format("boundary.{}.{}", axis_name(axis), side);
            out.header("[" + path + "]", path);
            out.text("type", "wall");
            out.point("velocity", velocity);
        }
    }
}

void write_flow(Resolver& out, const FlowParameters& flow) {
    if (flow.shear) {
        out.header("[flow.shear]", "flow.shear");
        out.number("rate", flow.shear->rate);
        out.text("velocity", axis_name(flow.shear->velocity));
        out.text("gradient", axis_name(flow.shear->gradient));
        out.text("with", "walls");
        write_times(out, flow.shear->times);
    }
    if (flow.poiseuille) {
        out.header("[flow.poiseuille]", "flow.poiseuille");
        if (flow.poiseuille->mean_velocity)
            out.number("mean_velocity", *flow.poiseuille->mean_velocity);
        else
            out.number("pressure_gradient", flow.poiseuille->pressure_gradient);
        out.text("velocity", axis_name(flow.poiseuille->velocity));
        write_times(out, flow.poiseuille->times);
    }
    if (flow.extension) {
        out.header("[flow.extension]", "flow.extension");
        out.number("rate", flow.extension->rate);
        out.text("stretch", axis_name(flow.extension->stretch));
        out.text("squeeze", axis_name(flow.extension->squeeze));
        write_times(out, flow.extension->times);
    }
    if (flow.body_force) {
        out.header("[flow.body_force]", "flow.body_force");
        out.point("force", flow.body_force->force);
        write_times(out, flow.body_force->times);
    }
}

void write_run(Resolver& out, const Case& resolved) {
    out.header("[run]", "run");
    out.steps("steps", resolved.run.steps);
    if (resolved.run.wall_time)
        out.raw("wall_time", quoted(number_text(*resolved.run.wall_time) + " s"));
    if (!resolved.run.stop_when_steady)
        return;
    const SteadyCriterion& steady = *resolved.run.stop_when_steady;
    out.text("stop_when_steady.quantity", steady.quantity);
    out.number("stop_when_steady.relative_change", steady.relative_change);
    out.steps("stop_when_steady.over", steady.over);
}

void write_output(Resolver& out, const OutputParameters& output) {
    out.header("[output]", "output");
    out.steps("metrics.every", output.metrics_every);
    if (output.fields) {
        const FieldOutput& fields = *output.fields;
        std::string names;
        for (const std::string& name : fields.names)
            names += (names.empty() ? "" : ", ") + quoted(name);
        out.steps("fields.every", fields.every);
        out.raw("fields.names", "[" + names + "]");
        out.raw("fields.region", fmt::format("[[{}, {}, {}], [{}, {}, {}]]", fields.region_begin.x,
                                             fields.region_begin.y, fields.region_begin.z,
                                             fields.region_end.x, fields.region_end.y, fields.region_end.z));
        out.whole("fields.stride", fields.stride);
        out.raw("fields.average", fields.average ? "true" : "false");
    }
    if (output.surfaces_every > 0)
        out.steps("surfaces.every", output.surfaces_every);
    if (output.checkpoint_every > 0) {
        out.steps("checkpoint.every", output.checkpoint_every);
        out.whole("checkpoint.keep", output.checkpoint_keep);
    }
}

} // namespace

std::string resolved_toml(const Case& resolved) {
    const Parameters& parameters = resolved.parameters;
    Resolver out(resolved);
    out.text("title", resolved.title);
    write_units(out, resolved);
    out.header("[lattice]", "lattice");
    out.raw("size", fmt::format("[{}, {}, {}]", parameters.size.x, parameters.size.y, parameters.size.z));
    write_fluid(out, resolved);
    write_boundary(out, parameters);
    write_flow(out, parameters.flow);
    for (const VesicleType& type : parameters.types)
        write_type(out, type);
    for (std::size_t i = 0; i < parameters.vesicles.size(); ++i)
        write_vesicle(out, parameters.vesicles[i], parameters.types, i);

    if (resolved.initial) {
        out.header("[initial]", "initial");
        out.text("checkpoint", resolved.initial->path);
        if (resolved.initial->step)
            out.whole("step", *resolved.initial->step);
    }
    out.header("[numerics]", "numerics");
    out.text("geometry", parameters.numerics.geometry == GeometryRecipe::paper ? "paper" : "mapped");
    out.number("cutoff", parameters.numerics.cutoff);
    out.text("precision", name_of(parameters.numerics.precision));
    out.text("device", "cpu");
    write_run(out, resolved);
    write_output(out, resolved.output);
    return out.finish();
}

} // namespace vesica
