#pragma once

#include "core/vec3.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vesica {

/// Which cells of a box are solid, a bit for each.
class SolidVoxels {
public:
    SolidVoxels() = default;
    explicit SolidVoxels(const Vec3<int>& size)
        : size_(size),
          bits_((static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
                     static_cast<std::size_t>(size.z) +
                 7) /
                8) {}

    const Vec3<int>& size() const { return size_; }
    bool at(const Vec3<int>& cell) const {
        const std::size_t k = index(cell);
        return (bits_[k / 8] >> (k % 8) & 1) != 0;
    }
    void set(const Vec3<int>& cell) {
        const std::size_t k = index(cell);
        bits_[k / 8] |= static_cast<std::uint8_t>(1u << (k % 8));
    }
    std::size_t count() const {
        std::size_t sum = 0;
        for (const std::uint8_t bits : bits_)
            sum += static_cast<std::size_t>(__builtin_popcount(bits));
        return sum;
    }

    friend bool operator==(const SolidVoxels&, const SolidVoxels&) = default;

private:
    std::size_t index(const Vec3<int>& cell) const {
        return (static_cast<std::size_t>(cell.z) * static_cast<std::size_t>(size_.y) +
                static_cast<std::size_t>(cell.y)) *
                   static_cast<std::size_t>(size_.x) +
               static_cast<std::size_t>(cell.x);
    }

    Vec3<int> size_{};
    std::vector<std::uint8_t> bits_;
};

} // namespace vesica
