#pragma once

#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>

namespace vesica {

/// A sum of doubles whose result does not depend on the order or grouping of its terms.
///
/// Every term is rounded once, to the nearest multiple of 2^-64 (ties away from zero), and added as a 128-bit
/// two's complement integer. Integer addition is associative and commutative, so any number of threads and
/// ranks gives the same bits (cf. Demmel & Nguyen 2015, "Parallel Reproducible Summation").
///
/// Range: |term| <= 2^40 and |sum| < 2^63. A term of modulus above 2^-12 is held exactly; a smaller one with
/// an absolute error of at most 2^-65 = 2.7e-20. A term that is not a number or out of range, and a sum that
/// overflows, are programmer's errors or a run gone wrong: overflow is asserted, and value() is NaN from then
/// on.
class ExactSum {
public:
    static constexpr double largest_term = 0x1p40;

    ExactSum() = default;

    void add(double term) {
        if (!(std::abs(term) <= largest_term)) {
            assert(!std::isfinite(term)); // a finite term out of range is ours to scale
            poisoned_ = true;
            return;
        }
        accumulate(fixed_point(term));
    }

    ExactSum& operator+=(double term) {
        add(term);
        return *this;
    }

    /// Merges the terms of another sum.
    ExactSum& operator+=(const ExactSum& other) {
        poisoned_ = poisoned_ || other.poisoned_;
        accumulate(other.total_);
        return *this;
    }

    /// The sum, rounded once to the nearest double; NaN if a term was not a number or out of range.
    double value() const {
        if (poisoned_)
            return std::numeric_limits<double>::quiet_NaN();
        return static_cast<double>(total_) * 0x1p-64;
    }

    /// The state as plain words for messages between ranks: low half, high half, 1 if poisoned.
    std::array<std::uint64_t, 3> words() const {
        const auto bits = static_cast<Unsigned128>(total_);
        return {static_cast<std::uint64_t>(bits), static_cast<std::uint64_t>(bits >> 64),
                poisoned_ ? 1u : 0u};
    }

    static ExactSum from_words(const std::array<std::uint64_t, 3>& words) {
        ExactSum sum;
        sum.total_ = static_cast<Signed128>((static_cast<Unsigned128>(words[1]) << 64) | words[0]);
        sum.poisoned_ = words[2] != 0;
        return sum;
    }

    friend bool operator==(const ExactSum&, const ExactSum&) = default;

private:
    __extension__ typedef __int128 Signed128;            // NOLINT(modernize-use-using): `using` takes no
    __extension__ typedef unsigned __int128 Unsigned128; // NOLINT(modernize-use-using): __extension__

    // Taken from the bits, not by std::ldexp and std::nearbyint: faster, and blind to the rounding mode.
    static Signed128 fixed_point(double term) {
        static_assert(std::numeric_limits<double>::is_iec559);
        const auto bits = std::bit_cast<std::uint64_t>(term);
        const int exponent = static_cast<int>((bits >> 52) & 0x7ff);
        if (exponent == 0)
            return 0; // zero and subnormals, far below 2^-65
        const std::uint64_t mantissa = (bits & ((std::uint64_t{1} << 52) - 1)) | (std::uint64_t{1} << 52);
        const int shift = exponent - 1075 + 64; // term = mantissa 2^(exponent - 1075)
        Signed128 magnitude = 0;
        if (shift >= 0)
            magnitude = static_cast<Signed128>(mantissa) << shift;
        else if (shift > -54)
            magnitude = static_cast<Signed128>((mantissa + (std::uint64_t{1} << (-shift - 1))) >> -shift);
        return (bits >> 63) != 0 ? -magnitude : magnitude;
    }

    void accumulate(Signed128 term) {
        const bool overflow = __builtin_add_overflow(total_, term, &total_);
        assert(!overflow && "the exact sum left its range");
        poisoned_ = poisoned_ || overflow;
    }

    Signed128 total_ = 0;
    bool poisoned_ = false;
};

} // namespace vesica
