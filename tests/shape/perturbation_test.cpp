#include "core/input_error.hpp"
#include "shape/directions.hpp"
#include "shape/perturbation.hpp"

#include <catch2/catch.hpp>

using namespace vesica;

namespace {

HarmonicSeries series_of(std::vector<Perturbation> perturbations) {
    return harmonic_series(perturbations);
}

} // namespace

TEST_CASE("Perturbations add up") {
    const HarmonicSeries sum =
        series_of({HarmonicPerturbation{2, 0, 0.1}, HarmonicPerturbation{1, 1, -0.05}});
    for (const Vec3<double>& u : directions(20))
        CHECK(sum(u).value == Approx(0.1 * (1.5 * u.z * u.z - 0.5) - 0.05 * u.x).margin(1e-15));
    CHECK(series_of({}).empty());
}

TEST_CASE("A random perturbation has the amplitude asked for and only the degrees asked for") {
    const HarmonicSeries series = series_of({RandomPerturbation{2, 6, 0.03, 42}});
    CHECK(series.root_mean_square() == Approx(0.03).epsilon(1e-13));
    CHECK(series.highest() == 6);
    double mean = 0.0;
    for (const Vec3<double>& u : directions(2000))
        mean += series(u).value / 2000.0;
    CHECK(mean == Approx(0.0).margin(1e-5));
}

TEST_CASE("A seed means the same perturbation everywhere") {
    // Computed from the definitions of the generator, the transform and the harmonics by another program.
    const Vec3<double> u{2.0 / 7.0, -3.0 / 7.0, 6.0 / 7.0};
    CHECK(series_of({RandomPerturbation{2, 6, 0.03, 42}})(u).value ==
          Approx(0.019594672933778645).epsilon(1e-12));
    CHECK(series_of({RandomPerturbation{2, 6, 0.03, 43}})(u).value !=
          Approx(0.019594672933778645).epsilon(1e-3));
}

TEST_CASE("Perturbations that make no sense are refused") {
    CHECK_THROWS_WITH(
        series_of({HarmonicPerturbation{0, 0, 0.1}}),
        "perturbation.l is 0; expected 1 to 32; try 2 (l = 0 would only change the size, which radius "
        "fixes)");
    CHECK_THROWS_WITH(series_of({HarmonicPerturbation{2, -3, 0.1}}),
                      "perturbation.m is -3; expected -l to l, that is -2 to 2; try 0");
    CHECK_THROWS_WITH(series_of({RandomPerturbation{4, 3, 0.1, 1}}),
                      "perturbation.l is [4, 3]; expected [lowest, highest] within 1 to 32; try [2, 6]");
    CHECK_THROWS_WITH(series_of({HarmonicPerturbation{2, 0, std::nan("")}}),
                      "perturbation.amplitude is nan; expected a finite number; try 0.01");
    CHECK_THROWS_WITH(
        series_of({HarmonicPerturbation{2, 0, -1.1}}),
        "perturbation changes the radius by down to -1.1 of itself; expected no less than -0.9, so "
        "that the surface keeps clear of the vesicle's centre; try smaller amplitudes");
}
