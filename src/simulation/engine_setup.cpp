#include "simulation/engine_setup.hpp"

#include "collision/relaxation.hpp"
#include "core/input_error.hpp"
#include "measure/layer_moment.hpp"
#include "shape/shape.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

namespace vesica {

namespace {

BendingLaw bending_law(const BendingParameters& bending) {
    if (const auto* helfrich = std::get_if<HelfrichBending>(&bending.form))
        return HelfrichLaw{bending.modulus, helfrich->spontaneous_curvature};
    return PaperBendingLaw{bending.modulus, std::get<PaperBending>(bending.form).laplacian_coefficient};
}

/// The Helfrich modulus of equal resistance against ripples on a sphere: the paper's form has its coefficient
/// c in the place of 1/2.
double stiffness_of(const BendingParameters& bending) {
    const auto* paper = std::get_if<PaperBending>(&bending.form);
    return paper != nullptr ? 2.0 * paper->laplacian_coefficient * bending.modulus : bending.modulus;
}

/// Gains of the area's controller for a vesicle of radius R in a fluid of viscosity eta. Half of the largest
/// explicit stiffness eta R makes the area an oscillator of omega^2 = 4 H^2 K/(3 rho), three cells of fluid
/// on the spring of the membrane; the derivative time damps it about critically, and the integral follows ten
/// times more slowly.
AreaMultiplier::Gains controller_gains(const VesicleType& type, double radius, double dynamic_viscosity,
                                       double nu, double excess_area) {
    AreaMultiplier::Gains gains;
    gains.proportional = 0.5 * dynamic_viscosity * radius;
    gains.derivative_time = 0.2 * radius / nu;
    gains.integral_time = 2.0 * radius / nu * std::max(1.0, 0.3 / std::max(excess_area, 0.01));
    // The sphere's mode l = 3 buckles at sigma R^2/kappa = -12. A membrane that cannot bend resists no
    // compression.
    gains.lowest_tension = -12.0 * stiffness_of(type.bending) / (radius * radius) - type.sigma;
    gains.first_tension = -type.sigma;
    return gains;
}

AreaLaw area_law(const VesicleType& type, double radius, double dynamic_viscosity, double nu,
                 double excess_area) {
    struct Choose {
        const VesicleType& type;
        double radius;
        double eta;
        double nu;
        double excess_area;
        AreaLaw operator()(const NoConstraint&) const { return FreeArea{}; }
        AreaLaw operator()(const MultiplierConstraint&) const {
            return AreaMultiplier(controller_gains(type, radius, eta, nu, excess_area));
        }
        AreaLaw operator()(const PenaltyConstraint& penalty) const { return AreaPenalty{penalty.modulus}; }
        AreaLaw operator()(const PaperConstraint& paper) const { return PaperAreaPenalty{paper.alpha}; }
    };
    return std::visit(Choose{type, radius, dynamic_viscosity, nu, excess_area}, type.area.constraint);
}

VesicleSetup vesicle_setup(const Parameters& parameters, const VesicleParameters& vesicle) {
    const FluidParameters& fluid = parameters.fluid;
    const VesicleType& type = parameters.types.at(vesicle.type);
    const std::shared_ptr<const Shape> shape = make_shape(vesicle);
    VesicleSetup setup;
    setup.inner_rate = relaxation_rate(fluid.kinematic_viscosity * type.viscosity_ratio);
    setup.viscosity_ratio = type.viscosity_ratio;
    setup.buoyancy = parameters.buoyancy_of(vesicle);
    setup.bending_modulus = type.bending.modulus;
    if (const auto* helfrich = std::get_if<HelfrichBending>(&type.bending.form))
        setup.spontaneous_curvature = helfrich->spontaneous_curvature;
    const double radius = std::cbrt(shape->volume() * 3.0 / (4.0 * std::numbers::pi));
    const double sphere = 4.0 * std::numbers::pi * radius * radius;
    Membrane& membrane = setup.membrane;
    membrane.bending = bending_law(type.bending);
    membrane.sigma = type.sigma;
    membrane.target.initial = shape->area();
    membrane.target.final = type.area.deflation ? *type.area.deflation * sphere : shape->area();
    membrane.target.ramp = type.area.ramp;
    membrane.area = area_law(type, radius, fluid.density * fluid.kinematic_viscosity,
                             fluid.kinematic_viscosity, membrane.target.final / sphere - 1.0);
    return setup;
}

} // namespace

std::shared_ptr<const InitialColours> initial_colours(const Parameters& parameters, const Block& block,
                                                      int threads) {
    if (parameters.vesicles.empty())
        return nullptr;
    std::vector<InitialColours::Placed> shapes;
    const std::vector<int> labels = parameters.labels();
    for (std::size_t k = 0; k < labels.size(); ++k)
        shapes.push_back({make_shape(parameters.vesicles[k]), parameters.vesicles[k].centre, labels[k]});
    return std::make_shared<const InitialColours>(block, std::move(shapes), parameters.fluid.segregation,
                                                  parameters.numerics.cutoff, threads);
}

EngineSetup make_engine_setup(const Parameters& parameters, int threads,
                              std::shared_ptr<const Neighbourhood> neighbourhood) {
    EngineSetup setup;
    const FluidParameters& fluid = parameters.fluid;
    setup.neighbourhood = std::move(neighbourhood);
    setup.reference_density = fluid.density;
    setup.drive = FlowDrive(parameters);
    setup.outer_viscosity = fluid.density * fluid.kinematic_viscosity;
    setup.outer_rate = relaxation_rate(fluid.kinematic_viscosity);
    setup.ghosts = fluid.ghosts;
    setup.precision = parameters.numerics.precision;
    setup.threads = threads;
    setup.layer = {fluid.segregation,          fluid.density,
                   parameters.numerics.cutoff, parameters.numerics.geometry,
                   parameters.wetting,         0};
    setup.layer_moments = lattice_layer_moments(fluid.segregation);
    if (parameters.vesicles.empty())
        return setup;

    for (const VesicleParameters& vesicle : parameters.vesicles)
        if (!vesicle.joins_previous)
            setup.vesicles.push_back(vesicle_setup(parameters, vesicle));
    setup.layer.labels = static_cast<int>(setup.vesicles.size());
    for (const VesicleSetup& vesicle : setup.vesicles)
        if (vesicle.membrane.bending.index() != setup.vesicles.front().membrane.bending.index())
            throw InputError(
                "the vesicles' membranes are of several bending forms; expected one form for all");
    setup.colours = initial_colours(parameters, setup.neighbourhood->block(), threads);
    return setup;
}

} // namespace vesica
