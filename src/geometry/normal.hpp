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

} // namespace vesica
