#include "measured.hpp"
#include "shape/spheroid.hpp"
#include "simulation/exact_layer.hpp"

#include <catch2/catch.hpp>

#include <string>

using namespace vesica;
using namespace vesica::test;

namespace {

struct Exact {
    double s; ///< signed distance
    double H; ///< of the surface at the closest point
    double K;
};

struct CurvatureErrors {
    double H = 0.0;        ///< rms over the layer, over the exact rms of the larger principal curvature
    double K = 0.0;        ///< the same over its square
    double gaussian = 0.0; ///< int K dA
    double raw_area = 0.0;
};

/// The curvatures that a layer finds from nothing but its phase field, against the surface's own.
template <class Surface>
CurvatureErrors errors_of(const Vec3<int>& box, const Surface& surface) {
    const Vec3<double> centre{0.5 * box.x + 0.23, 0.5 * box.y - 0.31, 0.5 * box.z + 0.12};
    const auto exact_at = [&](const Vec3<double>& x) -> Exact {
        return surface(x - centre);
    };
    const Layer<double> layer = exact_layer(
        box, [&](const Vec3<double>& x) { return exact_at(x).s; }, Membrane{});
    double weights = 0.0;
    double H_squares = 0.0;
    double K_squares = 0.0;
    double largest_squares = 0.0;
    for (const std::int32_t index : layer.band().of_level(reach::force)) {
        const BandTile& t = layer.band().tiles()[static_cast<std::size_t>(index)];
        const Vec3<int> origin = layer.band().grid().tile_origin(t.tile);
        const Pack<double> H0 = layer.mean_curvature(TileRun<double>{&t});
        for (int k = 0; k < Grid::tile; ++k) {
            if ((t.bits[reach::force] >> k & 1) == 0)
                continue;
            const auto at = static_cast<std::size_t>(t.slot() + k);
            const Exact exact = exact_at({origin.x + k + 0.5, origin.y + 0.5, origin.z + 0.5});
            const double weight = layer_density(layer.fields().chi[at]);
            const double largest = exact.H + std::sqrt(std::max(exact.H * exact.H - exact.K, 0.0));
            weights += weight;
            H_squares += weight * std::pow(H0[k] - exact.H, 2);
            K_squares += weight * std::pow(layer.fields().K0[at] - exact.K, 2);
            largest_squares += weight * largest * largest;
        }
    }
    const double scale = largest_squares / weights;
    return {std::sqrt(H_squares / weights / scale), std::sqrt(K_squares / weights) / scale,
            layer.sums(0).gaussian_curvature, layer.sums(0).raw_area};
}

CurvatureErrors sphere(double R) {
    const int edge = static_cast<int>(2 * R) + 24;
    return errors_of({edge, edge, edge}, [=](const Vec3<double>& x) {
        return Exact{norm(x) - R, 1.0 / R, 1.0 / (R * R)};
    });
}

/// Along z through a periodic box.
CurvatureErrors cylinder(double R) {
    const int edge = static_cast<int>(2 * R) + 24;
    return errors_of({edge, edge, 2}, [=](const Vec3<double>& x) {
        return Exact{std::hypot(x.x, x.y) - R, 0.5 / R, 0.0};
    });
}

/// With n the normal of an ellipse of semi-axes a (across) and b: kappa = q^3/(a b)^2 along the meridian and
/// q/a^2 across it, q^2 = a^2 n_r^2 + b^2 n_z^2. Its axis is askew to the lattice.
CurvatureErrors spheroid(double R, double aspect) {
    const Spheroid shape(R, aspect);
    const double a = R / std::cbrt(aspect);
    const double b = a * aspect;
    const int edge = static_cast<int>(2 * std::max(a, b)) + 24;
    const Vec3<double> axis{2.0 / 3.0, 1.0 / 3.0, 2.0 / 3.0};
    return errors_of({edge, edge, edge}, [&](const Vec3<double>& x) {
        const double z = dot(axis, x);
        const MeridianFoot foot = shape.closest(norm(x - z * axis), z);
        const double q = std::hypot(a * foot.normal_r, b * foot.normal_z);
        const double along = q * q * q / (a * a * b * b);
        const double across = q / (a * a);
        return Exact{foot.distance, 0.5 * (along + across), along * across};
    });
}

double order(double coarse, double fine) {
    return std::log(coarse / fine) / std::log(1.5);
}

} // namespace

TEST_CASE(
    "H and K from a phase field are those of sphere, cylinder and spheroids, at least to second order") {
    struct Surface {
        const char* name;
        CurvatureErrors (*at)(double radius);
        double bound; ///< at R = 18
    };
    for (const Surface& surface : {Surface{"sphere", sphere, 1e-4}, Surface{"cylinder", cylinder, 5e-4},
                                   Surface{"oblate", [](double R) { return spheroid(R, 0.6); }, 4e-3},
                                   Surface{"prolate", [](double R) { return spheroid(R, 1.6); }, 4e-3}}) {
        const CurvatureErrors coarse = surface.at(12.0);
        const CurvatureErrors fine = surface.at(18.0);
        INFO(surface.name << ": H " << coarse.H << ", " << fine.H << "; K " << coarse.K << ", " << fine.K);
        CHECK(fine.H < surface.bound);
        CHECK(fine.K < surface.bound);
        CHECK(order(coarse.H, fine.H) > 1.8);
        if (std::string(surface.name) != "cylinder")
            CHECK(order(coarse.K, fine.K) > 1.8);
    }
}

TEST_CASE("Gauss-Bonnet: the layer's int K dA is 4 pi on a sphere and on spheroids, 0 on a cylinder") {
    const double on_sphere = sphere(12.0).gaussian / (4.0 * pi);
    CHECK(on_sphere == Approx(1.0).epsilon(0.005));
    measured("int K dA of a sphere over 4 pi", "R = 12", on_sphere);
    CHECK(spheroid(15.0, 0.6).gaussian == Approx(4.0 * pi).epsilon(0.005));
    CHECK(spheroid(15.0, 1.6).gaussian == Approx(4.0 * pi).epsilon(0.005));
    CHECK(std::abs(cylinder(12.0).gaussian) < 0.005 * 4.0 * pi);
}

TEST_CASE("the raw area of a sphere's layer is 4 pi (R^2 + pi^2/(12 beta^2))") {
    for (const double R : {12.0, 15.0}) {
        const double ratio = sphere(R).raw_area / (4.0 * pi * (R * R + pi * pi / (12.0 * 0.67 * 0.67)));
        CHECK(ratio == Approx(1.0).epsilon(1e-4));
        measured("raw area of a sphere over 4 pi (R^2 + pi^2/(12 beta^2)), less 1",
                 "R = " + std::to_string(R).substr(0, 2), ratio - 1.0);
    }
}
