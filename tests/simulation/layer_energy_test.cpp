#include "measured.hpp"
#include "simulation/exact_layer.hpp"

#include <catch2/catch.hpp>

#include <string>

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

/// A rotation that leaves the axis along no line of the lattice.
Vec3<double> tilted(const Vec3<double>& x) {
    const Vec3<double> once{0.8 * x.x + 0.6 * x.z, x.y, -0.6 * x.x + 0.8 * x.z};
    return {once.x, (12.0 * once.y + 5.0 * once.z) / 13.0, (-5.0 * once.y + 12.0 * once.z) / 13.0};
}

Layer<double> layer_of(const PolarSurface& surface, const Membrane& membrane, bool tilt = false) {
    const Vec3<int> box = box_for(surface.radius);
    const Vec3<double> centre = centre_of(box);
    const auto signed_distance = [&](const Vec3<double>& x) {
        return surface.signed_distance(tilt ? tilted(x - centre) : x - centre);
    };
    return exact_layer(box, signed_distance, membrane);
}

/// A way to deform r = R (1 + a2 P2 + a3 P3).
struct Mode {
    const char* name;
    double PolarSurface::*amplitude;
    double (*polynomial)(double);
};
constexpr Mode ellipse{"P2", &PolarSurface::a2, PolarSurface::p2};
constexpr Mode pear{"P3", &PolarSurface::a3, PolarSurface::p3};

/// Work of the layer's forces when the mode's amplitude a grows at unit rate: sum F.dx/da. The displacement
/// R P e_r of the surface is continued through the layer as an incompressible fluid does it, like 1/r^2
/// along each ray.
double power_of_forces(const PolarSurface& surface, const Layer<double>& layer, const Mode& mode) {
    const Vec3<double> centre = centre_of(box_for(surface.radius));
    double power = 0.0;
    for_each_force(layer, [&](const Vec3<double>& x, const Vec3<double>& F) {
        const Vec3<double> r = x - centre;
        const double distance = norm(r);
        const double thinning = std::pow(surface.r(std::acos(r.z / distance)) / distance, 2);
        power += surface.radius * mode.polynomial(r.z / distance) * thinning * dot(F, r) / distance;
    });
    return power;
}

double power_of_forces(const PolarSurface& surface, const Membrane& membrane) {
    return power_of_forces(surface, layer_of(surface, membrane), ellipse);
}

template <class Energy>
double slope_of(PolarSurface surface, const Energy& energy, const Mode& mode = ellipse) {
    constexpr double h = 1e-3;
    surface.*mode.amplitude += h;
    const double above = energy(surface);
    surface.*mode.amplitude -= 2 * h;
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
    for_each_force(layer_of(surface, membrane, true), [&](const Vec3<double>& x, const Vec3<double>& F) {
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

TEST_CASE("bending force and energy gradient differ less and less, with second order", "[.validation]") {
    constexpr double radii[] = {10.0, 14.0, 20.0, 28.0};
    for (const int c0_times_radius : {0, -2, 1, 2}) {
        double errors[2][4];
        for (std::size_t k = 0; k < 4; ++k) {
            const PolarSurface surface{radii[k], 0.15, 0.1};
            const double c0 = c0_times_radius / radii[k];
            const auto energy = [&](const PolarSurface& s) {
                return s.bending_energy(c0);
            };
            Membrane membrane;
            membrane.bending = HelfrichLaw{1.0, c0};
            const Layer<double> layer = layer_of(surface, membrane);
            for (const Mode& mode : {ellipse, pear}) {
                const double expected = -slope_of(surface, energy, mode);
                const double error = power_of_forces(surface, layer, mode) / expected - 1.0;
                errors[mode.amplitude == pear.amplitude ? 1 : 0][k] = error;
                measured("power of the bending force over -dE/d(displacement), less 1",
                         std::string(mode.name) + ", C0 R = " + std::to_string(c0_times_radius) +
                             ", R = " + std::to_string(radii[k]).substr(0, 2),
                         error);
            }
        }
        for (const auto& of_mode : errors) {
            INFO("C0 R " << c0_times_radius << ": " << of_mode[0] << " " << of_mode[1] << " " << of_mode[2]
                         << " " << of_mode[3]);
            CHECK(std::abs(of_mode[2]) < 0.01);
            // An error a/R^2 + b/R^4 may pass through zero; R^2 times it then tends to a, in steps half as
            // large each.
            const auto leading = [&](std::size_t k) {
                return radii[k] * radii[k] * of_mode[k];
            };
            CHECK(std::abs(leading(3) - leading(2)) < 0.7 * std::abs(leading(2) - leading(1)));
        }
    }
}
