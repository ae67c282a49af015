#pragma once

#include "core/real.hpp"
#include "core/vec3.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#define VESICA_INLINE [[gnu::always_inline]] inline

namespace vesica {

/// Cells per tile: the unit of work along x. Fixed, so that layouts and sums do not depend on the instruction
/// set.
inline constexpr int tile_width = 8;

namespace detail {

#if defined(__AVX512F__)
inline constexpr int register_bytes = 64;
#elif defined(__AVX2__)
inline constexpr int register_bytes = 32;
#else
inline constexpr int register_bytes = 16;
#endif

} // namespace detail

/// How many tiles of such numbers a register holds: a pass over tiles that follow each other takes so many at
/// once.
template <class T>
inline constexpr int tiles_per_register = std::max(1, detail::register_bytes /
                                                          (tile_width * static_cast<int>(sizeof(T))));

/// The numbers of a tile, or of two that follow each other, handled as one: as many machine registers as they
/// need, on the vector extension of GCC and clang. The same text runs on SSE2, AVX2 and AVX-512. This is the
/// only file that knows of registers.
template <class T, int count = tile_width>
struct Pack {
    static constexpr int width = count;
    static constexpr int bytes = width * static_cast<int>(sizeof(T));
    static constexpr int bytes_per_register = bytes < detail::register_bytes ? bytes : detail::register_bytes;
    static constexpr int registers = bytes / bytes_per_register;
    static constexpr int lanes = bytes_per_register / static_cast<int>(sizeof(T));

    using Bits = std::conditional_t<sizeof(T) == 8, std::int64_t, std::int32_t>;
    typedef T Native __attribute__((vector_size(bytes_per_register)));
    typedef Bits Lanes __attribute__((vector_size(bytes_per_register)));
    typedef T Unaligned __attribute__((vector_size(bytes_per_register), aligned(sizeof(T)), may_alias));
    typedef Bits UnalignedBits
        __attribute__((vector_size(bytes_per_register), aligned(sizeof(T)), may_alias));

    /// Which lanes something holds for: all bits of a lane or none.
    struct Mask {
        Lanes m[static_cast<std::size_t>(registers)];

        VESICA_INLINE friend Mask operator&(Mask a, const Mask& b) {
            for (int r = 0; r < registers; ++r)
                a.m[r] &= b.m[r];
            return a;
        }
        VESICA_INLINE friend Mask operator|(Mask a, const Mask& b) {
            for (int r = 0; r < registers; ++r)
                a.m[r] |= b.m[r];
            return a;
        }
        VESICA_INLINE friend Mask operator!(Mask a) {
            for (int r = 0; r < registers; ++r)
                a.m[r] = ~a.m[r];
            return a;
        }
        VESICA_INLINE bool operator[](int lane) const { return m[lane / lanes][lane % lanes] != 0; }
    };

    Native v[static_cast<std::size_t>(registers)];

    VESICA_INLINE Pack() : v{} {}
    template <class A>
    requires std::is_arithmetic_v<A>
        VESICA_INLINE Pack(A a) // NOLINT(google-explicit-constructor): a number is a pack of equal numbers
    {
        const T value = static_cast<T>(a);
        for (int r = 0; r < registers; ++r)
            v[r] = value - Native{};
    }

    VESICA_INLINE static Pack load(const T* from) {
        Pack a;
        for (int r = 0; r < registers; ++r)
            a.v[r] = *reinterpret_cast<const Unaligned*>(from + r * lanes);
        return a;
    }
    VESICA_INLINE void store(T* to) const {
        for (int r = 0; r < registers; ++r)
            *reinterpret_cast<Unaligned*>(to + r * lanes) = v[r];
    }

    VESICA_INLINE T operator[](int lane) const { return v[lane / lanes][lane % lanes]; }

    VESICA_INLINE Pack& operator+=(const Pack& b) {
        for (int r = 0; r < registers; ++r)
            v[r] += b.v[r];
        return *this;
    }
    VESICA_INLINE Pack& operator-=(const Pack& b) {
        for (int r = 0; r < registers; ++r)
            v[r] -= b.v[r];
        return *this;
    }
    VESICA_INLINE Pack& operator*=(const Pack& b) {
        for (int r = 0; r < registers; ++r)
            v[r] *= b.v[r];
        return *this;
    }
    VESICA_INLINE friend Pack operator+(Pack a, const Pack& b) { return a += b; }
    VESICA_INLINE friend Pack operator-(Pack a, const Pack& b) { return a -= b; }
    VESICA_INLINE friend Pack operator*(Pack a, const Pack& b) { return a *= b; }
    VESICA_INLINE friend Pack operator/(Pack a, const Pack& b) {
        for (int r = 0; r < registers; ++r)
            a.v[r] /= b.v[r];
        return a;
    }
    VESICA_INLINE friend Pack operator-(Pack a) {
        for (int r = 0; r < registers; ++r)
            a.v[r] = -a.v[r];
        return a;
    }

    VESICA_INLINE friend Mask operator<(const Pack& a, const Pack& b) {
        Mask mask;
        for (int r = 0; r < registers; ++r)
            mask.m[r] = (Lanes)(a.v[r] < b.v[r]);
        return mask;
    }
    VESICA_INLINE friend Mask operator>(const Pack& a, const Pack& b) { return b < a; }
    VESICA_INLINE friend Mask operator<=(const Pack& a, const Pack& b) {
        Mask mask;
        for (int r = 0; r < registers; ++r)
            mask.m[r] = (Lanes)(a.v[r] <= b.v[r]);
        return mask;
    }
    VESICA_INLINE friend Mask operator>=(const Pack& a, const Pack& b) { return b <= a; }

    /// Lane k of the mask is bit k of `bits`.
    VESICA_INLINE static Mask mask(std::uint32_t bits) {
        struct LaneBits {
            Bits of[static_cast<std::size_t>(width)];
        };
        alignas(bytes_per_register) static constexpr LaneBits lane_bits = [] {
            LaneBits all{};
            for (int k = 0; k < width; ++k)
                all.of[k] = Bits{1} << k;
            return all;
        }();
        Mask mask;
        for (int r = 0; r < registers; ++r) {
            const Lanes lane_bit = *reinterpret_cast<const UnalignedBits*>(lane_bits.of + r * lanes);
            mask.m[r] = (Lanes)((lane_bit & static_cast<Bits>(bits)) != 0);
        }
        return mask;
    }
};

template <class T, int width>
struct scalar_of<Pack<T, width>> {
    using type = T;
};

template <class T, int width>
VESICA_INLINE Pack<T, width> select(const typename Pack<T, width>::Mask& mask, Pack<T, width> yes,
                                    const Pack<T, width>& no) {
    for (int r = 0; r < Pack<T, width>::registers; ++r)
        yes.v[r] = mask.m[r] ? yes.v[r] : no.v[r];
    return yes;
}

template <class T, int width>
VESICA_INLINE Pack<T, width> fma(Pack<T, width> a, const Pack<T, width>& b, const Pack<T, width>& c) {
    using P = Pack<T, width>;
    for (int r = 0; r < P::registers; ++r) {
#if defined(__AVX512F__)
        if constexpr (P::bytes_per_register == 64 && sizeof(T) == 8)
            a.v[r] = (typename P::Native)_mm512_fmadd_pd((__m512d)a.v[r], (__m512d)b.v[r], (__m512d)c.v[r]);
        else if constexpr (P::bytes_per_register == 64)
            a.v[r] = (typename P::Native)_mm512_fmadd_ps((__m512)a.v[r], (__m512)b.v[r], (__m512)c.v[r]);
        else
#endif
#if defined(__FMA__)
            if constexpr (P::bytes_per_register == 32 && sizeof(T) == 8)
            a.v[r] = (typename P::Native)_mm256_fmadd_pd((__m256d)a.v[r], (__m256d)b.v[r], (__m256d)c.v[r]);
        else if constexpr (P::bytes_per_register == 32)
            a.v[r] = (typename P::Native)_mm256_fmadd_ps((__m256)a.v[r], (__m256)b.v[r], (__m256)c.v[r]);
        else
#endif
            a.v[r] = a.v[r] * b.v[r] + c.v[r];
    }
    return a;
}

template <class T, int width>
VESICA_INLINE Pack<T, width> dot(const Vec3<Pack<T, width>>& a, const Vec3<Pack<T, width>>& b) {
    return fma<T>(a.x, b.x, fma<T>(a.y, b.y, a.z * b.z));
}

template <class T, int width>
VESICA_INLINE Pack<T, width> square_root(Pack<T, width> a) {
    using P = Pack<T, width>;
    for (int r = 0; r < P::registers; ++r) {
#if defined(__AVX512F__)
        if constexpr (P::bytes_per_register == 64 && sizeof(T) == 8) {
            a.v[r] = (typename P::Native)_mm512_sqrt_pd((__m512d)a.v[r]);
            continue;
        } else if constexpr (P::bytes_per_register == 64) {
            a.v[r] = (typename P::Native)_mm512_sqrt_ps((__m512)a.v[r]);
            continue;
        }
#endif
#if defined(__AVX__)
        if constexpr (P::bytes_per_register == 32 && sizeof(T) == 8) {
            a.v[r] = (typename P::Native)_mm256_sqrt_pd((__m256d)a.v[r]);
            continue;
        } else if constexpr (P::bytes_per_register == 32) {
            a.v[r] = (typename P::Native)_mm256_sqrt_ps((__m256)a.v[r]);
            continue;
        }
#endif
        for (int k = 0; k < P::lanes; ++k)
            a.v[r][k] = std::sqrt(a.v[r][k]);
    }
    return a;
}

template <class T, int width>
VESICA_INLINE Pack<T, width> larger(const Pack<T, width>& a, const Pack<T, width>& b) {
    return select<T>(a > b, a, b);
}

template <class T, int width>
VESICA_INLINE Pack<T, width> smaller(const Pack<T, width>& a, const Pack<T, width>& b) {
    return select<T>(a < b, a, b);
}

template <class T, int width>
VESICA_INLINE typename Pack<T, width>::Mask sign_bit(const Pack<T, width>& a) {
    typename Pack<T, width>::Mask mask;
    using Lanes = typename Pack<T, width>::Lanes;
    for (int r = 0; r < Pack<T, width>::registers; ++r)
        mask.m[r] = (Lanes)((Lanes)a.v[r] < 0);
    return mask;
}

template <class T, int width>
VESICA_INLINE Pack<T, width> magnitude(Pack<T, width> a) {
    using Lanes = typename Pack<T, width>::Lanes;
    using Bits = typename Pack<T, width>::Bits;
    for (int r = 0; r < Pack<T, width>::registers; ++r)
        a.v[r] = (typename Pack<T, width>::Native)((Lanes)a.v[r] & std::numeric_limits<Bits>::max());
    return a;
}

/// |a| with the sign bit set in the lanes of `negative`.
template <class T, int width>
VESICA_INLINE Pack<T, width> with_sign_bit(const typename Pack<T, width>::Mask& negative, Pack<T, width> a) {
    using Lanes = typename Pack<T, width>::Lanes;
    using Bits = typename Pack<T, width>::Bits;
    a = magnitude(a);
    for (int r = 0; r < Pack<T, width>::registers; ++r)
        a.v[r] = (typename Pack<T, width>::Native)((Lanes)a.v[r] |
                                                   (negative.m[r] & std::numeric_limits<Bits>::min()));
    return a;
}

/// Natural logarithm of positive normal numbers: x = 2^e m with m in [1/sqrt 2, sqrt 2),
/// ln x = e ln 2 + 2 artanh((m - 1)/(m + 1)). Relative error below 4e-16 (2e-7 in single), tested.
template <class T, int width>
VESICA_INLINE Pack<T, width> logarithm(const Pack<T, width>& x) {
    using P = Pack<T, width>;
    using Lanes = typename P::Lanes;
    using Word = std::make_unsigned_t<typename P::Bits>;
    typedef Word Words __attribute__((vector_size(sizeof(Lanes))));
    constexpr bool wide = sizeof(T) == 8;
    constexpr int mantissa = wide ? 52 : 23;
    // Bits of 1/sqrt 2, so that the mantissa lands in [1/sqrt 2, sqrt 2).
    constexpr Word pivot = wide ? static_cast<Word>(0x3fe6a09e667f3bcdULL) : static_cast<Word>(0x3f3504f3u);
    P e, m;
    for (int r = 0; r < P::registers; ++r) {
        // Without a sign, so that the logarithm of a negative number, in a run that breaks, is garbage but
        // defined.
        const Words bits = (Words)x.v[r];
        const Lanes exponent = (Lanes)(bits - pivot) >> mantissa;
        e.v[r] = __builtin_convertvector(exponent, typename P::Native);
        m.v[r] = (typename P::Native)(bits - ((Words)exponent << mantissa));
    }
    const P z = (m - P(1)) / (m + P(1));
    const P z2 = z * z;
    P series;
    if constexpr (wide) {
        series = P(2.0 / 23);
        for (int k = 21; k >= 3; k -= 2)
            series = fma<T>(series, z2, P(2.0 / k));
    } else {
        series = P(2.0 / 11);
        for (int k = 9; k >= 3; k -= 2)
            series = fma<T>(series, z2, P(2.0 / k));
    }
    // 2 z + z^3 series; ln 2 in two parts keeps the sum exact where e is large.
    constexpr double ln2_high = 6.93147180369123816490e-01;
    constexpr double ln2_low = 1.90821492927058770002e-10;
    const P correction = z * z2 * series;
    return fma<T>(e, P(ln2_high), fma<T>(e, P(ln2_low), correction) + P(2) * z);
}

} // namespace vesica
