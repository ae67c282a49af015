#pragma once

#include "core/real.hpp"
#include "core/vec3.hpp"

#include <limits>

namespace vesica {

/// n = grad s/|grad s|, the outward unit normal; zero where the gradient vanishes.
template <class V>
[[gnu::always_inline]] constexpr Vec3<V> unit_vector(const Vec3<V>& a) {
    const V tiny = V(std::numeric_limits<scalar_of_t<V>>::min());
    const V inverse = V(1) / square_root(larger(dot(a, a), tiny));
    return {inverse * a.x, inverse * a.y, inverse * a.z};
}

/// The unit normal where the gradient of a distance has a direction; zero midway between two sheets of a
/// surface, where it vanishes: below one half (it is 1 elsewhere, and .58 in cells to either side of the
/// middle), which way it points is chance.
template <class V>
[[gnu::always_inline]] constexpr Vec3<V> normal_of_distance(const Vec3<V>& gradient) {
    const V valid = smaller(larger((dot(gradient, gradient) - V(0.25)) * V(1e30), V(0)), V(1));
    const Vec3<V> n = unit_vector(gradient);
    return {valid * n.x, valid * n.y, valid * n.z};
}

} // namespace vesica
