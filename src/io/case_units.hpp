#pragma once

#include "case/case.hpp"
#include "io/case_values.hpp"

#include <optional>
#include <string>

namespace vesica {

struct CaseUnits {
    std::optional<Scales> scales;
    std::optional<InertiaScaling> inertia;
    double kinematic_viscosity = 0.0; ///< lattice
    double density = 1.0;             ///< lattice
};

/// Finds the scales from [units] and the fluid, and with them the fluid's lattice viscosity and density.
///
/// `cell` gives the length. The lattice density is 1 wherever there are [units]; the other two scales come
/// from
///
/// - time_step: the step is given, and fluid.density, with its unit, is what lattice density 1 stands for.
/// The lattice
///   viscosity follows from a viscosity with a unit, or is given as a lattice number.
/// - density: it is what lattice density 1 stands for. The step follows from the viscosity, which has a unit,
/// and the
///   lattice viscosity chosen by fluid.relaxation_time (1 if absent): step = nu_lattice cell^2/nu.
/// - reynolds: the fluid at rest has the bending velocity U = kappa/(eta R0^2) and so Re = rho U R0/eta =
///   rho kappa/(eta^2 R0). eta, kappa and R0 (of the first vesicle) stay real; lattice density 1 stands for
///   the density rho' = Re eta^2 R0/kappa that has this Re. The step follows as above with nu = eta/rho'.
///
/// Throws InputError where something needed is missing, has no unit, or is stated twice.
CaseUnits close_units(const CaseValues& values);

/// How the three ways close the system, in Markdown for the reference page.
std::string units_explanation();

} // namespace vesica
