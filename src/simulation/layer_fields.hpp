#pragma once

#include "lattice/band.hpp"
#include "parallel/pack.hpp"

#include <cstdint>
#include <vector>

namespace vesica {

/// Everything that is known only near an interface, one number per compact address of the band.
template <class Real>
struct LayerFields {
    using Array = std::vector<Real>;

    Array chi;     ///< signed minority fraction (colour/phase.hpp)
    Array next;    ///< chi after streaming
    Array density; ///< rho
    Array s;       ///< signed distance to phi = 0
    Array psi;     ///< the force's profile across the layer (membrane/layer_force.hpp)
    Array sharp;   ///< s, and later H0, sharpened for the stencils that will blur it
    Array n[3];    ///< outward unit normal
    Array w[3];    ///< segregation flux
    Array raw_H0;  ///< mean curvature of phi = 0 as differentiated (of the cell itself with the paper's
                   ///< geometry)
    Array H0;      ///< the same without the stencils' leading error
    Array K0;
    Array J;    ///< area of phi = 0 per area of the parallel surface
    Array g[3]; ///< surface gradient of H0, mapped to phi = 0 (whole gradient with the paper's geometry)

    /// Arrays are reused; memory grows only.
    void resize(std::int64_t size) {
        for_each_array([size](Array& array) { array.assign(static_cast<std::size_t>(size), Real(0)); });
    }

    std::size_t bytes() const {
        std::size_t sum = 0;
        const_cast<LayerFields*>(this)->for_each_array(
            [&sum](Array& array) { sum += array.capacity() * sizeof(Real); });
        return sum;
    }

private:
    template <class Body>
    void for_each_array(const Body& body) {
        for (Array* array : {&chi, &next, &density, &s, &psi, &sharp, &raw_H0, &H0, &K0, &J})
            body(*array);
        for (int a = 0; a < 3; ++a) {
            body(n[a]);
            body(w[a]);
            body(g[a]);
        }
    }
};

/// The value of a compact array in a tile's cells shifted by a lattice link.
template <class Real>
struct TileAround {
    const Real* values;
    const std::int32_t* rows;

    template <int i>
    VESICA_INLINE Pack<Real> operator()(Direction<i>) const {
        constexpr int row = (velocity(i, 1) + 1) + 3 * (velocity(i, 2) + 1);
        return Pack<Real>::load(values + rows[row] + velocity(i, 0));
    }
};

/// phi around, from chi.
template <class Real>
struct PhaseAround {
    TileAround<Real> chi;

    template <int i>
    VESICA_INLINE Pack<Real> operator()(Direction<i> direction) const {
        return phase_of(chi(direction));
    }
};

/// c_i.w of the neighbour a population came from: i is the opposite of the direction asked for.
template <class Real>
struct FluxAround {
    Vec3<const Real*> w;
    const std::int32_t* rows;

    template <int from>
    VESICA_INLINE Pack<Real> operator()(Direction<from> direction) const {
        Pack<Real> sum(0);
        for_each_component<from>(direction, sum, std::make_integer_sequence<int, 3>{});
        return sum;
    }

private:
    template <int from, int... axis>
    VESICA_INLINE void for_each_component(Direction<from> direction, Pack<Real>& sum,
                                          std::integer_sequence<int, axis...>) const {
        (add<velocity(from, axis)>(TileAround<Real>{w[axis], rows}, direction, sum), ...);
    }

    template <int towards, int from>
    VESICA_INLINE static void add(const TileAround<Real>& component, Direction<from> direction,
                                  Pack<Real>& sum) {
        if constexpr (towards == -1)
            sum += component(direction);
        if constexpr (towards == 1)
            sum -= component(direction);
    }
};

} // namespace vesica
