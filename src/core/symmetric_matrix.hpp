#pragma once

#include "core/vec3.hpp"

namespace vesica {

/// A symmetric 3 x 3 matrix.
template <class T>
struct SymmetricMatrix {
    T xx{};
    T yy{};
    T zz{};
    T xy{};
    T xz{};
    T yz{};

    friend constexpr bool operator==(const SymmetricMatrix&, const SymmetricMatrix&) = default;

    constexpr T trace() const { return xx + yy + zz; }
};

template <class T>
constexpr Vec3<T> operator*(const SymmetricMatrix<T>& m, const Vec3<T>& a) {
    return {m.xx * a.x + m.xy * a.y + m.xz * a.z, m.xy * a.x + m.yy * a.y + m.yz * a.z,
            m.xz * a.x + m.yz * a.y + m.zz * a.z};
}

} // namespace vesica
