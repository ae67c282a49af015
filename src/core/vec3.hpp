#pragma once

#include <cmath>

namespace vesica {

/// A vector of three components of any arithmetic-like type: doubles, packs of them, or indices.
template <class T>
struct Vec3 {
    T x{};
    T y{};
    T z{};

    constexpr const T& operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
    constexpr T& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }

    friend constexpr bool operator==(const Vec3&, const Vec3&) = default;

    friend constexpr Vec3 operator+(const Vec3& a, const Vec3& b) {
        return {a.x + b.x, a.y + b.y, a.z + b.z};
    }
    friend constexpr Vec3 operator-(const Vec3& a, const Vec3& b) {
        return {a.x - b.x, a.y - b.y, a.z - b.z};
    }
    friend constexpr Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
    friend constexpr Vec3 operator*(const T& c, const Vec3& a) { return {c * a.x, c * a.y, c * a.z}; }
    friend constexpr Vec3 operator*(const Vec3& a, const T& c) { return c * a; }
};

template <class T>
constexpr T dot(const Vec3<T>& a, const Vec3<T>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class T>
constexpr Vec3<T> cross(const Vec3<T>& a, const Vec3<T>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline double norm(const Vec3<double>& a) {
    return std::sqrt(dot(a, a));
}

} // namespace vesica
