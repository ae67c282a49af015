#pragma once

#include "membrane/area_constraint.hpp"
#include "membrane/bending.hpp"

#include <variant>

namespace vesica {

using BendingLaw = std::variant<HelfrichLaw, PaperBendingLaw>;

/// No constraint on the area.
struct FreeArea {
    double tension(double, double) const { return 0.0; }
};

using AreaLaw = std::variant<FreeArea, AreaMultiplier, AreaPenalty, PaperAreaPenalty>;

/// The membrane of one vesicle: its laws and what they remember.
struct Membrane {
    BendingLaw bending;
    double sigma = 0.0; ///< constant tension
    AreaLaw area;
    AreaTarget target;
    double constraint_tension = 0.0; ///< sigma_A at present

    double tension() const { return sigma + constraint_tension; }

    void hold_area(double area_now, std::int64_t step) {
        constraint_tension =
            std::visit([&](auto& law) { return law.tension(area_now, target.at(step)); }, area);
    }
};

} // namespace vesica
