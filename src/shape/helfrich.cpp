#include "shape/helfrich.hpp"

#include "core/input_error.hpp"
#include "shape/gauss_legendre.hpp"
#include "shape/helfrich_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>
#include <vector>

namespace vesica {
namespace {

using std::numbers::pi;

constexpr int pieces = 1024;

/// psi(s) = pi s/L + sum_n a_n sin(n pi s/L), the angle of the tangent: r' = cos psi, z' = -sin psi.
struct TangentAngle {
    double length = pi;
    std::vector<double> a; ///< a[n - 1] belongs to the harmonic n

    struct Value {
        double psi;
        double slope;
    };
    Value operator()(double s) const {
        // Rotation by the angle once per harmonic, instead of a sine and a cosine each.
        const double angle = pi * s / length;
        const double c = std::cos(angle), d = std::sin(angle);
        double cosine = 1.0, sine = 0.0;
        Value value{angle, 1.0};
        for (std::size_t n = 1; n <= a.size(); ++n) {
            const double next = cosine * c - sine * d;
            sine = sine * c + cosine * d;
            cosine = next;
            value.psi += a[n - 1] * sine;
            value.slope += a[n - 1] * static_cast<double>(n) * cosine;
        }
        value.slope *= pi / length;
        return value;
    }
};

/// Points of the curve at equal arc lengths, by Gauss-Legendre quadrature of the tangent from piece to piece.
std::vector<MeridianPoint> integrate(const TangentAngle& psi, int count) {
    const double step = psi.length / count;
    std::vector<MeridianPoint> points;
    points.reserve(static_cast<std::size_t>(count) + 1);
    double r = 0.0, z = 0.0;
    for (int i = 0; i <= count; ++i) {
        const double s = step * i;
        const auto [angle, slope] = psi(s);
        const double c = std::cos(angle), d = std::sin(angle);
        points.push_back({r, z, c, -d, -d * slope, -c * slope});
        if (i == count)
            break;
        for (const auto& [position, weight] : gauss_legendre_8()) {
            const double inner = psi(s + step * position).psi;
            r += step * weight * std::cos(inner);
            z -= step * weight * std::sin(inner);
        }
    }
    return points;
}

struct Defect {
    double closure; ///< r at the south pole, which must vanish
    double reduced_volume;
};

Defect measure(const TangentAngle& psi) {
    const std::vector<MeridianPoint> points = integrate(psi, pieces);
    const double closure = points.back().r;
    const Meridian meridian(points, psi.length);
    return {closure, 6.0 * std::sqrt(pi) * meridian.volume() / std::pow(meridian.area(), 1.5)};
}

/// A variable in which the coefficients are smooth: amplitudes grow like the square root of the distance from
/// the sphere, and likewise from the fold near v = .6625 where the stomatocytes' branch turns back.
double smooth_variable(HelfrichBranch branch, double v) {
    return std::sqrt(std::max(0.0, (branch == HelfrichBranch::stomatocyte ? 0.6625 : 1.0) - v));
}

/// Cubic interpolation in the four nearest entries; the sphere is an entry of both branches that end in it.
TangentAngle interpolate(HelfrichBranch branch, double x) {
    const HelfrichBranchTable table = helfrich_table(branch);
    std::vector<HelfrichEntry> entries(table.entries.begin(), table.entries.end());
    if (branch != HelfrichBranch::stomatocyte)
        entries.insert(entries.begin(), HelfrichEntry{1.0, pi, {}});
    std::vector<double> knots;
    for (const HelfrichEntry& entry : entries)
        knots.push_back(smooth_variable(branch, entry.reduced_volume));

    const auto above = std::upper_bound(knots.begin(), knots.end(), x) - knots.begin();
    const auto first = static_cast<std::size_t>(
        std::clamp<std::ptrdiff_t>(above - 2, 0, static_cast<std::ptrdiff_t>(knots.size()) - 4));
    TangentAngle result{0.0, {}};
    for (std::size_t i = first; i < first + 4; ++i) {
        double weight = 1.0;
        for (std::size_t j = first; j < first + 4; ++j)
            if (j != i)
                weight *= (x - knots[j]) / (knots[i] - knots[j]);
        const auto stride = static_cast<std::size_t>(table.stride);
        const auto& coefficients = entries[i].coefficients;
        if (result.a.size() < coefficients.size() * stride)
            result.a.resize(coefficients.size() * stride, 0.0);
        for (std::size_t k = 0; k < coefficients.size(); ++k)
            result.a[stride * (k + 1) - 1] += weight * coefficients[k];
        result.length += weight * entries[i].length;
    }
    return result;
}

std::string_view name(HelfrichBranch branch) {
    switch (branch) {
    case HelfrichBranch::discocyte:
        return "discocyte";
    case HelfrichBranch::prolate:
        return "prolate";
    case HelfrichBranch::stomatocyte:
        return "stomatocyte";
    }
    return {};
}

} // namespace

ReducedVolumeRange helfrich_range(HelfrichBranch branch) {
    const auto entries = helfrich_table(branch).entries;
    const bool ends_in_sphere = branch != HelfrichBranch::stomatocyte;
    return {entries.back().reduced_volume, ends_in_sphere ? 1.0 : entries.front().reduced_volume};
}

Meridian helfrich_meridian(const HelfrichShape& shape) {
    const auto [lowest, highest] = helfrich_range(shape.branch);
    const double v = shape.reduced_volume;
    if (!(v >= lowest && v <= highest))
        throw InputError(
            fmt::format("reduced_volume is {}; expected {} to {} for the shape \"{}\"; try a value in "
                        "that range or another shape",
                        v, lowest, highest, name(shape.branch)));

    // Newton's method in the place on the branch and the first harmonic: the curve must close (automatic
    // where there is a mirror plane) and have the reduced volume asked for.
    const bool mirror = helfrich_table(shape.branch).stride == 2;
    double x = smooth_variable(shape.branch, v);
    double first = 0.0;
    const auto curve = [&](double place, double shift) {
        TangentAngle psi = interpolate(shape.branch, place);
        if (!mirror)
            psi.a[0] += shift;
        return psi;
    };
    if (v < 1.0) {
        for (int iteration = 0; iteration < 8; ++iteration) {
            const Defect here = measure(curve(x, first));
            const double missing = v - here.reduced_volume;
            if (std::abs(missing) < 1e-13 && std::abs(here.closure) < 1e-13)
                break;
            constexpr double h = 1e-5;
            const Defect along = measure(curve(x + h, first));
            const double volume_x = (along.reduced_volume - here.reduced_volume) / h;
            if (mirror) {
                x += missing / volume_x;
                continue;
            }
            const Defect across = measure(curve(x, first + h));
            const double closure_x = (along.closure - here.closure) / h;
            const double closure_a = (across.closure - here.closure) / h;
            const double volume_a = (across.reduced_volume - here.reduced_volume) / h;
            const double determinant = volume_x * closure_a - volume_a * closure_x;
            x += (missing * closure_a + here.closure * volume_a) / determinant;
            first -= (here.closure * volume_x + missing * closure_x) / determinant;
        }
    }
    const TangentAngle psi = curve(x, first);
    return Meridian(integrate(psi, pieces), psi.length).normalised(std::cbrt(v));
}

} // namespace vesica
