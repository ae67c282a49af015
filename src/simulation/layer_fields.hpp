#pragma once

#include "colour/phase.hpp"
#include "lattice/band.hpp"
#include "lattice/field.hpp"
#include "membrane/layer_force.hpp"
#include "parallel/pack.hpp"
#include "simulation/tile_run.hpp"

#include <algorithm>
#include <cstdint>
#include <span>

namespace vesica {

/// Everything that is known only near an interface, one number per compact address of the band. The arrays
/// are the components of one field: were each allocated for itself, all would begin at a page, and the same
/// cell's values would contend for one set of the cache.
template <class Real>
struct LayerFields {
    using Array = std::span<Real>;

    Array chi;     ///< signed minority fraction (colour/phase.hpp), before streaming
    Array density; ///< rho
    Array s;       ///< signed distance to phi = 0; while the fluid streams, the chi that arrives
    Array sharp;   ///< s, and later H0, sharpened for the stencils that will blur it
    Array n[3];    ///< outward unit normal
    Array w[3];    ///< segregation flux
    Array raw_H0;  ///< mean curvature of phi = 0 as differentiated (of the cell itself with the paper's
                   ///< geometry)
    Array K0;
    Array J;    ///< area of phi = 0 per area of the parallel surface
    Array g[3]; ///< surface gradient of H0, mapped to phi = 0 (whole gradient with the paper's geometry)

    /// All zero. Memory is reused and grows only.
    void resize(std::int64_t size) {
        if (memory_.stride() < size)
            memory_ = Field<Real>(array_count, memory_.stride() == 0 ? size : size + size / 8);
        int component = 0;
        for_each_array([&](Array& array) {
            array = Array(memory_.view().component(component++), static_cast<std::size_t>(size));
            std::fill(array.begin(), array.end(), Real(0));
        });
    }

    std::size_t bytes() const { return memory_.bytes(); }

private:
    template <class Body>
    void for_each_array(const Body& body) {
        for (Array* array : {&chi, &density, &s, &sharp, &raw_H0, &K0, &J})
            body(*array);
        for (int a = 0; a < 3; ++a) {
            body(n[a]);
            body(w[a]);
            body(g[a]);
        }
    }

    static constexpr int array_count = 16;
    Field<Real> memory_;
};

/// phi around, from chi.
template <class Real, int width>
struct PhaseAround {
    Around<Real, width> chi;

    template <int i>
    VESICA_INLINE Pack<Real, width> operator()(Direction<i> direction) const {
        return phase_of(chi(direction));
    }
};

/// The force's profile around, from chi.
template <class Real, int width>
struct ProfileAround {
    const LayerForce& spread_force;
    Around<Real, width> chi;

    template <int i>
    VESICA_INLINE Pack<Real, width> operator()(Direction<i> direction) const {
        return spread_force.profile(phase_of(chi(direction)));
    }
};

/// The fraction of one colour around, chosen by the cell in the middle. A small one keeps its digits.
template <class Real, int width>
struct MinorityAround {
    typename Pack<Real, width>::Mask blue_is_minor;
    Around<Real, width> chi;

    template <int i>
    VESICA_INLINE Pack<Real, width> operator()(Direction<i> direction) const {
        const auto there = chi(direction);
        return select<Real>(blue_is_minor, blue_fraction(there), red_fraction(there));
    }
};

/// Values around, but a cell's own where the neighbour is solid: colours that a wall turns back were the
/// cell's.
template <class Real, int width, class Inner>
struct Reflected {
    using V = Pack<Real, width>;

    Inner inner;
    V own;
    const typename V::Mask* solid; ///< per direction

    template <int i>
    VESICA_INLINE V operator()(Direction<i> direction) const {
        if constexpr (i == 0)
            return own;
        else
            return select<Real>(solid[i], own, inner(direction));
    }
};

} // namespace vesica
