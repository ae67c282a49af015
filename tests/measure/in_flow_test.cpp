#include "exact_field.hpp"
#include "measure/in_flow.hpp"
#include "measure/metrics.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace vesica;

namespace {

const ShearPlane plane{{1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}};
const Vec3<double> middle{20.2, 19.9, 20.4};

VesicleSnapshot spheroid(double length, double width) {
    VesicleSnapshot vesicle = exact::snapshot_of(exact::Spheroid{middle, length, width}, {20, 20, 20}, 30);
    vesicle.colour_mass = 1.0;
    return vesicle;
}

Snapshot box(double rate = 0.0) {
    Snapshot snapshot;
    snapshot.size = {40.0, 50.0, 60.0};
    snapshot.walls = {false, false, true};
    snapshot.outer_viscosity = 0.25;
    snapshot.shear_rate = rate;
    return snapshot;
}

} // namespace

TEST_CASE("a membrane that turns like a wheel goes round at the wheel's frequency, wherever its centre lies",
          "[measure]") {
    const Vec3<double> centre{20.2, 20.4 + GENERATE(-0.5, -0.4, -0.25, 0.0, 0.1), 20.4};
    VesicleSnapshot vesicle = exact::snapshot_of(exact::Spheroid{centre, 10.0, 10.0}, {20, 20, 20}, 18);
    vesicle.colour_mass = 1.0;
    const double omega = 1.3e-3;
    // The shear turns from the gradient to the flow: u_x = omega z, u_z = -omega x; and the whole moves
    // along.
    const Vec3<double> drift{0.02, -0.01, 0.005};
    vesicle.momentum = drift;
    for (InterfaceCell& cell : vesicle.cells)
        cell.u = drift + Vec3<double>{omega * (cell.position.z - centre.z), 0.0,
                                      -omega * (cell.position.x - centre.x)};
    CHECK(tank_treading_frequency(vesicle, plane) == Approx(omega).epsilon(0.02));
    CHECK(tank_treading_frequency(vesicle, {{-1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}}) ==
          Approx(-omega).epsilon(0.02));
}

TEST_CASE("a membrane that moves both ways does not go round", "[measure]") {
    VesicleSnapshot vesicle = spheroid(10.0, 10.0);
    for (InterfaceCell& cell : vesicle.cells) // pure extension
        cell.u = {1e-3 * (cell.position.x - middle.x), 0.0, -1e-3 * (cell.position.z - middle.z)};
    CHECK(std::isnan(tank_treading_frequency(vesicle, plane)));
}

TEST_CASE("forces that hold a body against a shear add stress, wherever the origin lies", "[measure]") {
    // f = -A x n on a sphere, A the shear's direction: int f x dA = -A x (4 pi R^4/3)/R.
    VesicleSnapshot vesicle = spheroid(10.0, 10.0);
    for (InterfaceCell& cell : vesicle.cells)
        cell.force = cell.weight * cell.J * Vec3<double>{-cell.n.z, 0.0, -cell.n.x};
    const double area_moment = 4.0 * std::numbers::pi * 1000.0 / 3.0;
    CHECK(particle_stress(vesicle, plane, 0.25) == Approx(area_moment).epsilon(0.03));
    VesicleSnapshot moved = vesicle;
    for (InterfaceCell& cell : moved.cells)
        cell.position = cell.position + Vec3<double>{7.0, -3.0, 11.0};
    for (InsideSpan& span : moved.inside) {
        span.begin += 7;
        span.y -= 3;
        span.z += 11;
    }
    CHECK(particle_stress(moved, plane, 0.25) == Approx(particle_stress(vesicle, plane, 0.25)).epsilon(1e-9));
}

TEST_CASE("another viscosity inside adds what its excess bears in a straining flow, through the layer",
          "[measure]") {
    VesicleSnapshot vesicle = spheroid(10.0, 10.0);
    vesicle.viscosity_ratio = GENERATE(0.2, 0.5, 3.0, 5.0);
    const double rate = 2e-3; // u = rate (z, 0, x)/2
    // Cell by cell, from the fraction alone: 1/eta is linear in it.
    const auto excess = [&](double red) {
        return 0.25 * (1.0 / (1.0 - red + red / vesicle.viscosity_ratio) - 1.0);
    };
    double borne = 0.0;
    for (InterfaceCell& cell : vesicle.cells) {
        cell.u = {0.5 * rate * (cell.position.z - middle.z), 0.0, 0.5 * rate * (cell.position.x - middle.x)};
        borne += excess(0.5 * (1.0 + cell.phi)) * rate;
    }
    for (const InsideSpan& span : vesicle.inside)
        borne += span.count * excess(1.0) * rate;
    INFO("viscosity ratio " << vesicle.viscosity_ratio);
    CHECK(particle_stress(vesicle, plane, 0.25) == Approx(borne).epsilon(0.01));
}

TEST_CASE("metrics of a flow: the walls' stress, the effective viscosity and the gap", "[measure]") {
    Snapshot snapshot = box(2e-3);
    snapshot.vesicles.push_back(spheroid(10.0, 10.0));
    snapshot.wall_force[2][0] = {-0.8, 0.0, 0.3};
    snapshot.wall_force[2][1] = {1.2, 0.0, -0.3};
    const VesicleSnapshot& vesicle = snapshot.vesicles.front();
    const MetricsRow row = measure(vesicle, snapshot, baseline_of(vesicle, 0, plane));
    CHECK(row.wall_stress == Approx(1.0 / 2000.0));
    CHECK(row.effective_viscosity ==
          Approx(1.0 + row.particle_stress / (0.25 * 2e-3 * 40.0 * 50.0 * 60.0)).epsilon(1e-12));
    CHECK(row.gap == Approx(10.4).margin(0.1)); // from z = 0; the other wall is at 60
    const MetricsRow at_rest = measure(vesicle, box(), baseline_of(vesicle, 0));
    CHECK(std::isnan(at_rest.tank_treading_frequency));
    CHECK(std::isnan(at_rest.effective_viscosity));
}
