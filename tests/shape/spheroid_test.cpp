#include "shape/directions.hpp"
#include "shape/spheroid.hpp"

#include <catch2/catch.hpp>

#include <numbers>

using namespace vesica;
using std::numbers::pi;

TEST_CASE("A sphere's signed distance is the distance from its centre less its radius") {
    const Spheroid sphere(15.0, 1.0);
    for (const Vec3<double>& u : directions(50))
        for (const double r : {0.0, 1e-9, 3.0, 14.999, 15.0, 15.001, 40.0})
            CHECK(sphere.signed_distance(r * u) == Approx(r - 15.0).margin(1e-12));
    CHECK(sphere.volume() == Approx(4.0 * pi / 3.0 * 3375.0).epsilon(1e-12));
    CHECK(sphere.area() == Approx(4.0 * pi * 225.0).epsilon(1e-12));
    CHECK(sphere.smallest_radius_of_curvature() == Approx(15.0).epsilon(1e-8));
}

TEST_CASE("A point lifted off a spheroid along its normal is that far away") {
    for (const double aspect : {0.1, 0.4, 1.0, 2.5, 10.0}) {
        const double a = 15.0 / std::cbrt(aspect), c = aspect * a;
        const Spheroid spheroid(15.0, aspect);
        const double smallest = spheroid.smallest_radius_of_curvature();
        for (int i = 0; i <= 40; ++i) {
            const double t = pi * i / 40.0;
            const double r = a * std::sin(t), z = c * std::cos(t);
            const double scale = std::hypot(r / (a * a), z / (c * c));
            const double nr = r / (a * a) / scale, nz = z / (c * c) / scale;
            for (const double s : {-0.99 * smallest, -1e-3, 0.0, 1e-3, 2.0, 30.0}) {
                const Vec3<double> x{0.6 * (r + s * nr), 0.8 * (r + s * nr), z + s * nz};
                CHECK(spheroid.signed_distance(x) == Approx(s).margin(1e-11));
            }
        }
    }
}

TEST_CASE("On a spheroid's axis, in its equator and in its centre the distance is the textbook's") {
    const double a = 20.0, c = 10.0; // oblate: the centre is closest to the poles
    const Spheroid oblate(std::cbrt(a * a * c), 0.5);
    CHECK(oblate.signed_distance({0.0, 0.0, 0.0}) == Approx(-c).epsilon(1e-14));
    CHECK(oblate.signed_distance({0.0, 0.0, 4.0}) == Approx(-6.0).epsilon(1e-14));
    CHECK(oblate.signed_distance({25.0, 0.0, 0.0}) == Approx(5.0).epsilon(1e-14));
    // Inside the focal disc the closest point is off the equator: x = a^2 p/(a^2 - c^2), d^2 = c^2 (1 -
    // p^2/(a^2 - c^2)).
    CHECK(oblate.signed_distance({0.0, 5.0, 0.0}) ==
          Approx(-c * std::sqrt(1.0 - 25.0 / 300.0)).epsilon(1e-13));
    CHECK(oblate.signed_distance({0.0, 5.0, 1e-13}) ==
          Approx(-c * std::sqrt(1.0 - 25.0 / 300.0)).epsilon(1e-12));
    const Spheroid prolate(std::cbrt(10.0 * 10.0 * 20.0), 2.0);
    CHECK(prolate.signed_distance({0.0, 0.0, 0.0}) == Approx(-10.0).epsilon(1e-14));
    CHECK(prolate.signed_distance({0.0, 0.0, -23.0}) == Approx(3.0).epsilon(1e-14));
}

TEST_CASE("A spheroid has the closed forms' volume, area and sharpest curvature") {
    const double a = 20.0, c = 10.0, e = std::sqrt(1.0 - c * c / (a * a));
    const Spheroid oblate(std::cbrt(a * a * c), c / a);
    CHECK(oblate.volume() == Approx(4.0 * pi / 3.0 * a * a * c).epsilon(1e-12));
    CHECK(oblate.area() ==
          Approx(2.0 * pi * a * a * (1.0 + (1.0 - e * e) / e * std::atanh(e))).epsilon(1e-12));
    CHECK(oblate.smallest_radius_of_curvature() == Approx(c * c / a).epsilon(1e-8));

    const double p = 10.0, q = 20.0, g = std::sqrt(1.0 - p * p / (q * q));
    const Spheroid prolate(std::cbrt(p * p * q), q / p);
    CHECK(prolate.area() == Approx(2.0 * pi * p * p * (1.0 + q / (p * g) * std::asin(g))).epsilon(1e-12));
    CHECK(prolate.smallest_radius_of_curvature() == Approx(p * p / q).epsilon(1e-8));
}

TEST_CASE("The search along a sampled meridian finds the ellipse's closest points") {
    const Spheroid spheroid(15.0, 0.3);
    for (const Vec3<double>& u : directions(200))
        for (const double r : {0.7, 6.0, 12.0, 20.0, 33.0}) {
            const double rho = r * std::hypot(u.x, u.y), z = r * u.z;
            CHECK(spheroid.meridian().closest(rho, z).distance ==
                  Approx(spheroid.closest(rho, z).distance).margin(1e-11));
        }
}
