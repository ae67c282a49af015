#pragma once

#include "core/quantity.hpp"

namespace vesica {

/// What one lattice unit of length, time and density is worth: the only bridge between SI and the lattice.
/// With `density` the lattice's mass unit is density * cell^3.
struct Scales {
    double cell = 1.0;    ///< metres
    double step = 1.0;    ///< seconds
    double density = 1.0; ///< kg/m^3

    /// SI base units per lattice unit of this dimension.
    double unit(const Dimension& dimension) const;

    /// The number that stands for the quantity on the lattice.
    double to_lattice(const Quantity& quantity) const;

    /// The quantity that a lattice number of this dimension stands for.
    Quantity to_si(double lattice, const Dimension& dimension) const;

    friend constexpr bool operator==(const Scales&, const Scales&) = default;
};

} // namespace vesica
