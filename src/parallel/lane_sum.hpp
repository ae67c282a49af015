#pragma once

#include "parallel/pack.hpp"

#include <cstdint>

namespace vesica {

/// Sum of many packs whose result does not depend on the order of its terms: every number is rounded once to
/// a multiple of 2^-fraction_bits and added as an integer. Sums stay exact while |sum| < 2^(63 -
/// fraction_bits), terms while |term| < 2^(51 - fraction_bits); the caller picks fraction_bits from the known
/// range of the terms.
template <int fraction_bits>
class LaneSum {
public:
    template <class T, int width>
    VESICA_INLINE void add(const Pack<T, width>& term) {
        // x + 1.5 * 2^52 leaves round(x) in the low bits of the double: an integer without a conversion.
        constexpr double shifter = 6755399441055744.0;
        constexpr double scale = static_cast<double>(std::int64_t{1} << fraction_bits);
        for (int k = 0; k < width; ++k)
            lanes_[k % tile_width] +=
                std::bit_cast<std::uint64_t>(static_cast<double>(term[k]) * scale + shifter) -
                std::bit_cast<std::uint64_t>(shifter);
    }

    void merge(const LaneSum& other) {
        for (int k = 0; k < tile_width; ++k)
            lanes_[k] += other.lanes_[k];
    }

    double value() const { return static_cast<double>(total()) / unit; }

    /// For messages between ranks: the integer all terms add up to, in two halves that add up each by itself,
    /// so that sums of many ranks may be larger than a rank's own.
    struct Halves {
        std::uint64_t low = 0;
        std::uint64_t high = 0; ///< two's complement

        double value() const {
            return (static_cast<double>(static_cast<std::int64_t>(high)) * 0x1p32 +
                    static_cast<double>(low)) /
                   unit;
        }
    };
    Halves halves() const {
        const std::int64_t sum = total();
        return {static_cast<std::uint64_t>(sum) & 0xffffffff, static_cast<std::uint64_t>(sum >> 32)};
    }

private:
    static constexpr double unit = static_cast<double>(std::int64_t{1} << fraction_bits);

    std::int64_t total() const {
        std::uint64_t sum = 0;
        for (const std::uint64_t lane : lanes_)
            sum += lane;
        return static_cast<std::int64_t>(sum);
    }

    std::uint64_t lanes_[tile_width] = {}; ///< two's complement: out of range it wraps, and is defined
};

} // namespace vesica
