#pragma once

#include "colour/phase.hpp"
#include "lattice/field.hpp"
#include "simulation/fluid_step.hpp"
#include "simulation/layer_forces.hpp"
#include "simulation/layer_geometry.hpp"
#include "simulation/layer_placement.hpp"
#include "simulation/layer_transport.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

namespace vesica {

/// A resting sphere in the middle of a periodic cube, with everything a step of it needs.
template <class Real>
struct Sphere {
    Sphere(int edge, double radius)
        : grid({edge, edge, edge}), populations(direction_count, grid.cells()), layer(grid, settings) {
        for (int i = 0; i < direction_count; ++i)
            std::fill_n(populations.view().component(i), grid.cells(), Real(0));
        const auto distance = [&](const Vec3<int>& cell) {
            const double x = cell.x + 0.5 - 0.5 * edge;
            const double y = cell.y + 0.5 - 0.5 * edge;
            const double z = cell.z + 0.5 - 0.5 * edge;
            return std::sqrt(x * x + y * y + z * z) - radius;
        };
        const auto minority = [&](double s) {
            return 1.0 / (1.0 + std::exp(2.0 * settings.beta * std::abs(s)));
        };
        std::vector<Band::Seed> core;
        std::vector<std::int32_t> interior(static_cast<std::size_t>(grid.tiles()), -1);
        for (std::int64_t tile = 0; tile < grid.tiles(); ++tile) {
            const Vec3<int> origin = grid.tile_origin(tile);
            unsigned in_core = 0;
            unsigned red = 0;
            for (int k = 0; k < tile_width; ++k) {
                const double s = distance({origin.x + k, origin.y, origin.z});
                red |= (s < 0.0 ? 1u : 0u) << k;
                in_core |= (layer_density(minority(s)) > settings.cutoff ? 1u : 0u) << k;
            }
            const unsigned own = grid.interior_bits(origin);
            if (own != 0 && (red & own) == own)
                interior[static_cast<std::size_t>(tile)] = 0;
            in_core &= own;
            if (in_core != 0)
                core.push_back({tile, static_cast<std::uint8_t>(in_core)});
        }
        const auto chi_at = [&](std::int64_t index, int) {
            Vec3<int> cell = grid.tile_origin(index / tile_width);
            cell.x += static_cast<int>(index % tile_width);
            const double s = distance(cell);
            return static_cast<Real>(with_sign_bit(s < 0.0, minority(s)));
        };
        layer.place(core, chi_at, std::move(interior), 1);
    }

    LayerInfluence<Real> influence() const {
        LayerInfluence<Real> influence;
        influence.force_slot = layer.force_slots().data();
        influence.force = layer.force().view();
        return influence;
    }

    std::int64_t cells_of_level(int level) const {
        std::int64_t count = 0;
        for (const std::uint8_t bits : layer.cells_of_level(level))
            count += std::popcount(bits);
        return count;
    }

    LayerSettings settings;
    Grid grid;
    Field<Real> populations; ///< deviations from rest
    Layer<Real> layer;
};

} // namespace vesica
