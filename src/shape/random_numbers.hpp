#pragma once

#include "core/vec3.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace vesica {

/// Seeded random numbers: uniform ones the same everywhere, the others as far as the mathematical library is.
class RandomNumbers {
public:
    explicit RandomNumbers(std::uint64_t seed) : engine_(seed) {}

    /// In [0, 1): the upper 53 bits.
    double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

    /// Standard normal and independent, two per pair of uniform ones (Box & Muller 1958).
    double gaussian() {
        if (has_spare_) {
            has_spare_ = false;
            return spare_;
        }
        const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
        const double angle = 2.0 * std::numbers::pi * uniform();
        spare_ = radius * std::sin(angle);
        has_spare_ = true;
        return radius * std::cos(angle);
    }

    /// A unit vector, all directions alike.
    Vec3<double> direction() {
        const double z = 2.0 * uniform() - 1.0;
        const double angle = 2.0 * std::numbers::pi * uniform();
        const double r = std::sqrt(1.0 - z * z);
        return {r * std::cos(angle), r * std::sin(angle), z};
    }

private:
    std::mt19937_64 engine_;
    double spare_ = 0.0;
    bool has_spare_ = false;
};

} // namespace vesica
