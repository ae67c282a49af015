#include "measured.hpp"
#include "simulation/exact_layer.hpp"

#include <catch2/catch.hpp>

using namespace vesica;
using namespace vesica::test;

namespace {

constexpr int bins = 24;

/// A torus of tube radius a = R/2 about z.
struct Torus {
    double R;
    double a;

    double H(double theta) const {
        return (R + 2 * a * std::cos(theta)) / (2 * a * (R + a * std::cos(theta)));
    }
    double K(double theta) const { return std::cos(theta) / (a * (R + a * std::cos(theta))); }
    double width(double theta) const { return R + a * std::cos(theta); }
    double laplace_beltrami_of_H(double theta) const {
        constexpr double h = 1e-4;
        const auto flux = [&](double t) {
            return width(t) * (H(t + h) - H(t - h)) / (2 * h);
        };
        return (flux(theta + h) - flux(theta - h)) / (2 * h) / (a * a * width(theta));
    }
    double bending_force(double theta) const {
        return 2 * laplace_beltrami_of_H(theta) + 4 * H(theta) * (H(theta) * H(theta) - K(theta));
    }
};

struct TorusErrors {
    double force =
        0.0; ///< of the pressure jump sustained: rms over bins of the tube angle, over the exact rms
    double area = 0.0;     ///< raw area over 4 pi^2 R a - 1
    double gaussian = 0.0; ///< int K dA/(4 pi)
};

/// The jump is the layer's force carried to the mid-surface by J = dA(0)/dA(s), per area of the mid-surface.
/// Averaged over positions of the torus between lattice planes: a bin holds few of them.
TorusErrors measure_torus(double R, GeometryRecipe recipe) {
    const Torus torus{R, R / 2};
    const int width = static_cast<int>(std::ceil(2 * (1.5 * R + 10) / 8)) * 8;
    const int height = static_cast<int>(std::ceil(2 * (0.5 * R + 10) / 8)) * 8;
    constexpr int places = 6;
    double force[bins] = {};
    TorusErrors errors;
    for (int q = 0; q < places; ++q) {
        const Vec3<double> centre{width / 2.0 + 0.13 + 0.31 * q, width / 2.0 - 0.21 + 0.17 * q,
                                  height / 2.0 + (q + 0.5) / places};
        const auto r_of = [&](const Vec3<double>& x) {
            return x - centre;
        };
        const auto angles = [&](const Vec3<double>& x) {
            const Vec3<double> r = x - centre;
            return std::pair{std::atan2(r.z, std::hypot(r.x, r.y) - R), std::atan2(r.y, r.x)};
        };
        Membrane membrane;
        membrane.bending = HelfrichLaw{1.0, 0.0};
        LayerSettings settings;
        settings.recipe = recipe;
        const Layer<double> layer = exact_layer(
            {width, width, height},
            [&](const Vec3<double>& x) {
                const Vec3<double> r = x - centre;
                return std::hypot(std::hypot(r.x, r.y) - R, r.z) - torus.a;
            },
            membrane, settings);
        for_each_force(layer, [&](const Vec3<double>& x, const Vec3<double>& F) {
            const auto [theta, azimuth] = angles(x);
            const Vec3<double> n{std::cos(theta) * std::cos(azimuth), std::cos(theta) * std::sin(azimuth),
                                 std::sin(theta)};
            const int bin = std::min(bins - 1, static_cast<int>((theta + pi) / (2 * pi) * bins));
            const double radius = std::hypot(std::hypot(r_of(x).x, r_of(x).y) - R, r_of(x).z);
            const double J = torus.a / radius * torus.width(theta) / (R + radius * std::cos(theta));
            force[bin] += J * dot(F, n) / places;
        });
        errors.area += (layer.sums(0).raw_area / (4 * pi * pi * R * torus.a) - 1.0) / places;
        errors.gaussian += layer.sums(0).gaussian_curvature / (4 * pi) / places;
    }
    double squares = 0.0;
    double exact_squares = 0.0;
    for (int bin = 0; bin < bins; ++bin) {
        constexpr int points = 100;
        double exact = 0.0;
        double area = 0.0;
        for (int k = 0; k < points; ++k) {
            const double theta = -pi + (bin + (k + 0.5) / points) * 2 * pi / bins;
            const double patch = 2 * pi * torus.a * torus.width(theta) * 2 * pi / (bins * points);
            exact += torus.bending_force(theta) * patch;
            area += patch;
        }
        squares += std::pow((force[bin] - exact) / area, 2);
        exact_squares += std::pow(exact / area, 2);
    }
    errors.force = std::sqrt(squares / exact_squares);
    return errors;
}

} // namespace

TEST_CASE("bending force on a torus converges to Helfrich's") {
    const TorusErrors coarse = measure_torus(15.0, GeometryRecipe::mapped);
    const TorusErrors fine = measure_torus(22.5, GeometryRecipe::mapped);
    INFO("errors " << coarse.force << " " << fine.force);
    CHECK(coarse.force < 0.03);
    CHECK(fine.force < 0.015);
    CHECK(std::log(coarse.force / fine.force) / std::log(1.5) > 1.6);
}

TEST_CASE("a torus has its area and no total Gaussian curvature") {
    const TorusErrors errors = measure_torus(15.0, GeometryRecipe::mapped);
    CHECK(std::abs(errors.area) < 1e-4);
    CHECK(std::abs(errors.gaussian) < 0.005);
}

TEST_CASE("on the same torus the paper's geometry gives the force to 10 %, less than half as accurately") {
    const TorusErrors paper = measure_torus(15.0, GeometryRecipe::paper);
    const TorusErrors mapped = measure_torus(15.0, GeometryRecipe::mapped);
    INFO("errors " << paper.force << " " << mapped.force);
    CHECK(paper.force < 0.1);
    CHECK(paper.force > 2.0 * mapped.force);
    CHECK(std::abs(paper.gaussian) < 0.01);
}

TEST_CASE("the error of the bending force on a torus falls from R = 15 to 45 with order 1.6 at least",
          "[.validation]") {
    constexpr double radii[] = {15.0, 22.5, 30.0, 45.0};
    constexpr double bounds[] = {0.03, 0.015, 0.01, 0.005};
    double errors[4];
    for (std::size_t k = 0; k < 4; ++k) {
        const TorusErrors mapped = measure_torus(radii[k], GeometryRecipe::mapped);
        errors[k] = mapped.force;
        CHECK(mapped.force < bounds[k]);
        const std::string conditions = "R = " + std::to_string(radii[k]).substr(0, 4);
        measured("bending force on the torus a = R/2, relative rms error", "mapped, " + conditions,
                 mapped.force);
        measured("raw area of the torus over 4 pi^2 R a, less 1", conditions, mapped.area);
        measured("int K dA of the torus over 4 pi", conditions, mapped.gaussian);
        const TorusErrors paper = measure_torus(radii[k], GeometryRecipe::paper);
        measured("bending force on the torus a = R/2, relative rms error", "paper, " + conditions,
                 paper.force);
    }
    CHECK(std::log(errors[0] / errors[3]) / std::log(3.0) > 1.6);
}
