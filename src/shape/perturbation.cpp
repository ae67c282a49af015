#include "shape/perturbation.hpp"

#include "core/input_error.hpp"
#include "shape/random_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace vesica {
namespace {

constexpr int highest_degree = 32;
constexpr double smallest_factor = 0.1;

void add(HarmonicSeries& series, const HarmonicPerturbation& p) {
    if (p.l < 1 || p.l > highest_degree)
        throw InputError(
            fmt::format("perturbation.l is {}; expected 1 to {}; try 2 (l = 0 would only change the "
                        "size, which radius fixes)",
                        p.l, highest_degree));
    if (std::abs(p.m) > p.l)
        throw InputError(
            fmt::format("perturbation.m is {}; expected -l to l, that is {} to {}; try 0", p.m, -p.l, p.l));
    series.add(p.l, p.m, p.amplitude);
}

void add(HarmonicSeries& series, const RandomPerturbation& p) {
    if (p.lowest < 1 || p.highest < p.lowest || p.highest > highest_degree)
        throw InputError(
            fmt::format("perturbation.l is [{}, {}]; expected [lowest, highest] within 1 to {}; try "
                        "[2, 6]",
                        p.lowest, p.highest, highest_degree));
    RandomNumbers random(p.seed);
    std::vector<double> numbers;
    double mean_square = 0.0;
    for (int l = p.lowest; l <= p.highest; ++l)
        for (int m = -l; m <= l; ++m) {
            numbers.push_back(random.gaussian());
            mean_square += numbers.back() * numbers.back() / (2 * l + 1);
        }
    const double factor = p.amplitude / std::sqrt(mean_square);
    auto number = numbers.begin();
    for (int l = p.lowest; l <= p.highest; ++l)
        for (int m = -l; m <= l; ++m)
            series.add(l, m, factor * *number++);
}

/// The sum's minimum on a grid finer than its shortest wave.
double sampled_minimum(const HarmonicSeries& series) {
    const int rows = 6 * series.highest() + 12;
    double lowest = 0.0;
    for (int i = 0; i <= rows; ++i)
        for (int j = 0; j < 2 * rows; ++j) {
            const double theta = std::numbers::pi * i / rows, azimuth = std::numbers::pi * j / rows;
            const Vec3<double> u{std::sin(theta) * std::cos(azimuth), std::sin(theta) * std::sin(azimuth),
                                 std::cos(theta)};
            lowest = std::min(lowest, series(u).value);
        }
    return lowest;
}

} // namespace

HarmonicSeries harmonic_series(std::span<const Perturbation> perturbations) {
    HarmonicSeries series;
    for (const Perturbation& perturbation : perturbations) {
        const double amplitude = std::visit([](const auto& p) { return p.amplitude; }, perturbation);
        if (!std::isfinite(amplitude))
            throw InputError(
                fmt::format("perturbation.amplitude is {}; expected a finite number; try 0.01", amplitude));
        std::visit([&](const auto& p) { add(series, p); }, perturbation);
    }
    if (series.empty())
        return series;
    const double lowest = sampled_minimum(series);
    if (!(1.0 + lowest >= smallest_factor))
        throw InputError(
            fmt::format("perturbation changes the radius by down to {:.3g} of itself; expected no less "
                        "than {:.3g}, so that the surface keeps clear of the vesicle's centre; try "
                        "smaller amplitudes",
                        lowest, smallest_factor - 1.0));
    return series;
}

} // namespace vesica
