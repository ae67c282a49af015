#pragma once

#include "core/exact_sum.hpp"
#include "core/vec3.hpp"
#include "parallel/ranks.hpp"

#include <array>
#include <cstdint>

namespace vesica {

/// Mass and momentum of a colour, exact sums.
struct ColourSums {
    ExactSum mass;
    ExactSum momentum[3];

    void add(double density, const Vec3<double>& u) {
        mass.add(density);
        for (int a = 0; a < 3; ++a)
            momentum[a].add(density * u[a]);
    }

    /// Of all ranks together.
    ColourSums over(const Ranks& ranks) const {
        using Words = std::array<std::uint64_t, 3>;
        const std::array<Words, 4> own = {mass.words(), momentum[0].words(), momentum[1].words(),
                                          momentum[2].words()};
        ColourSums all;
        for (const std::array<Words, 4>& rank : ranks.gather_all(own)) {
            all.mass += ExactSum::from_words(rank[0]);
            for (std::size_t a = 0; a < 3; ++a)
                all.momentum[a] += ExactSum::from_words(rank[a + 1]);
        }
        return all;
    }
};

} // namespace vesica
