#pragma once

#include "simulation/layer_forces.hpp"
#include "simulation/layer_geometry.hpp"
#include "simulation/layer_placement.hpp"

#include <cmath>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace vesica::test {

inline constexpr double pi = 3.14159265358979323846;

/// A layer whose phase field is exactly -tanh(beta s) for a given signed distance, with its geometry found.
template <class Real = double>
Layer<Real> exact_layer(const Vec3<int>& size,
                        const std::function<double(const Vec3<double>&)>& signed_distance,
                        const Membrane& membrane, const LayerSettings& settings = {}) {
    const Grid grid(size);
    const double reach = std::atanh(std::sqrt(1.0 - settings.cutoff)) / settings.beta;
    std::vector<Band::Seed> core;
    std::vector<std::int32_t> interior(static_cast<std::size_t>(grid.tiles()), -1);
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; x += Grid::tile) {
                unsigned near = 0;
                unsigned red = 0;
                for (int k = 0; k < Grid::tile && x + k < size.x; ++k) {
                    const double s = signed_distance({x + k + 0.5, y + 0.5, z + 0.5});
                    if (s < 0.0)
                        red |= 1u << k;
                    if (std::abs(s) < reach)
                        near |= 1u << k;
                }
                const std::int64_t tile = grid.index(x, y, z) / Grid::tile;
                if (red == grid.interior_bits({x, y, z}))
                    interior[static_cast<std::size_t>(tile)] = 0;
                if (near != 0)
                    core.push_back({tile, static_cast<std::uint8_t>(near)});
            }
    Layer<Real> layer(grid, settings);
    const auto chi_at = [&](std::int64_t cell, int) {
        Vec3<int> place = grid.tile_origin(cell / Grid::tile);
        place.x += static_cast<int>(cell % Grid::tile);
        const double s = signed_distance({place.x + 0.5, place.y + 0.5, place.z + 0.5});
        return static_cast<Real>(
            with_sign_bit(s < 0.0, 1.0 / (1.0 + std::exp(2.0 * settings.beta * std::abs(s)))));
    };
    layer.place(core, chi_at, interior, 1);
    layer.locate(1);
    layer.normals(1);
    layer.curvatures(1);
    layer.slopes(1);
    layer.forces(std::span(&membrane, 1), 1);
    return layer;
}

/// Calls body(cell centre, force, tile, lane) for every cell that has a force.
template <class Real, class Body>
void for_each_force(const Layer<Real>& layer, const Body& body) {
    const FieldView<const Real> F = layer.force().view();
    for (const std::int32_t index : layer.band().of_level(reach::force)) {
        const BandTile& t = layer.band().tiles()[static_cast<std::size_t>(index)];
        const Vec3<int> origin = layer.band().grid().tile_origin(t.tile);
        for (int k = 0; k < Grid::tile; ++k) {
            if ((t.bits[reach::force] >> k & 1) == 0)
                continue;
            const auto at = layer.force_slot(t) + k;
            body(Vec3<double>{origin.x + k + 0.5, origin.y + 0.5, origin.z + 0.5},
                 Vec3<double>{static_cast<double>(F.component(0)[at]),
                              static_cast<double>(F.component(1)[at]),
                              static_cast<double>(F.component(2)[at])});
        }
    }
}

/// A surface of revolution r(theta) about z in polar coordinates, as a signed distance accurate to second
/// order along its gradient, and its Helfrich energy by quadrature.
struct PolarSurface {
    double radius = 20.0;
    double a2 = 0.0; ///< r = radius (1 + a2 P2 + a3 P3)
    double a3 = 0.0;

    static double p2(double c) { return 0.5 * (3 * c * c - 1); }
    static double p3(double c) { return 0.5 * (5 * c * c * c - 3 * c); }

    double r(double theta) const {
        const double c = std::cos(theta);
        return radius * (1 + a2 * p2(c) + a3 * p3(c));
    }
    double r1(double theta) const { return (r(theta + step) - r(theta - step)) / (2 * step); }
    double r2(double theta) const {
        return (r(theta + step) - 2 * r(theta) + r(theta - step)) / (step * step);
    }

    /// 2H of the surface of revolution, positive on a sphere.
    double twice_mean_curvature(double theta) const {
        const double q = r(theta);
        const double d = r1(theta);
        const double w = std::sqrt(q * q + d * d);
        const double meridian = (q * q + 2 * d * d - q * r2(theta)) / (w * w * w);
        const double parallel = (q * std::sin(theta) - d * std::cos(theta)) / (q * std::sin(theta) * w);
        return meridian + parallel;
    }

    /// (kappa/2) int (2H - C0)^2 dA with kappa = 1.
    double bending_energy(double c0) const {
        constexpr int points = 4000;
        double sum = 0.0;
        for (int k = 0; k < points; ++k) {
            const double theta = (k + 0.5) * pi / points;
            const double q = r(theta);
            const double d = r1(theta);
            const double h = twice_mean_curvature(theta) - c0;
            sum += 0.5 * h * h * 2 * pi * q * std::sin(theta) * std::sqrt(q * q + d * d) * pi / points;
        }
        return sum;
    }

    double area() const {
        constexpr int points = 4000;
        double sum = 0.0;
        for (int k = 0; k < points; ++k) {
            const double theta = (k + 0.5) * pi / points;
            const double q = r(theta);
            const double d = r1(theta);
            sum += 2 * pi * q * std::sin(theta) * std::sqrt(q * q + d * d) * pi / points;
        }
        return sum;
    }

    /// Distance from `x` (about the origin) to the meridian, by Newton's method on the closest point.
    double signed_distance(const Vec3<double>& x) const {
        const double rho = std::hypot(x.x, x.y);
        const double distance = norm(x);
        if (distance < 1e-9)
            return -r(0.0);
        double theta = std::atan2(rho, x.z);
        const double sign = distance > r(theta) ? 1.0 : -1.0;
        const auto dx = [&](double t) {
            return r(t) * std::sin(t) - rho;
        };
        const auto dz = [&](double t) {
            return r(t) * std::cos(t) - x.z;
        };
        const auto slope = [&](double t) {
            return dx(t) * (r1(t) * std::sin(t) + r(t) * std::cos(t)) +
                   dz(t) * (r1(t) * std::cos(t) - r(t) * std::sin(t));
        };
        for (int k = 0; k < 30; ++k) {
            const double curvature = (slope(theta + step) - slope(theta - step)) / (2 * step);
            if (curvature <= 0.0)
                break;
            const double move = -slope(theta) / curvature;
            theta += std::max(-0.1, std::min(0.1, move));
            if (std::abs(move) < 1e-12)
                break;
        }
        return sign * std::hypot(dx(theta), dz(theta));
    }

    static constexpr double step = 1e-4;
};

} // namespace vesica::test
