#include "core/input_error.hpp"
#include "exact_field.hpp"
#include "measure/centre_tracker.hpp"
#include "measure/metrics.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

using namespace vesica;

namespace {

Snapshot one_vesicle(const Vec3<double>& centre = {20.2, 19.9, 20.4}) {
    Snapshot snapshot;
    snapshot.step = 1200;
    snapshot.max_speed = 0.03;
    snapshot.reference_density = 1.5;
    const exact::Spheroid shape{centre, 10.0, 8.0};
    snapshot.vesicles.push_back(exact::snapshot_of(shape, {20, 20, 20}, 28));
    VesicleSnapshot& vesicle = snapshot.vesicles.front();
    vesicle.target_area = 0.5 * shape.area();
    vesicle.tension = -0.004;
    vesicle.colour_mass = 4000.0;
    vesicle.momentum = {4.0, -8.0, 0.0};
    return snapshot;
}

} // namespace

TEST_CASE("a row of the metrics has the promised columns in the promised order", "[measure]") {
    const std::vector<std::string> promised = {"step",
                                               "time",
                                               "vesicle",
                                               "area",
                                               "area_ratio",
                                               "volume",
                                               "reduced_volume",
                                               "bending_energy",
                                               "mean_curvature_integral",
                                               "gaussian_curvature_over_pi",
                                               "inertia_1",
                                               "inertia_2",
                                               "inertia_3",
                                               "x",
                                               "y",
                                               "z",
                                               "vx",
                                               "vy",
                                               "vz",
                                               "deformation_index",
                                               "taylor_deformation",
                                               "inclination",
                                               "tension",
                                               "max_speed",
                                               "mass_drift",
                                               "gap",
                                               "tank_treading_frequency",
                                               "particle_stress",
                                               "effective_viscosity",
                                               "wall_stress"};
    CHECK(metrics_columns() == promised);
    const Snapshot snapshot = one_vesicle();
    const MetricsRow row = measure(snapshot.vesicles[0], snapshot, baseline_of(snapshot.vesicles[0], 0));
    const std::vector<double> values = metrics_values(row);
    REQUIRE(values.size() == promised.size());
    for (std::size_t i = 0; i < promised.size(); ++i) {
        const double by_name = metrics_value(row, promised[i]);
        CHECK((by_name == values[i] || (std::isnan(by_name) && std::isnan(values[i]))));
    }
}

TEST_CASE("an unknown quantity is refused with the list of the known ones", "[measure]") {
    CHECK_THROWS_AS(require_metrics_column("bending"), InputError);
    CHECK_THROWS_WITH(metrics_value(MetricsRow{}, "bending"),
                      Catch::Matchers::Contains("\"bending\"") &&
                          Catch::Matchers::Contains("bending_energy") && Catch::Matchers::Contains("gap"));
    CHECK_NOTHROW(require_metrics_column("bending_energy"));
}

TEST_CASE("the metrics of a spheroid are those of the sharp body", "[measure]") {
    const Snapshot snapshot = one_vesicle();
    const VesicleSnapshot& vesicle = snapshot.vesicles[0];
    const exact::Spheroid shape{{20.2, 19.9, 20.4}, 10.0, 8.0};
    MetricsBaseline baseline{2, 4004.0, 16.0, {}};
    const MetricsRow row = measure(vesicle, snapshot, baseline);
    CHECK(row.step == 1200.0);
    CHECK(row.time == 1200.0);
    CHECK(row.vesicle == 2.0);
    CHECK(row.area == Approx(shape.area()).epsilon(2e-4));
    CHECK(row.area_ratio == Approx(2.0).epsilon(2e-4));
    CHECK(row.volume == Approx(shape.volume()).epsilon(2e-4));
    CHECK(row.gaussian_curvature_over_pi == Approx(4.0).epsilon(1e-3));
    CHECK(row.inertia_1 == Approx(1.5 * 0.4 * 64.0 * shape.volume()).epsilon(1e-3));
    CHECK(row.inertia_3 == Approx(1.5 * 0.2 * 164.0 * shape.volume()).epsilon(1e-3));
    CHECK(row.x == Approx(20.2).epsilon(1e-5));
    CHECK(row.z == Approx(20.4).epsilon(1e-5));
    CHECK(row.vx == 0.001);
    CHECK(row.vy == -0.002);
    CHECK(row.deformation_index == Approx((1.5625 - 1.0) / 2.5625).epsilon(1e-2));
    CHECK(row.taylor_deformation == Approx(1.0 / 9.0).epsilon(2e-3));
    CHECK(std::isnan(row.inclination));
    CHECK(row.tension == -0.004);
    CHECK(row.max_speed == 0.03);
    CHECK(row.mass_drift == Approx(-4.0 / 4004.0));
    CHECK(std::isnan(row.gap));
    baseline.shear_plane = ShearPlane{{1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}};
    CHECK(std::abs(measure(vesicle, snapshot, baseline).inclination) == Approx(90.0).margin(0.01));
}

TEST_CASE("the metrics do not depend on the order in which threads list the cells", "[measure]") {
    Snapshot snapshot = one_vesicle();
    const MetricsBaseline baseline = baseline_of(snapshot.vesicles[0], 0);
    const auto reference = metrics_values(measure(snapshot.vesicles[0], snapshot, baseline));
    std::mt19937_64 random(1);
    const Vec3<double> first = snapshot.vesicles[0].cells.front().position;
    std::shuffle(snapshot.vesicles[0].cells.begin(), snapshot.vesicles[0].cells.end(), random);
    std::shuffle(snapshot.vesicles[0].inside.begin(), snapshot.vesicles[0].inside.end(), random);
    CHECK(snapshot.vesicles[0].cells.front().position != first);
    const auto shuffled = metrics_values(measure(snapshot.vesicles[0], snapshot, baseline));
    for (std::size_t i = 0; i < reference.size(); ++i) {
        CAPTURE(metrics_columns()[i], shuffled[i], reference[i]);
        CHECK((shuffled[i] == reference[i] || (std::isnan(shuffled[i]) && std::isnan(reference[i]))));
    }
}

TEST_CASE("a centre is followed through periodic boundaries without jumps", "[measure]") {
    CentreTracker tracker({40.0, 0.0, 30.0});
    Vec3<double> exact{35.0, 10.0, 5.0};
    const auto wrap = [](double x, double period) {
        return x - period * std::floor(x / period);
    };
    for (int i = 0; i < 200; ++i) {
        const Vec3<double> seen{wrap(exact.x, 40.0), exact.y, wrap(exact.z, 30.0)};
        const Vec3<double> followed = tracker.follow(seen);
        REQUIRE(norm(followed - exact) < 1e-11);
        exact = exact + Vec3<double>{3.0, 50.0, -4.0};
    }
    // Where the box slides, a box downwards is also the way the images have slid since.
    CentreTracker sliding({40.0, 20.0, 30.0});
    sliding.follow({10.0, 5.0, 29.5}, SlidingImages{2, 0, 3.0, 0.1});
    const Vec3<double> above = sliding.follow({6.6, 5.0, 0.5}, SlidingImages{2, 0, 3.5, 0.1});
    CHECK(above.x == Approx(10.1));
    CHECK(above.z == Approx(30.5));
    CHECK(sliding.boxes_slid() == 1.0);
    CHECK(sliding.follow({6.7, 5.0, 0.9}, SlidingImages{2, 0, 45.0, 0.1}).x == Approx(11.7)); // less a box

    CentreTracker resumed({40.0, 0.0, 30.0});
    resumed.restore(tracker.last());
    CHECK(norm(resumed.follow({wrap(exact.x, 40.0), exact.y, wrap(exact.z, 30.0)}) - exact) < 1e-11);
}
