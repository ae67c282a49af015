#pragma once

#include "colour/phase.hpp"
#include "core/vec3.hpp"
#include "lattice/field.hpp"
#include "parallel/pack.hpp"
#include "simulation/shared_tiles.hpp"

#include <cstdint>

namespace vesica {

/// What the fluid inside a vesicle has of its own.
struct InnerFluid {
    double rate = 1.0;       ///< lambda of the stress, as pure_rate() has it
    double thinning = 0.0;   ///< 1/(1/rate - 1/2) less the same of the fluid outside
    Vec3<double> buoyancy{}; ///< force per volume
};

/// What the fluid feels of the membranes: forces in the band's compact arrays, and colours where fluids
/// differ.
template <class Real>
struct LayerInfluence {
    const std::int32_t* force_slot = nullptr; ///< per tile: where its forces begin, -1 where there are none
    FieldView<const Real> force;
    bool contrast = false; ///< a viscosity inside differs from the one outside
    bool buoyant = false;
    const InnerFluid* inner = nullptr;         ///< per label
    const std::int32_t* colour_slot = nullptr; ///< per tile, as Layer numbers them
    const std::int32_t* label = nullptr;       ///< per compact tile: whose it is
    const std::int32_t* interior = nullptr;    ///< per tile: the label it lies inside of, beyond its band
    const SharedTiles* shared = nullptr;
    const Real* chi = nullptr; ///< colours in the bands, before streaming: a step does not write them

    /// body(label, its share rho_k/rho) for all colours of the V::width cells of one tile, or of tiles that
    /// lie side by side.
    template <class V, class Body>
    void for_each_colour(std::int64_t tile, const Body& body) const {
        const std::int32_t slot = colour_slot[tile];
        if (slot >= 0) {
            body(label[slot / tile_width], red_fraction(V::load(chi + slot)));
        } else if (!is_shared(slot)) {
            if (interior[tile] >= 0)
                body(interior[tile], V(1));
        } else {
            V others = V(0);
            shared->for_each_colour(slot, [&](const SharedTiles::Colour& colour) {
                if (colour.slot == SharedTiles::Colour::pure)
                    return;
                const V share = red_fraction(V::load(chi + colour.slot));
                others += share;
                body(colour.label, share);
            });
            shared->for_each_colour(slot, [&](const SharedTiles::Colour& colour) {
                if (colour.slot == SharedTiles::Colour::pure)
                    body(colour.label, V(1) - others);
            });
        }
    }
};

} // namespace vesica
