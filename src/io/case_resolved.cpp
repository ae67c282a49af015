#include "io/case_file.hpp"
#include "io/case_resolver.hpp"

#include <fmt/format.h>

namespace vesica {

using namespace detail;

namespace {

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
    if (vesicle.buoyancy)
        out.point("buoyancy", *vesicle.buoyancy);
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

void write_suspension(Resolver& out, const SuspensionParameters& suspension,
                      const std::vector<VesicleType>& types) {
    out.header("[suspension]", "suspension");
    out.text("type", types[suspension.vesicle.type].name);
    std::visit(WriteShape{out}, suspension.vesicle.shape);
    out.number("radius", suspension.vesicle.radius);
    if (suspension.haematocrit)
        out.number("haematocrit", *suspension.haematocrit);
    if (suspension.count)
        out.whole("count", *suspension.count);
    const bool spread = suspension.orientation == PackedOrientation::spread;
    const bool random = suspension.orientation == PackedOrientation::random;
    out.text("orientation", random ? "random" : spread ? "spread" : "aligned");
    if (!random)
        out.point("axis", suspension.axis);
    if (spread)
        out.number("spread", suspension.spread);
    if (suspension.gap)
        out.number("gap", *suspension.gap);
    out.whole("seed", static_cast<std::int64_t>(suspension.seed));
    const Vec3<int>& begin = suspension.region_begin;
    const Vec3<int>& end = suspension.region_end;
    out.raw("region",
            fmt::format("[[{}, {}, {}], [{}, {}, {}]]", begin.x, begin.y, begin.z, end.x, end.y, end.z));
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

void write_tracers(Resolver& out, const TracerOutput& tracers) {
    out.header("[tracers]", "tracers");
    out.steps("every", tracers.every);
    out.steps("start", tracers.start);
    out.steps("release", tracers.release);
    out.whole("membrane", tracers.membrane);
    for (std::size_t index = 0; index < tracers.seeds.size(); ++index) {
        out.header("[[tracers.seeds]]", fmt::format("tracers.seeds[{}]", index));
        out.point("from", tracers.seeds[index].from);
        if (tracers.seeds[index].count > 1)
            out.point("to", tracers.seeds[index].to);
        out.whole("count", tracers.seeds[index].count);
    }
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
        out.whole("fields.compression", fields.compression);
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
    if (parameters.obstacles)
        write_obstacles(out, *parameters.obstacles);
    write_flow(out, parameters.flow);
    for (const VesicleType& type : parameters.types)
        write_type(out, type);
    for (std::size_t i = 0; i < parameters.vesicles.size(); ++i)
        write_vesicle(out, parameters.vesicles[i], parameters.types, i);
    if (resolved.suspension && resolved.packed == 0) // those that are packed are vesicles like any other
        write_suspension(out, *resolved.suspension, parameters.types);

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
    if (resolved.output.profiles) {
        const ProfileOutput& profiles = *resolved.output.profiles;
        const auto axis = [](int a) {
            return std::string(a < 0 ? "radius" : a == 0 ? "x" : a == 1 ? "y" : "z");
        };
        out.header("[output.profiles]", "output.profiles");
        out.steps("every", profiles.every);
        out.text("across", axis(profiles.across_axis));
        out.text("along", axis(profiles.along));
    }
    if (resolved.output.tracers)
        write_tracers(out, *resolved.output.tracers);
    return out.finish();
}

} // namespace vesica
