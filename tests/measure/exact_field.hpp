#pragma once

#include "core/vec3.hpp"
#include "measure/layer_moment.hpp"
#include "measure/snapshot.hpp"

#include <cmath>
#include <numbers>

/// Snapshots of phi = -tanh(beta s) around surfaces whose distance and curvatures are known in closed form.
namespace vesica::exact {

/// What a surface says about a point in space.
struct Nearest {
    double s = 0.0;   ///< signed distance, positive outside
    Vec3<double> n{}; ///< outward normal at the nearest point
    double H0 = 0.0;
    double K0 = 0.0;
};

struct Sphere {
    Vec3<double> centre{};
    double radius = 0.0;

    Nearest operator()(const Vec3<double>& x) const {
        const Vec3<double> r = x - centre;
        const double distance = norm(r);
        return {distance - radius, (1.0 / distance) * r, 1.0 / radius, 1.0 / (radius * radius)};
    }
};

/// A ring of radius `ring` about an axis, with a tube of radius `tube`.
struct Torus {
    Vec3<double> centre{};
    double ring = 0.0;
    double tube = 0.0;
    Vec3<double> axis{0.0, 0.0, 1.0};

    Nearest operator()(const Vec3<double>& x) const {
        const Vec3<double> r = x - centre;
        const double height = dot(r, axis);
        const Vec3<double> flat = r - height * axis;
        const double distance = norm(flat);
        const Vec3<double> outward = (1.0 / distance) * flat;
        const double from_tube = std::hypot(distance - ring, height);
        const double cosine = (distance - ring) / from_tube;
        const double along = cosine / (ring + tube * cosine); // principal curvature along the ring
        return {from_tube - tube, cosine * outward + (height / from_tube) * axis, 0.5 * (1.0 / tube + along),
                along / tube};
    }
};

/// Semi-axis `polar` along the axis, `equatorial` across.
struct Spheroid {
    Vec3<double> centre{};
    double polar = 0.0;
    double equatorial = 0.0;
    Vec3<double> axis{0.0, 0.0, 1.0};

    Nearest operator()(const Vec3<double>& x) const {
        const Vec3<double> r = x - centre;
        const double z = dot(r, axis);
        const Vec3<double> flat = r - z * axis;
        const double rho = norm(flat);
        // The foot (a cos t, c sin t): Newton on the distance's derivative, from the best of a coarse scan.
        const double a = equatorial;
        const double c = polar;
        const double side = z < 0.0 ? -1.0 : 1.0;
        const double height = side * z;
        double t = 0.0;
        double least = 1e300;
        for (int i = 0; i <= 12; ++i) {
            const double trial = std::numbers::pi / 2 * i / 12;
            const double d = std::hypot(rho - a * std::cos(trial), height - c * std::sin(trial));
            if (d < least) {
                least = d;
                t = trial;
            }
        }
        for (int i = 0; i < 50; ++i) {
            const double sine = std::sin(t);
            const double cosine = std::cos(t);
            const double slope = (a * cosine - rho) * -a * sine + (c * sine - height) * c * cosine;
            const double bend = a * a * sine * sine - (a * cosine - rho) * a * cosine +
                                c * c * cosine * cosine - (c * sine - height) * c * sine;
            const double change = slope / bend;
            t -= change;
            if (std::abs(change) < 1e-15)
                break;
        }
        const double sine = std::sin(t);
        const double cosine = std::cos(t);
        const double stretch = std::hypot(a * sine, c * cosine); // |d foot/dt|
        const double n_rho = c * cosine / stretch;
        const double n_z = a * sine / stretch;
        const double s = (rho - a * cosine) * n_rho + (height - c * sine) * n_z;
        const double meridian = a * c / (stretch * stretch * stretch);
        const double azimuth = c / (a * stretch);
        const Vec3<double> outward = rho > 0.0 ? (1.0 / rho) * flat : Vec3<double>{};
        return {s, n_rho * outward + side * n_z * axis, 0.5 * (meridian + azimuth), meridian * azimuth};
    }

    double volume() const { return 4.0 / 3.0 * std::numbers::pi * equatorial * equatorial * polar; }

    double area() const {
        const double a = equatorial;
        const double c = polar;
        if (c < a) {
            const double e = std::sqrt(1.0 - c * c / (a * a));
            return 2.0 * std::numbers::pi * a * a * (1.0 + (1.0 - e * e) / e * std::atanh(e));
        }
        const double e = std::sqrt(1.0 - a * a / (c * c));
        return 2.0 * std::numbers::pi * a * a * (1.0 + c / (a * e) * std::asin(e));
    }
};

/// phi, and all that an engine would state, in the cells within `half_box` of `middle`. Cells with geometry
/// are those with 1 - phi^2 > cutoff.
template <class Surface>
VesicleSnapshot snapshot_of(const Surface& surface, const Vec3<int>& middle, int half_box, double beta = 0.67,
                            double cutoff = 1e-4) {
    VesicleSnapshot vesicle;
    vesicle.beta = beta;
    vesicle.layer = tanh_layer_moments(beta);
    for (int z = middle.z - half_box; z < middle.z + half_box; ++z)
        for (int y = middle.y - half_box; y < middle.y + half_box; ++y)
            for (int x = middle.x - half_box; x < middle.x + half_box; ++x) {
                const Vec3<double> position{x + 0.5, y + 0.5, z + 0.5};
                const Nearest near = surface(position);
                const double phi = -std::tanh(beta * near.s);
                const double contrast =
                    1.0 / (std::cosh(beta * near.s) * std::cosh(beta * near.s)); // 1 - phi^2
                if (contrast < 1e-9) {
                    if (phi < 0.0)
                        continue;
                    if (!vesicle.inside.empty()) {
                        InsideSpan& last = vesicle.inside.back();
                        if (last.y == y && last.z == z && last.begin + last.count == x) {
                            ++last.count;
                            continue;
                        }
                    }
                    vesicle.inside.push_back({x, 1, y, z});
                    continue;
                }
                InterfaceCell cell;
                cell.position = position;
                cell.phi = phi;
                cell.s = near.s;
                cell.n = near.n;
                const double growth = 1.0 + 2.0 * near.s * near.H0 + near.s * near.s * near.K0;
                cell.H = (near.H0 + near.s * near.K0) / growth; // parallel surfaces
                cell.K = near.K0 / growth;
                cell.H0 = near.H0;
                cell.K0 = near.K0;
                cell.J = 1.0 / growth;
                cell.weight = 0.5 * beta * contrast;
                cell.has_geometry = contrast > cutoff;
                vesicle.cells.push_back(cell);
            }
    return vesicle;
}

} // namespace vesica::exact
