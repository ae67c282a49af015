#include "measured.hpp"
#include "shape/axisymmetric_shape.hpp"
#include "shape/helfrich.hpp"
#include "shape/placed_shape.hpp"
#include "simulation/exact_layer.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>
#include <vector>

using namespace vesica;
using namespace vesica::test;

namespace {

/// What one point of a discocyte's meridian looks like, and the exact bending force there (kappa = 1).
struct MeridianState {
    double r = 0.0;
    double meridional = 0.0;
    double azimuthal = 0.0;
    double bending_force = 0.0;
    double area = 0.0; ///< of the ring that the point stands for, in both halves
};

/// The upper half of the meridian, from the pole to the rim: r grows.
std::vector<MeridianState> upper_half(const Meridian& meridian) {
    constexpr int points = 4000;
    const double quarter = 0.5 * meridian.length();
    const double h = meridian.length() / 400.0;
    const auto H = [&](double t) {
        const MeridianPoint point = meridian.at(std::abs(t)); // even about the pole
        return 0.5 * (point.meridional_curvature() + point.azimuthal_curvature());
    };
    const auto flux = [&](double t) {
        const MeridianPoint point = meridian.at(t);
        return point.r * (H(t + h) - H(t - h)) / (2 * h) / point.speed();
    };
    std::vector<MeridianState> states;
    for (int k = 0; k < points; ++k) {
        const double t = quarter * (k + 0.5) / points;
        const MeridianPoint point = meridian.at(t);
        const double around = std::max(t, 2.0 * h); // a difference needs some room beside the pole
        const MeridianPoint there = meridian.at(around);
        const double laplacian = (flux(around + h) - flux(around - h)) / (2 * h) / (there.r * there.speed());
        const double mean = H(around);
        const double gaussian = there.meridional_curvature() * there.azimuthal_curvature();
        states.push_back({point.r, point.meridional_curvature(), point.azimuthal_curvature(),
                          2 * laplacian + 4 * mean * (mean * mean - gaussian),
                          2 * 2 * pi * point.r * point.speed() * quarter / points});
    }
    return states;
}

/// How well the layer sustains the bending force of the discocyte v = .65: rms over bins of the distance from
/// the axis of its pressure jump's error, over the exact rms.
double force_error(double radius, const Vec3<double>& offset, const Vec3<double>& axis) {
    constexpr int bins = 16;
    const AxisymmetricShape shape(
        helfrich_meridian(HelfrichShape{HelfrichBranch::discocyte, 0.65}).normalised(radius));
    const std::vector<MeridianState> meridian = upper_half(shape.meridian());
    const double widest = meridian.back().r;
    const int edge = static_cast<int>(std::ceil((2.0 * shape.bounding_radius() + 20.0) / 8)) * 8;
    const Vec3<double> centre = Vec3<double>{0.5 * edge, 0.5 * edge, 0.5 * edge} + offset;
    const Frame frame = Frame::along(axis);
    Membrane membrane;
    membrane.bending = HelfrichLaw{1.0, 0.0};
    const auto components = [&](const Vec3<double>& x) {
        return frame.components(x - centre);
    };
    const Layer<double> layer = exact_layer(
        {edge, edge, edge}, [&](const Vec3<double>& x) { return shape.signed_distance(components(x)); },
        membrane);
    const auto bin_of = [&](double r) {
        return std::min(bins - 1, static_cast<int>(bins * r / widest));
    };
    double found[bins] = {};
    double exact[bins] = {};
    double area[bins] = {};
    for (const MeridianState& state : meridian) {
        exact[bin_of(state.r)] += state.bending_force * state.area;
        area[bin_of(state.r)] += state.area;
    }
    for_each_force(layer, [&](const Vec3<double>& x, const Vec3<double>& F) {
        const Vec3<double> place = components(x);
        const Foot foot = shape.foot(place);
        const Vec3<double> on_surface = place - foot.distance * foot.normal;
        const double r = std::hypot(on_surface.x, on_surface.y);
        const auto state = std::lower_bound(meridian.begin(), meridian.end() - 1, r,
                                            [](const MeridianState& m, double at) { return m.r < at; });
        const double J =
            1.0 / ((1.0 + foot.distance * state->meridional) * (1.0 + foot.distance * state->azimuthal));
        found[bin_of(r)] += J * dot(frame.components(F), foot.normal);
    });
    double squares = 0.0;
    double exact_squares = 0.0;
    for (int bin = 0; bin < bins; ++bin) {
        squares += std::pow(found[bin] - exact[bin], 2) / area[bin];
        exact_squares += std::pow(exact[bin], 2) / area[bin];
    }
    return std::sqrt(squares / exact_squares);
}

const Vec3<double> along{0.0, 0.0, 1.0};
const Vec3<double> askew{0.48, 0.6, 0.64};

} // namespace

// The membranes of the middle, .19 sqrt(A/4 pi) either side of it, lie within each other's stencils.
TEST_CASE("a discocyte's thin middle bends as it should wherever it lies on the lattice") {
    const auto [axis, offset] = GENERATE(
        std::pair{along, Vec3<double>{0.0, 0.0, 0.0}}, std::pair{along, Vec3<double>{0.0, 0.0, 0.5}},
        std::pair{along, Vec3<double>{0.5, 0.5, 0.5}}, std::pair{along, Vec3<double>{0.3, 0.1, 0.25}},
        std::pair{askew, Vec3<double>{0.0, 0.0, 0.0}}, std::pair{askew, Vec3<double>{0.3, 0.1, 0.2}});
    const double error = force_error(15.0, offset, axis);
    INFO("offset " << offset.x << " " << offset.y << " " << offset.z << ", axis " << axis.z << ": " << error);
    CHECK(error < 0.08);
}

TEST_CASE("the error of the bending force on a discocyte falls with the resolution", "[.validation]") {
    double coarser = 1.0;
    for (const double radius : {12.0, 15.0, 18.0, 24.0, 30.0}) {
        double worst = 0.0;
        for (const Vec3<double>& axis : {along, askew})
            for (const Vec3<double>& offset :
                 {Vec3<double>{0.0, 0.0, 0.0}, Vec3<double>{0.0, 0.0, 0.5}, Vec3<double>{0.3, 0.1, 0.25}})
                worst = std::max(worst, force_error(radius, offset, axis));
        measured("bending force on the discocyte v = .65, relative rms error, the worst of six places",
                 "R0 = " + std::to_string(radius).substr(0, 2), worst);
        CHECK(worst < coarser);
        coarser = worst;
    }
}
