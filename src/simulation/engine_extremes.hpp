#pragma once

#include "core/vec3.hpp"

#include <cmath>
#include <tuple>

namespace vesica {

/// The largest of a quantity over the box and where it is; what is not a number is larger than all, and
/// of equals the first cell in canonical order counts.
struct Extreme {
    double size = 0.0;
    Vec3<int> cell{};
    bool in_layer = false;

    void take(const Extreme& other) {
        if (is_before(other, *this))
            *this = other;
    }

private:
    static bool is_before(const Extreme& a, const Extreme& b) {
        if (std::isnan(a.size) != std::isnan(b.size))
            return std::isnan(a.size);
        if (a.size > b.size || b.size > a.size)
            return a.size > b.size;
        return std::tie(a.cell.z, a.cell.y, a.cell.x) < std::tie(b.cell.z, b.cell.y, b.cell.x);
    }
};
struct Extremes {
    Extreme speed;
    Extreme density; ///< its distance from the reference
    Extreme force;

    void take(const Extremes& other) {
        speed.take(other.speed);
        density.take(other.density);
        force.take(other.force);
    }
};

/// Less than any.
inline Extremes nothing_yet() {
    Extremes none;
    none.speed.size = none.density.size = none.force.size = -1.0;
    return none;
}

} // namespace vesica
