#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <type_traits>

/// The arithmetic vocabulary of the kernels, for plain numbers. `parallel/pack.hpp` says the same words for
/// packs of numbers, so that one kernel text serves both. All is constexpr, roots too: nvcc takes that for
/// leave to compile it for a device.
namespace vesica {

template <std::floating_point T>
constexpr T fma(T a, T b, T c) {
#if defined(__FMA__)
    return std::is_same_v<T, float>
               ? static_cast<T>(
                     __builtin_fmaf(static_cast<float>(a), static_cast<float>(b), static_cast<float>(c)))
               : static_cast<T>(
                     __builtin_fma(static_cast<double>(a), static_cast<double>(b), static_cast<double>(c)));
#else
    return a * b + c;
#endif
}

template <std::floating_point T>
constexpr T select(bool mask, T yes, T no) {
    return mask ? yes : no;
}

template <std::floating_point T>
constexpr T square_root(T a) {
    return std::sqrt(a);
}

template <std::floating_point T>
constexpr T magnitude(T a) {
    return std::abs(a);
}

template <std::floating_point T>
constexpr T larger(T a, T b) {
    return a > b ? a : b;
}

template <std::floating_point T>
constexpr T smaller(T a, T b) {
    return a < b ? a : b;
}

/// True for -0.0 as well: the sign bit, not the order.
template <std::floating_point T>
constexpr bool sign_bit(T a) {
    return std::signbit(a);
}

/// |a| with the sign bit set where `negative` holds.
template <std::floating_point T>
constexpr T with_sign_bit(bool negative, T a) {
    return std::copysign(a, negative ? T(-1) : T(1));
}

template <std::floating_point T>
constexpr T logarithm(T a) {
    return std::log(a);
}

template <class V>
struct scalar_of {
    using type = V;
};

/// The number type inside V, which is a number or a pack of numbers.
template <class V>
using scalar_of_t = typename scalar_of<V>::type;

} // namespace vesica
