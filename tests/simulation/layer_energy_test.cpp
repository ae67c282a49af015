#include "measured.hpp"
#include "simulation/exact_layer.hpp"

#include <catch2/catch.hpp>

using namespace vesica;
using namespace vesica::test;

namespace {

Vec3<int> box_for(double radius) {
    const int edge = static_cast<int>(std::ceil((2.8 * radius + 20) / 8)) * 8;
    return {edge, edge, edge};
}

/// Where the surface's centre lies: off the lattice's symmetry points.
Vec3<double> centre_of(const Vec3<int>& box) {
    return {box.x / 2.0 + 0.23, box.y / 2.0 - 0.31, box.z / 2.0 + 0.12};
}

Layer<double> layer_of(const PolarSurface& surface, const Membrane& membrane) {
    const Vec3<int> box = box_for(surface.radius);
    const Vec3<double> centre = centre_of(box);
    return exact_layer(
        box, [&](const Vec3<double>& x) { return surface.signed_distance(x - centre); }, membrane);
}

/// Work of the layer's forces when the surface's a2 grows at unit rate: sum F.dx/da2. The displacement R P2
/// e_r of the surface is continued through the layer as an incompressible fluid does it, like 1/r^2 along
/// each ray.
double power_of_forces(const PolarSurface& surface, const Membrane& membrane) {
    const Vec3<double> centre = centre_of(box_for(surface.radius));
    double power = 0.0;
    for_each_force(layer_of(surface, membrane), [&](const Vec3<double>& x, const Vec3<double>& F) {
        const Vec3<double> r = x - centre;
        const double distance = norm(r);
        const double thinning = std::pow(surface.r(std::acos(r.z / distance)) / distance, 2);
        power += surface.radius * PolarSurface::p2(r.z / distance) * thinning * dot(F, r) / distance;
    });
    return power;
}

template <class Energy>
double slope_of(PolarSurface surface, const Energy& energy) {
    constexpr double h = 1e-3;
    surface.a2 += h;
    const double above = energy(surface);
    surface.a2 -= 2 * h;
    return (above - energy(surface)) / (2 * h);
}

} // namespace

TEST_CASE("the bending force is minus the gradient of Helfrich's energy") {
    const double c0 = GENERATE(0.0, 0.08, -0.05);
    const PolarSurface surface{20.0, 0.15, 0.1};
    Membrane membrane;
    membrane.bending = HelfrichLaw{1.0, c0};
    const double expected = -slope_of(surface, [&](const PolarSurface& s) { return s.bending_energy(c0); });
    INFO("C0 " << c0 << " expected " << expected);
    CHECK(power_of_forces(surface, membrane) == Approx(expected).epsilon(0.01));
}

TEST_CASE("the paper's bending force with coefficient one half is Helfrich's") {
    const PolarSurface surface{16.0, 0.15, 0.1};
    Membrane helfrich;
    helfrich.bending = HelfrichLaw{1.0, 0.0};
    Membrane paper;
    paper.bending = PaperBendingLaw{1.0, 0.5};
    CHECK(power_of_forces(surface, paper) == Approx(power_of_forces(surface, helfrich)).epsilon(1e-10));
}

TEST_CASE("the tension force is minus the gradient of sigma A") {
    const PolarSurface surface{20.0, 0.15, 0.1};
    Membrane membrane;
    membrane.sigma = 1.0;
    const double expected = -slope_of(surface, [](const PolarSurface& s) { return s.area(); });
    CHECK(power_of_forces(surface, membrane) == Approx(expected).epsilon(0.01));
}

TEST_CASE("a free pear-shaped vesicle feels no net force and no net torque") {
    const PolarSurface surface{20.0, 0.2, 0.15};
    Membrane membrane;
    membrane.bending = HelfrichLaw{1.0, 0.0};
    const Vec3<double> centre = centre_of(box_for(surface.radius));
    Vec3<double> net;
    Vec3<double> torque;
    double total = 0.0;
    for_each_force(layer_of(surface, membrane), [&](const Vec3<double>& x, const Vec3<double>& F) {
        net = net + F;
        torque = torque + cross(x - centre, F);
        total += norm(F);
    });
    INFO("net " << norm(net) / total << " torque " << norm(torque) / (total * surface.radius));
    CHECK(norm(net) < 1e-3 * total);
    CHECK(norm(torque) < 1e-3 * total * surface.radius);
    measured("net force on a pear over int |f|", "Helfrich", norm(net) / total);
    measured("net torque on a pear over R int |f|", "Helfrich", norm(torque) / (total * surface.radius));
}

TEST_CASE("with coefficient three halves the paper's force pushes a pear through the fluid") {
    const PolarSurface surface{20.0, 0.2, 0.15};
    Membrane membrane;
    membrane.bending = PaperBendingLaw{1.0, 1.5};
    Vec3<double> net;
    double total = 0.0;
    for_each_force(layer_of(surface, membrane), [&](const Vec3<double>&, const Vec3<double>& F) {
        net = net + F;
        total += norm(F);
    });
    CHECK(norm(net) > 3e-3 * total);
    measured("net force on a pear over int |f|", "paper, coefficient 3/2", norm(net) / total);
}

TEST_CASE("a sphere is free of bending force, and the force scales with the radius to the minus three") {
    const auto largest_force = [](const PolarSurface& surface) {
        Membrane membrane;
        membrane.bending = HelfrichLaw{1.0, 0.0};
        double largest = 0.0;
        for_each_force(layer_of(surface, membrane), [&](const Vec3<double>&, const Vec3<double>& F) {
            largest = std::max(largest, norm(F));
        });
        return largest;
    };
    const double sphere = largest_force({20.0, 0.0, 0.0});
    const double spheroid = largest_force({20.0, 0.15, 0.0});
    const double half_spheroid = largest_force({10.0, 0.15, 0.0});
    CHECK(sphere < 0.02 * spheroid);
    CHECK(half_spheroid / spheroid == Approx(8.0).epsilon(0.05));
}

TEST_CASE("bending force and energy gradient differ less and less, with order 1.8 at least",
          "[.validation]") {
    constexpr double radii[] = {10.0, 14.0, 20.0, 28.0};
    for (const double c0_times_radius : {0.0, 1.6, -1.0}) {
        double errors[4];
        for (std::size_t k = 0; k < 4; ++k) {
            const PolarSurface surface{radii[k], 0.15, 0.1};
            const double c0 = c0_times_radius / radii[k];
            Membrane membrane;
            membrane.bending = HelfrichLaw{1.0, c0};
            const double expected =
                -slope_of(surface, [&](const PolarSurface& s) { return s.bending_energy(c0); });
            const double error = power_of_forces(surface, membrane) / expected - 1.0;
            errors[k] = std::abs(error);
            measured("power of the bending force over -dE/d(displacement), less 1",
                     "C0 R = " + std::to_string(c0_times_radius).substr(0, 4) +
                         ", R = " + std::to_string(radii[k]).substr(0, 2),
                     error);
        }
        CHECK(errors[2] < 0.01);
        CHECK(std::log(errors[0] / errors[3]) / std::log(2.8) > 1.8);
    }
}
