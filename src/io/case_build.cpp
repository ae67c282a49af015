#include "io/case_build.hpp"

#include "case/resolution.hpp"
#include "io/case_build_flow.hpp"
#include "io/case_build_region.hpp"
#include "io/case_build_suspension.hpp"
#include "io/case_build_vesicle.hpp"
#include "io/case_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vesica {
namespace {

Vec3<int> read_size(const CaseValues& values) {
    const std::string path = "lattice.size";
    const Vec3<int> size{static_cast<int>(values.integer(path, 0)), static_cast<int>(values.integer(path, 1)),
                         static_cast<int>(values.integer(path, 2))};
    const double cells = static_cast<double>(size.x) * size.y * size.z;
    constexpr double most = std::numeric_limits<std::int32_t>::max();
    if (cells > most)
        values.refuse(
            path, fmt::format("expected at most {:.0f} cells, not {:.4g}; try a smaller box", most, cells));
    return size;
}

/// The rates of a complete set, or nothing when none of its keys is given. One of them alone is an error.
std::vector<double> complete_set(const CaseValues& values, const std::vector<std::string>& names) {
    const std::string table = "fluid.collision.ghost_rates.";
    std::vector<double> rates;
    for (const std::string& name : names) {
        if (values.find(table + name))
            rates.push_back(values.number(table + name));
    }
    if (rates.empty() || rates.size() == names.size())
        return rates;
    for (const std::string& name : names) {
        if (!values.find(table + name))
            values.refuse(table + name, fmt::format("expected {} together; try {} = 1.0",
                                                    joined_choices(names, "and", false), name));
    }
    return {};
}

GhostRates read_ghost_table(const CaseValues& values, bool paper_basis) {
    const std::string path = "fluid.collision.ghost_rates";
    const std::vector<std::string> families{"even", "odd"};
    const std::vector<std::string> symmetric{"even_scalar", "even_tensor", "odd_vector", "odd_twist"};
    const std::vector<std::string> paper{"l10", "l11", "l14", "l17"};
    const auto refuse_other = [&](const std::vector<std::string>& names) {
        for (const std::string& name : names) {
            if (values.find(path + "." + name))
                values.refuse(path + "." + name,
                              fmt::format("expected {}; try one complete set of rates of one basis",
                                          paper_basis
                                              ? "l10, l11, l14 and l17 in the paper's basis"
                                              : "even and odd, or even_scalar, even_tensor, odd_vector and "
                                                "odd_twist, in the symmetric basis"));
        }
    };
    if (paper_basis) {
        refuse_other(families);
        refuse_other(symmetric);
        const auto rates = complete_set(values, paper);
        if (!rates.empty())
            return PaperGhosts{rates[0], rates[1], rates[2], rates[3]};
    } else {
        refuse_other(paper);
        const auto two = complete_set(values, families);
        if (!two.empty()) {
            refuse_other(symmetric);
            return SymmetricGhosts{two[0], two[0], two[1], two[1]};
        }
        const auto four = complete_set(values, symmetric);
        if (!four.empty())
            return SymmetricGhosts{four[0], four[1], four[2], four[3]};
    }
    values.refuse(path, fmt::format("expected a complete set of rates; try ghost_rates = {}",
                                    paper_basis ? "{ l10 = 1.0, l11 = 1.0, l14 = 1.0, l17 = 1.0 }"
                                                : "{ even = 1.0, odd = 1.0 }"));
}

GhostRates read_ghosts(const CaseValues& values) {
    if (values.text("fluid.collision.model") == "bgk")
        return BgkGhosts{};
    const std::string path = "fluid.collision.ghost_rates";
    const bool paper_basis = values.text("fluid.collision.basis") == "paper";
    if (values.find(path)->is_table)
        return read_ghost_table(values, paper_basis);
    // The same operator in either basis: even and odd moments do not mix in either.
    if (values.text(path) == "trt")
        return TrtGhosts{values.number("fluid.collision.magic")};
    if (paper_basis) {
        const std::string advice =
            "expected \"trt\" or a table of l10, l11, l14 and l17 in the paper's basis, where "
            "rates of one are not symmetric; try ghost_rates = \"trt\"";
        if (values.given(path))
            values.refuse(path, advice);
        throw InputError(values.place(path), path + " is missing; " + advice);
    }
    return RegularisedGhosts{};
}

FluidParameters read_fluid(const CaseValues& values, const CaseUnits& units) {
    FluidParameters fluid;
    fluid.kinematic_viscosity = units.kinematic_viscosity;
    fluid.density = units.density;
    fluid.segregation = values.number("fluid.segregation");
    fluid.ghosts = read_ghosts(values);
    return fluid;
}

NumericsParameters read_numerics(const CaseValues& values) {
    NumericsParameters numerics;
    numerics.geometry =
        values.text("numerics.geometry") == "paper" ? GeometryRecipe::paper : GeometryRecipe::mapped;
    numerics.cutoff = values.number("numerics.cutoff");
    numerics.precision = values.text("numerics.precision") == "single" ? Precision::single_precision
                                                                       : Precision::double_precision;
    return numerics;
}

RunParameters read_run(const CaseValues& values) {
    RunParameters run;
    run.steps = values.integer(values.find("run.steps") ? "run.steps" : "run.time");
    if (values.has_table("run.stop_when_steady")) {
        const std::string table = "run.stop_when_steady.";
        run.stop_when_steady =
            SteadyCriterion{values.text(table + "quantity"), values.number(table + "relative_change"),
                            values.integer(table + "over")};
    }
    if (const CaseValue* wall_time = values.find("run.wall_time"))
        run.wall_time = std::get<Quantity>(wall_time->items.front().value).value;
    return run;
}

FieldOutput read_fields(const CaseValues& values, const Vec3<int>& size) {
    FieldOutput fields;
    fields.every = values.integer("output.fields.every");
    for (const CaseScalar& name : values.find("output.fields.names")->items)
        fields.names.push_back(std::get<std::string>(name.value));
    fields.stride = static_cast<int>(values.integer("output.fields.stride"));
    fields.average = values.boolean("output.fields.average");
    fields.compression = static_cast<int>(values.integer("output.fields.compression"));
    const CaseRegion region = build_region(values, "output.fields.region", size);
    fields.region_begin = region.begin;
    fields.region_end = region.end;
    return fields;
}

ProfileOutput read_profiles(const CaseValues& values) {
    const auto axis = [&](const std::string& name) {
        return name == "x" ? 0 : name == "y" ? 1 : name == "z" ? 2 : -1;
    };
    ProfileOutput profiles;
    profiles.every = values.integer("output.profiles.every");
    profiles.across_axis = axis(values.text("output.profiles.across"));
    profiles.along = axis(values.text("output.profiles.along"));
    if (profiles.across_axis == profiles.along)
        values.refuse("output.profiles.across",
                      "expected another axis than output.profiles.along; try across = \"" +
                          std::string(profiles.along == 2 ? "x" : "z") + "\"");
    return profiles;
}

TracerOutput read_tracers(const CaseValues& values, const Vec3<int>& size) {
    TracerOutput tracers;
    tracers.every = values.integer("tracers.every");
    tracers.start = values.integer("tracers.start");
    tracers.release = values.integer("tracers.release");
    tracers.membrane = static_cast<int>(values.integer("tracers.membrane"));
    const auto point = [&](const std::string& path) {
        const Vec3<double> place{values.number(path, 0), values.number(path, 1), values.number(path, 2)};
        for (int a = 0; a < 3; ++a)
            if (place[a] < 0.0 || place[a] > size[a])
                values.refuse(path, fmt::format("expected a point in the box, from 0 to {} along {}; try the "
                                                "middle, {:g}",
                                                size[a], "xyz"[a], 0.5 * size[a]));
        return place;
    };
    if (const auto found = values.tables.find("tracers.seeds[]"); found != values.tables.end())
        for (const std::string& path : found->second) {
            TracerSeeds seeds;
            seeds.from = seeds.to = point(path + ".from");
            if (values.find(path + ".to"))
                seeds.to = point(path + ".to");
            seeds.count = static_cast<int>(values.integer(path + ".count"));
            if (seeds.count == 1 && seeds.from != seeds.to)
                values.refuse(path + ".to",
                              fmt::format("expected no second point, as {}.count is 1; try count = 2", path));
            if (seeds.count > 1 && seeds.from == seeds.to)
                values.refuse(path + ".count",
                              fmt::format("expected 1, as the first point is the last; try {}.to", path));
            tracers.seeds.push_back(seeds);
        }
    if (tracers.seeds.empty() && tracers.membrane == 0)
        values.refuse("tracers.every",
                      "expected points as well; try [[tracers.seeds]] with from, to and count, "
                      "or tracers.membrane = 8");
    return tracers;
}

OutputParameters read_output(const CaseValues& values, const Vec3<int>& size) {
    OutputParameters output;
    output.metrics_every = values.integer("output.metrics.every");
    if (values.has_table("output.fields")) {
        output.fields = read_fields(values, size);
        if (output.fields->every == 0)
            output.fields.reset();
    }
    if (values.has_table("output.surfaces"))
        output.surfaces_every = values.integer("output.surfaces.every");
    if (values.has_table("output.profiles") && values.integer("output.profiles.every") > 0)
        output.profiles = read_profiles(values);
    if (values.has_table("tracers"))
        output.tracers = read_tracers(values, size);
    if (values.has_table("output.checkpoint")) {
        output.checkpoint_every = values.integer("output.checkpoint.every");
        output.checkpoint_keep = static_cast<int>(values.integer("output.checkpoint.keep"));
    }
    return output;
}

void check_radius(const CaseValues& values, const Parameters& parameters, const VesicleParameters& vesicle,
                  const std::string& path) {
    const double beta = parameters.fluid.segregation;
    if (vesicle.radius > 0.0 && judge_resolution(beta, vesicle.radius) == Resolution::error)
        values.refuse(
            path + ".radius",
            fmt::format("expected at least {:.3g} cells, as even a sphere is not resolved otherwise (radius "
                        "times fluid.segregation below {:g}); try radius = 15",
                        resolution_error / beta, resolution_error));
}

void check_fit(const CaseValues& values, const Parameters& parameters, const VesicleParameters& vesicle,
               const std::string& path) {
    check_radius(values, parameters, vesicle, path);
    const Vec3<double> half = least_half_widths(vesicle);
    for (int a = 0; a < 3; ++a) {
        const int side = parameters.size[a];
        if (vesicle.centre[a] < 0.0 || vesicle.centre[a] > side)
            values.refuse(path + ".centre",
                          fmt::format("expected a point in the box, from 0 to {} along {}; try the "
                                      "middle, {:g}",
                                      side, "xyz"[a], 0.5 * side));
        if (2.0 * half[a] > side)
            values.refuse(path + ".radius",
                          fmt::format("expected a vesicle smaller than the box, not {:.4g} cells "
                                      "wide along {}, where lattice.size is {}; try a smaller "
                                      "radius or a larger box",
                                      2.0 * half[a], "xyz"[a], side));
    }
}

} // namespace

void check_references(const CaseValues& values) {
    const auto instances = [&](const std::string& generic) {
        const auto found = values.tables.find(generic);
        return found == values.tables.end() ? std::vector<std::string>{} : found->second;
    };
    const auto types = instances("vesicle_type.*");
    auto vesicles = instances("vesicle[]");
    const auto suspensions = instances("suspension");
    if (vesicles.empty() && suspensions.empty())
        values.refuse(
            "vesicle",
            "expected one [[vesicle]] or a [suspension]; try [[vesicle]] with type, shape, centre and "
            "radius");
    vesicles.insert(vesicles.end(), suspensions.begin(), suspensions.end());
    for (const std::string& vesicle : vesicles) {
        const std::string& type = values.text(vesicle + ".type");
        if (std::find(types.begin(), types.end(), "vesicle_type." + type) != types.end())
            continue;
        std::vector<std::string> names;
        for (const std::string& path : types)
            names.push_back(path.substr(path.find('.') + 1));
        if (names.empty())
            values.refuse(vesicle + ".type",
                          "expected the name of a vesicle type, but there is none; try adding "
                          "[vesicle_type." +
                              (type.empty() ? "rbc" : type) + "]");
        values.refuse(vesicle + ".type",
                      fmt::format("expected {}; try type = \"{}\"", joined_choices(names, "or", true),
                                  nearest_word(type, names)));
    }
    if (values.text("numerics.device") == "cuda")
        values.refuse("numerics.device",
                      "that is not available yet; expected \"cpu\" or \"auto\"; try device = \"cpu\"");
}

void build_case(CaseValues& values, const CaseUnits& units, const std::filesystem::path& folder,
                Case& result) {
    result.title = values.text("title");
    result.scales = units.scales;
    result.inertia = units.inertia;
    Parameters& parameters = result.parameters;
    parameters.size = read_size(values);
    parameters.fluid = read_fluid(values, units);
    parameters.numerics = read_numerics(values);
    parameters.obstacles = build_obstacles(values, parameters.size, folder);
    build_flow(values, parameters);
    for (const std::string& path : values.tables.at("vesicle_type.*"))
        parameters.types.push_back(build_vesicle_type(values, path));
    if (const auto found = values.tables.find("vesicle[]"); found != values.tables.end())
        for (const std::string& path : found->second) {
            parameters.vesicles.push_back(build_vesicle(values, path, parameters.types, folder));
            check_fit(values, parameters, parameters.vesicles.back(), path);
        }
    result.suspension = build_suspension(values, parameters, folder);
    if (result.suspension)
        check_radius(values, parameters, result.suspension->vesicle, "suspension");
    if (values.has_table("initial")) {
        result.initial = InitialCheckpoint{values.text("initial.checkpoint"), std::nullopt};
        if (values.find("initial.step"))
            result.initial->step = values.integer("initial.step");
    }
    result.run = read_run(values);
    result.output = read_output(values, parameters.size);
}

} // namespace vesica
