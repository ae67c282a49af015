#include "shape/directions.hpp"
#include "shape/helfrich.hpp"
#include "shape/perturbation.hpp"
#include "shape/perturbed_shape.hpp"
#include "shape/spheroid.hpp"

#include <catch2/catch.hpp>

#include <numbers>

using namespace vesica;
using std::numbers::pi;

namespace {

PerturbedShape perturbed_sphere(double radius, std::vector<Perturbation> perturbations) {
    return PerturbedShape(std::make_unique<Spheroid>(radius, 1.0), harmonic_series(perturbations), radius);
}

} // namespace

TEST_CASE("A perturbed sphere's distance vanishes on R (1 + a Y), scaled to the volume") {
    // The volume of r = R (1 + a P_2): (4 pi/3) R^3 (1 + 3 a^2/5 + 2 a^3/35).
    const double a = 0.1, R = 15.0 / std::cbrt(1.0 + 0.6 * a * a + 2.0 / 35.0 * a * a * a);
    const PerturbedShape shape = perturbed_sphere(15.0, {HarmonicPerturbation{2, 0, a}});
    for (const Vec3<double>& u : directions(200))
        CHECK(shape.signed_distance(R * (1.0 + a * (1.5 * u.z * u.z - 0.5)) * u) ==
              Approx(0.0).margin(1e-10));
    CHECK(shape.signed_distance({0.0, 0.0, R * (1.0 + a) + 0.4}) == Approx(0.4).margin(1e-10));
    CHECK(shape.signed_distance({R * (1.0 - a / 2.0) - 0.4, 0.0, 0.0}) == Approx(-0.4).margin(1e-10));
}

TEST_CASE("A slightly perturbed sphere's area grows as second-order theory says") {
    // A = 4 pi R^2 (1 + (l - 1)(l + 2)/2 <Y^2>) at equal volume, to second order in the amplitude; <Y^2> =
    // a^2/(2l + 1).
    for (const int l : {2, 3, 5}) {
        const double a = 1e-3;
        const PerturbedShape shape = perturbed_sphere(15.0, {HarmonicPerturbation{l, 1, a}});
        const double excess = shape.area() / (4.0 * pi * 225.0) - 1.0;
        CHECK(excess == Approx(0.5 * (l - 1) * (l + 2) * a * a / (2 * l + 1)).epsilon(5e-3));
    }
}

TEST_CASE("A perturbed sphere's sharpest curvature is that of linear theory") {
    // kappa R = 1 - y - (second derivative of y along the sphere); at the pole of P_2, y'' = -3 a: 1 + 2 a.
    const double a = 1e-3;
    const PerturbedShape shape = perturbed_sphere(15.0, {HarmonicPerturbation{2, 0, a}});
    CHECK(15.0 / shape.smallest_radius_of_curvature() == Approx(1.0 + 2.0 * a).margin(2e-5));
}

TEST_CASE("The distance to a perturbed shape has gradient one, and a step along it changes it by the step") {
    const auto check = [](const PerturbedShape& shape) {
        int tested = 0;
        for (const Vec3<double>& u : directions(150)) {
            const Vec3<double> x = (12.0 + 6.0 * std::abs(u.x)) * u;
            const double s = shape.signed_distance(x);
            if (s < -1.5 || s > 6.0)
                continue;
            ++tested;
            const Vec3<double> n = distance_gradient(shape, x, 1e-3);
            CHECK(norm(n) == Approx(1.0).margin(2e-6));
            CHECK(shape.signed_distance(x - s * n) == Approx(0.0).margin(1e-5)); // the foot; n by differences
            CHECK(shape.signed_distance(x + 1.5 * n) == Approx(s + 1.5).margin(1e-5));
        }
        CHECK(tested > 30);
    };
    check(perturbed_sphere(15.0, {RandomPerturbation{2, 6, 0.03, 5}}));
    check(PerturbedShape(std::make_unique<Spheroid>(15.0, 0.6),
                         harmonic_series(std::vector<Perturbation>{HarmonicPerturbation{3, -2, 0.05}}),
                         15.0));
    check(PerturbedShape(std::make_unique<AxisymmetricShape>(
                             helfrich_meridian({HelfrichBranch::prolate, 0.8}).normalised(15.0)),
                         harmonic_series(std::vector<Perturbation>{HarmonicPerturbation{2, 2, 0.03}}), 15.0));
}

TEST_CASE("A perturbed shape has its volume, and its centre where the distance is negative") {
    const PerturbedShape shape =
        perturbed_sphere(12.0, {HarmonicPerturbation{3, 0, 0.1}, HarmonicPerturbation{2, 1, 0.1},
                                HarmonicPerturbation{1, 1, 0.08}});
    const VoxelMoments moments = voxel_moments(shape, 18.0, 0.75);
    CHECK(moments.volume == Approx(4.0 * pi / 3.0 * 1728.0).epsilon(5e-4));
    CHECK(norm(moments.centre) < 5e-3);
    CHECK(shape.volume() == Approx(4.0 * pi / 3.0 * 1728.0).epsilon(1e-12));
}

TEST_CASE("Without amplitude the perturbed shape is the shape itself, from its centre to far outside") {
    HarmonicSeries nothing;
    nothing.add(2, 0, 0.0);
    for (const double aspect : {1.0, 0.5}) {
        const PerturbedShape shape(std::make_unique<Spheroid>(15.0, aspect), nothing, 15.0);
        const Spheroid plain(15.0, aspect);
        for (const Vec3<double>& u : directions(40))
            for (const double r : {4.0, 9.0, 14.0, 15.0, 18.0, 25.0}) {
                const double s = plain.signed_distance(r * u);
                CHECK(shape.signed_distance(r * u) == Approx(s).margin(1e-10));
            }
        CHECK(shape.signed_distance({0.0, 0.0, 0.0}) ==
              Approx(plain.signed_distance({0.0, 0.0, 0.0})).margin(0.02));
        CHECK(shape.signed_distance({100.0, 0.0, 0.0}) > Shape::reach);
        CHECK(shape.area() == Approx(plain.area()).epsilon(1e-10));
        CHECK(shape.smallest_radius_of_curvature() ==
              Approx(plain.smallest_radius_of_curvature()).epsilon(2e-3));
    }
}
