#include "io/case_units.hpp"

#include "io/case_value_reader.hpp"

#include <fmt/format.h>

#include <cassert>
#include <cmath>

namespace vesica {
namespace {

constexpr double lattice_viscosity_of(double relaxation_time) {
    return (relaxation_time - 0.5) / 3.0;
}

/// The value in SI, or nothing if it is absent or a plain number.
std::optional<double> si_value(const CaseValues& values, const std::string& path) {
    const CaseValue* value = values.find(path);
    if (!value)
        return std::nullopt;
    const auto* quantity = std::get_if<Quantity>(&value->items.front().value);
    return quantity ? std::optional(quantity->value) : std::nullopt;
}

const std::string kinematic = "fluid.kinematic_viscosity";
const std::string dynamic = "fluid.dynamic_viscosity";
const std::string relaxation = "fluid.relaxation_time";
const std::string density_path = "fluid.density";

/// The viscosity as a lattice number where it was given as one.
std::optional<double> lattice_viscosity(const CaseValues& values) {
    if (values.find(relaxation))
        return lattice_viscosity_of(values.number(relaxation));
    if (values.find(kinematic) && !si_value(values, kinematic))
        return values.number(kinematic);
    return std::nullopt;
}

/// Only lattice numbers.
CaseUnits without_units(const CaseValues& values) {
    for (const auto& [path, value] : values.values) {
        if (value.key->si && path != "run.wall_time")
            values.refuse(path,
                          "expected [units], without which no value has a unit; try kinematic_viscosity in "
                          "lattice units, or adding [units] with cell and time_step");
        for (const CaseScalar& item : value.items) {
            if (std::holds_alternative<Quantity>(item.value) && !value.key->si) {
                throw InputError(
                    item.place, fmt::format("{} is {}; expected a number in lattice units, since there is no "
                                            "[units]; try adding [units] with cell and time_step",
                                            path, value.is_array ? value.shown : item.shown));
            }
        }
    }
    return {std::nullopt, std::nullopt, *lattice_viscosity(values), values.number(density_path)};
}

/// fluid.density in kg/m^3, which must be there.
double true_density(const CaseValues& values, const std::string& why) {
    if (const auto density = si_value(values, density_path)) {
        if (*density > 0.0)
            return *density;
        values.refuse(density_path, "expected a density above 0; try density = \"1000 kg/m^3\"");
    }
    const std::string advice =
        fmt::format("expected a density with its unit, {}; try density = \"1000 kg/m^3\"", why);
    if (values.given(density_path))
        values.refuse(density_path, advice);
    throw InputError(values.place(density_path), density_path + " is missing; " + advice);
}

/// The viscosity eta in Pa s for a fluid of that density, which must be given with a unit.
double true_dynamic_viscosity(const CaseValues& values, double density, const std::string& why) {
    if (const auto eta = si_value(values, dynamic))
        return *eta;
    if (const auto nu = si_value(values, kinematic)) {
        if (*nu > 0.0)
            return *nu * density;
        values.refuse(kinematic,
                      "expected a kinematic viscosity above 0; try kinematic_viscosity = \"1.2e-6 m^2/s\"");
    }
    values.refuse(
        kinematic,
        fmt::format("expected a viscosity with its unit, {}; try dynamic_viscosity = \"1.2 mPa s\"", why));
}

/// The lattice's own choice where the physical viscosity has a unit.
double chosen_lattice_viscosity(const CaseValues& values) {
    return lattice_viscosity_of(values.find(relaxation) ? values.number(relaxation) : 1.0);
}

CaseUnits close_with_time_step(const CaseValues& values, double cell) {
    const double step = *si_value(values, "units.time_step");
    const double density = true_density(values, "which fixes the scale of mass beside units.time_step");
    CaseUnits result{Scales{cell, step, density}, std::nullopt, 0.0, 1.0};
    if (const auto nu = lattice_viscosity(values)) {
        result.kinematic_viscosity = *nu;
        return result;
    }
    const std::string path = values.find(dynamic) ? dynamic : kinematic;
    const double eta = true_dynamic_viscosity(values, density, "");
    result.kinematic_viscosity = result.scales->to_lattice({eta, dimension::dynamic_viscosity});
    // fluid.kinematic_viscosity's own range, however the viscosity was stated.
    const CaseKey& key = *find_case_key(kinematic);
    if (!key.range.contains(result.kinematic_viscosity)) {
        values.refuse(path, fmt::format("expected at most {:g} in lattice units, not {:.4g}; try a shorter "
                                        "units.time_step",
                                        key.range.high, result.kinematic_viscosity));
    }
    return result;
}

CaseUnits close_with_density(const CaseValues& values, double cell) {
    const double density = *si_value(values, "units.density");
    if (values.given(density_path) &&
        (si_value(values, density_path) || values.number(density_path) != 1.0)) {
        values.refuse(density_path, "expected the density to be stated once, but units.density is " +
                                        values.find("units.density")->shown + "; try removing one of them");
    }
    const double eta = true_dynamic_viscosity(values, density, "from which units.density finds the step");
    const double nu = chosen_lattice_viscosity(values);
    return {Scales{cell, nu * cell * cell * density / eta, density}, std::nullopt, nu, 1.0};
}

/// R0 of the first vesicle in metres.
double first_radius(const CaseValues& values, double cell) {
    const std::string path = "vesicle[0].radius";
    if (!values.find(path))
        values.refuse(path, "expected a length, which units.reynolds needs; try radius = \"2.8 um\"");
    const auto metres = si_value(values, path);
    const double radius = metres ? *metres : cell * values.number(path);
    if (radius <= 0.0)
        values.refuse(path, "expected a length above 0; try radius = \"2.8 um\"");
    return radius;
}

/// kappa of the first vesicle's type in joules.
double first_bending_modulus(const CaseValues& values) {
    const std::string bending = "vesicle_type." + values.text("vesicle[0].type") + ".bending.";
    const bool paper = values.find(bending + "paper_modulus") != nullptr;
    const std::string path = bending + (paper ? "paper_modulus" : "modulus");
    const auto modulus = si_value(values, path);
    if (!modulus || *modulus <= 0.0) {
        values.refuse(
            path, "expected an energy above 0 with its unit, since units.reynolds takes its velocity from "
                  "bending; try modulus = \"2e-19 J\", or [units] with time_step or density");
    }
    return paper ? *modulus / 4.0 : *modulus;
}

/// Re over the density, from the flow's shear rate or, without a shear, the membrane's own velocity.
double reynolds_per_density(const CaseValues& values, double eta, double radius) {
    const std::string path = "flow.shear.rate";
    if (!values.has_table("flow.shear"))
        return first_bending_modulus(values) / (eta * eta * radius);
    const auto rate = si_value(values, path);
    if (!rate || *rate == 0.0)
        values.refuse(path,
                      "expected a rate other than 0 with its unit, from which units.reynolds scales the "
                      "inertia; try rate = \"100 1/s\"");
    return std::abs(*rate) * radius * radius / eta;
}

CaseUnits close_with_reynolds(const CaseValues& values, double cell) {
    const double reynolds = values.number("units.reynolds");
    const double density = true_density(values, "from which units.reynolds scales the inertia");
    const double eta = true_dynamic_viscosity(values, density, "from which units.reynolds finds the step");
    const double radius = first_radius(values, cell);
    const double group = reynolds_per_density(values, eta, radius);
    const double scaled = reynolds / group;
    const double nu = chosen_lattice_viscosity(values);
    return {Scales{cell, nu * cell * cell * scaled / eta, scaled},
            InertiaScaling{reynolds, density * group, density}, nu, 1.0};
}

} // namespace

CaseUnits close_units(const CaseValues& values) {
    if (!values.has_table("units"))
        return without_units(values);
    const double cell = *si_value(values, "units.cell");
    const CaseUnits result = values.find("units.time_step") ? close_with_time_step(values, cell)
                             : values.find("units.density") ? close_with_density(values, cell)
                                                            : close_with_reynolds(values, cell);
    for (const Dimension& entry : {dimension::length, dimension::time, dimension::density, dimension::energy,
                                   dimension::tension_per_area_squared}) {
        const double unit = result.scales->unit(entry);
        if (!(unit > 1e-200 && unit < 1e200))
            values.refuse("units.cell", "expected scales that a double can hold; try a cell near \"0.2 um\"");
    }
    return result;
}

std::string units_explanation() {
    return R"(A value with a unit needs `[units]`. `cell` fixes the length; lattice density 1 stands for the fluid's density.
Exactly one of three keys closes the rest:

- `time_step` gives the step, and `fluid.density` (with its unit) the mass. The lattice viscosity follows from a
  viscosity with a unit, or is given as a lattice number.
- `density` is the fluid's density; `fluid.density` is then left out. The viscosity has a unit, and the step is
  `nu_lattice cell^2/nu`, where the lattice viscosity is chosen by `fluid.relaxation_time` (1 if absent).
- `reynolds` scales the inertia. In a shear Re = rho gamma R0^2/eta; without one the membrane's own velocity
  U = kappa/(eta R0^2) makes it rho kappa/(eta^2 R0), with R0 and kappa of the first vesicle. Viscosity, modulus, radius
  (and so all times) stay real; the fluid is made denser until Re is the one asked for. A red cell in water has Re about
  5e-5 by itself, and 6e-4 at 100 1/s. `fluid.density`, the viscosity and the rate (or the bending modulus) have units; the step is
  `nu_lattice cell^2 rho'/eta`, the lattice viscosity chosen by `fluid.relaxation_time` (1 if absent).

With `density` or `reynolds`, `relaxation_time` may therefore stand beside a viscosity with a unit: one is the lattice's
own, the other the fluid's.
)";
}

} // namespace vesica
