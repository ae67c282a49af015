#pragma once

#include "case/parameters.hpp"

#include <cstdint>
#include <optional>

namespace vesica {

enum class PackedOrientation { random, aligned, spread };

/// Many vesicles of one type and shape that are to be packed into the box.
struct SuspensionParameters {
    VesicleParameters vesicle; ///< each of them; centre and axis mean nothing
    /// How many: of the fluid's volume, or counted.
    std::optional<double> haematocrit;
    std::optional<std::int64_t> count;
    PackedOrientation orientation = PackedOrientation::random;
    Vec3<double> axis{0.0, 0.0, 1.0}; ///< unless random
    double spread = 0.0;              ///< of directions about the axis: their r.m.s. angle, degrees
    std::optional<double> gap;        ///< between surfaces, cells; absent: 2/beta + 2
    std::uint64_t seed = 1;
    Vec3<int> region_begin{}; ///< inclusive
    Vec3<int> region_end{};   ///< exclusive

    friend bool operator==(const SuspensionParameters&, const SuspensionParameters&) = default;
};

} // namespace vesica
