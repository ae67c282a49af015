#include "simulation/engine_cases.hpp"
#include "simulation/run_surfaces.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace vesica;
using namespace vesica::test;

namespace {

/// Mean over the points, and the largest distance from it.
struct Spread {
    double mean = 0.0;
    double range = 0.0;
};

Spread spread_of(const SurfaceArrays& surface, const std::string& name) {
    const auto found = std::find_if(surface.quantities.begin(), surface.quantities.end(),
                                    [&](const SurfaceQuantity& quantity) { return quantity.name == name; });
    REQUIRE(found != surface.quantities.end());
    Spread spread;
    for (const float value : found->values)
        spread.mean += static_cast<double>(value) / static_cast<double>(found->values.size());
    for (const float value : found->values)
        spread.range = std::max(spread.range, std::abs(static_cast<double>(value) - spread.mean));
    return spread;
}

Parameters tense_sphere(double radius) {
    Parameters parameters = deforming_spheroid(40, radius);
    parameters.vesicles[0].shape = SphereShape{};
    parameters.types[0].sigma = 0.002;
    parameters.types[0].bending.modulus = 0.3;
    parameters.types[0].bending.form = HelfrichBending{-0.1};
    parameters.types[0].area.constraint = PenaltyConstraint{0.5};
    parameters.types[0].area.deflation = 1.1; // the area is too small: the constraint pushes outwards
    parameters.types[0].area.ramp = 0;
    return parameters;
}

} // namespace

TEST_CASE("the force's parts on a sphere are those of theory, positive outwards") {
    const double R = 12.0;
    const auto engine = make_engine(tense_sphere(R), 1);
    run(*engine, 20);
    const VesicleSnapshot vesicle = engine->vesicles(0, 1).front();
    const SurfaceArrays surface = surface_of(vesicle, 0, std::nullopt);
    const double kappa = 0.3, C0 = -0.1, sigma = 0.002;
    const double bending = kappa * (2.0 / R - C0) * C0 / R; // Lap_s H = 0, H^2 = K
    const double held = vesicle.tension - sigma;
    CHECK(held < -0.01);
    CHECK(spread_of(surface, "tension_force").mean == Approx(-2.0 * sigma / R).epsilon(0.01));
    CHECK(spread_of(surface, "area_force").mean == Approx(-2.0 * held / R).epsilon(0.01));
    CHECK(spread_of(surface, "bending_force").mean == Approx(bending).epsilon(0.03));
    const double total = bending - 2.0 * vesicle.tension / R;
    CHECK(spread_of(surface, "total_force").mean == Approx(total).epsilon(0.02));
    CHECK(spread_of(surface, "tension_force").range < 0.05 * 2.0 * sigma / R);
}

TEST_CASE("in units the forces on a surface are pressures and the curvatures per length") {
    const auto engine = make_engine(tense_sphere(9.0), 1);
    const VesicleSnapshot vesicle = engine->vesicles(0, 1).front();
    const Scales scales{2e-7, 1e-6, 1e3};
    const SurfaceArrays lattice = surface_of(vesicle, 0, std::nullopt);
    const SurfaceArrays si = surface_of(vesicle, 0, scales);
    const double pressure = 1e3 * std::pow(2e-7 / 1e-6, 2);
    for (const auto& [name, unit] :
         {std::pair{"mean_curvature", 1.0 / 2e-7}, std::pair{"gaussian_curvature", 1.0 / 4e-14},
          std::pair{"bending_force", pressure}, std::pair{"tension_force", pressure},
          std::pair{"area_force", pressure}, std::pair{"total_force", pressure}})
        CHECK(spread_of(si, name).mean == Approx(unit * spread_of(lattice, name).mean));
}

TEST_CASE("some of the vesicles are the same as among all") {
    Parameters parameters = deforming_spheroid(40, 6.0);
    for (const Vec3<double>& centre : {Vec3<double>{10, 10, 20}, Vec3<double>{30, 30, 38}}) {
        parameters.vesicles.push_back(parameters.vesicles.front());
        parameters.vesicles.back().centre = centre;
    }
    parameters.vesicles.front().centre = {30, 10, 10};
    const auto engine = make_engine(parameters, 1);
    run(*engine, 3);
    const Snapshot all = engine->snapshot();
    const std::vector<VesicleSnapshot> some = engine->vesicles(1, 2);
    REQUIRE(some.size() == 2);
    for (std::size_t k = 0; k < 2; ++k) {
        const VesicleSnapshot& expected = all.vesicles[k + 1];
        CHECK(some[k].colour_mass == expected.colour_mass);
        CHECK(some[k].inside.size() == expected.inside.size());
        REQUIRE(some[k].cells.size() == expected.cells.size());
        for (std::size_t cell = 0; cell < expected.cells.size(); ++cell) {
            CHECK(some[k].cells[cell].position == expected.cells[cell].position);
            CHECK(some[k].cells[cell].phi == expected.cells[cell].phi);
        }
    }
}
