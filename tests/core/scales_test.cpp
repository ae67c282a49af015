#include "core/scales.hpp"

#include <catch2/catch.hpp>

using namespace vesica;

TEST_CASE("every quantity goes to the lattice and back") {
    const Scales scales{2e-7, 5.6e-6, 8.4e5};
    for (const Dimension& entry :
         {dimension::none, dimension::length, dimension::area, dimension::volume, dimension::curvature,
          dimension::time, dimension::rate, dimension::velocity, dimension::acceleration,
          dimension::kinematic_viscosity, dimension::mass, dimension::density, dimension::dynamic_viscosity,
          dimension::pressure, dimension::tension, dimension::force, dimension::energy,
          dimension::force_density, dimension::tension_per_area_squared}) {
        INFO(dimension_name(entry));
        const Quantity si = scales.to_si(0.3, entry);
        CHECK(si.dimension == entry);
        CHECK(scales.to_lattice(si) == Approx(0.3).epsilon(1e-14));
        CHECK(scales.to_si(scales.to_lattice({3.7, entry}), entry).value == Approx(3.7).epsilon(1e-14));
    }
}

TEST_CASE("lattice units are worth what their definition says") {
    const Scales scales{0.5, 0.25, 8.0};
    CHECK(scales.unit(dimension::length) == 0.5);
    CHECK(scales.unit(dimension::time) == 0.25);
    CHECK(scales.unit(dimension::density) == 8.0);
    CHECK(scales.unit(dimension::mass) == 1.0);                // 8 * 0.5^3
    CHECK(scales.unit(dimension::velocity) == 2.0);            // 0.5 / 0.25
    CHECK(scales.unit(dimension::kinematic_viscosity) == 1.0); // 0.5^2 / 0.25
    CHECK(scales.unit(dimension::energy) == 4.0);              // m L^2 / T^2
    CHECK(scales.unit(dimension::tension) == 16.0);            // m / T^2
    CHECK(scales.unit(dimension::pressure) == 32.0);           // rho L^2 / T^2
}

TEST_CASE("dimensionless groups do not depend on the scales") {
    // Re = rho kappa/(eta^2 R0) of a red cell.
    const double radius = 2.8e-6, kappa = 2e-19, eta = 1.2e-3, rho = 1000.0;
    const double group = rho * kappa / (eta * eta * radius);
    for (const Scales& scales : {Scales{2e-7, 5e-9, 1000.0}, Scales{1e-7, 3e-6, 7.0}}) {
        const double lattice_eta = scales.to_lattice({eta, dimension::dynamic_viscosity});
        CHECK(scales.to_lattice({rho, dimension::density}) * scales.to_lattice({kappa, dimension::energy}) /
                  (lattice_eta * lattice_eta * scales.to_lattice({radius, dimension::length})) ==
              Approx(group).epsilon(1e-13));
    }
}
