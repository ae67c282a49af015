#include "geometry/laplace_beltrami.hpp"
#include "geometry/normal.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <random>

using namespace vesica;

namespace {

/// q(x) with its gradient, by central differences fine enough for the limit of the continuum.
template <class Function>
Vec3<double> derivative(const Function& q, const Vec3<double>& x, double h) {
    Vec3<double> g;
    for (int a = 0; a < 3; ++a) {
        Vec3<double> up = x;
        Vec3<double> down = x;
        up[a] += h;
        down[a] -= h;
        g[a] = (q(up) - q(down)) / (2.0 * h);
    }
    return g;
}

/// d_j of the components of a vector field.
template <class Vector>
Jacobian<double> derivatives(const Vector& g, const Vec3<double>& x, double h) {
    const auto component = [&](int i) {
        return [&g, i](const Vec3<double>& y) {
            return g(y)[i];
        };
    };
    return {derivative(component(0), x, h), derivative(component(1), x, h), derivative(component(2), x, h)};
}

Vec3<double> random_direction(std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    return unit_vector(Vec3<double>{normal(random), normal(random), normal(random)});
}

constexpr double fine = 1e-4;

} // namespace

TEST_CASE("the tangential part has no component along the normal and keeps the rest", "[geometry]") {
    std::mt19937_64 random(1);
    for (int trial = 0; trial < 50; ++trial) {
        const Vec3<double> n = random_direction(random);
        const Vec3<double> g = 3.0 * random_direction(random);
        const Vec3<double> t = tangential(g, n);
        CHECK(std::abs(dot(t, n)) < 1e-14);
        CHECK(norm(g - t - dot(g, n) * n) < 1e-14);
    }
}

TEST_CASE("on a sphere Lap_s of a spherical harmonic is -l(l+1)/R^2 times itself, in either form",
          "[geometry]") {
    const double R = 3.0;
    std::mt19937_64 random(2);
    // Harmonics of degree 1, 2, 3 made of Cartesian polynomials, constant along the normal.
    const auto harmonic = [](int l, const Vec3<double>& x) {
        const Vec3<double> e = unit_vector(x);
        return l == 1 ? e.z : l == 2 ? e.x * e.y + 0.5 * (3.0 * e.z * e.z - 1.0) : e.x * e.y * e.z;
    };
    for (int l = 1; l <= 3; ++l)
        for (int trial = 0; trial < 10; ++trial) {
            const Vec3<double> n = random_direction(random);
            const Vec3<double> x = R * n;
            const auto q = [&](const Vec3<double>& y) {
                return harmonic(l, y);
            };
            const auto slope = [&](const Vec3<double>& y) {
                return derivative(q, y, fine);
            };
            const auto along = [&](const Vec3<double>& y) {
                return tangential(slope(y), unit_vector(y));
            };
            CHECK(surface_divergence(derivatives(along, x, fine), n) ==
                  Approx(-l * (l + 1) / (R * R) * q(x)).margin(1e-6));
        }
}

TEST_CASE("the divergence form equals the paper's operator in the continuum's limit, for H of any field",
          "[geometry]") {
    // Level sets of an ellipsoidal distance-like function; H varies along and across them.
    const auto level = [](const Vec3<double>& x) {
        return std::sqrt(x.x * x.x + x.y * x.y / 1.7 + x.z * x.z / 0.6 + 0.1 * x.x * x.y);
    };
    const double h = 2e-2;
    const auto n_of = [&](const Vec3<double>& x) {
        return unit_vector(derivative(level, x, 1e-5));
    };
    const auto H_of = [&](const Vec3<double>& x) {
        return 0.5 * derivatives(n_of, x, 1e-3).divergence();
    };
    std::mt19937_64 random(3);
    for (int trial = 0; trial < 5; ++trial) {
        const Vec3<double> x = 4.0 * random_direction(random);
        const Vec3<double> n = n_of(x);
        const auto slope = [&](const Vec3<double>& y) {
            return derivative(H_of, y, h);
        };
        const auto along = [&](const Vec3<double>& y) {
            return tangential(slope(y), n_of(y));
        };
        const double divergence_form = surface_divergence(derivatives(along, x, h), n);
        const Jacobian<double> second = derivatives(slope, x, h);
        const double paper_form = paper_laplace_beltrami(second.divergence(), second, slope(x), n, H_of(x));
        CHECK(std::abs(slope(x).x) > 1e-4); // not trivially zero
        CHECK(paper_form == Approx(divergence_form).epsilon(1e-3).margin(1e-6));
    }
}

TEST_CASE("on a cylinder Lap_s of cos(m theta) cos(k z) is -(m^2/R^2 + k^2) times itself", "[geometry]") {
    const double R = 2.5;
    const auto q = [](const Vec3<double>& x) {
        return std::cos(3.0 * std::atan2(x.y, x.x)) * std::cos(0.8 * x.z);
    };
    for (const double angle : {0.1, 1.3, 2.9}) {
        const Vec3<double> x{R * std::cos(angle), R * std::sin(angle), 0.4};
        const auto n_of = [](const Vec3<double>& y) {
            return unit_vector(Vec3<double>{y.x, y.y, 0.0});
        };
        const auto along = [&](const Vec3<double>& y) {
            return tangential(derivative(q, y, fine), n_of(y));
        };
        CHECK(surface_divergence(derivatives(along, x, fine), n_of(x)) ==
              Approx(-(9.0 / (R * R) + 0.64) * q(x)).margin(1e-5));
    }
}

TEST_CASE("from any parallel surface the flux gives Lap_s on phi = 0: sphere and cylinder", "[geometry]") {
    const double R = 4.0;
    for (const double s : {-1.0, 0.0, 0.7}) {
        const auto lap_on_mid_surface = [&](const auto& q, const auto& n_of, const Vec3<double>& x) {
            const auto G_of = [&](const Vec3<double>& y) {
                return derivatives(n_of, y, 1e-5);
            };
            const auto J_of = [&](const Vec3<double>& y) {
                const Jacobian<double> G = G_of(y);
                const Vec3<double> n = n_of(y);
                const double H = 0.5 * G.divergence();
                const double K = n.z == 0.0 ? 0.0 : H * H; // cylinder and sphere
                return 1.0 - 2.0 * s * H + s * s * K;
            };
            const auto flux = [&](const Vec3<double>& y) {
                const Vec3<double> n = n_of(y);
                const Jacobian<double> G = G_of(y);
                return flux_on_mid_surface(tangential(derivative(q, y, fine), n), G, n, s,
                                           0.5 * G.divergence(), J_of(y));
            };
            return surface_divergence(derivatives(flux, x, 1e-3), n_of(x)) / J_of(x);
        };
        const auto on_sphere = [](const Vec3<double>& y) {
            const Vec3<double> e = unit_vector(y);
            return e.x * e.y * e.z; // l = 3
        };
        const Vec3<double> direction = unit_vector(Vec3<double>{1.0, -0.7, 0.4});
        const Vec3<double> x = (R + s) * direction;
        CHECK(lap_on_mid_surface(
                  on_sphere, [](const Vec3<double>& y) { return unit_vector(y); }, x) ==
              Approx(-12.0 / (R * R) * on_sphere(x)).epsilon(1e-4));

        const auto on_cylinder = [](const Vec3<double>& y) {
            return std::cos(3.0 * std::atan2(y.y, y.x)) * std::cos(0.8 * y.z);
        };
        const Vec3<double> c{(R + s) * std::cos(0.3), (R + s) * std::sin(0.3), 0.4};
        CHECK(lap_on_mid_surface(
                  on_cylinder,
                  [](const Vec3<double>& y) {
                      return unit_vector(Vec3<double>{y.x, y.y, 0.0});
                  },
                  c) == Approx(-(9.0 / (R * R) + 0.64) * on_cylinder(c)).epsilon(1e-4));
    }
}
