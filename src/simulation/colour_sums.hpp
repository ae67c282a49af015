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
    ExactSum slid; ///< mass times the boxes upwards, across sliding faces, to the image that counts

    void add(double density, const Vec3<double>& u, double boxes_slid = 0.0) {
        mass.add(density);
        slid.add(density * boxes_slid);
        for (int a = 0; a < 3; ++a)
            momentum[a].add(density * u[a]);
    }

    /// Of all ranks together.
    ColourSums over(const Ranks& ranks) const {
        using Words = std::array<std::uint64_t, 3>;
        const std::array<Words, 5> own = {mass.words(), momentum[0].words(), momentum[1].words(),
                                          momentum[2].words(), slid.words()};
        ColourSums all;
        for (const std::array<Words, 5>& rank : ranks.gather_all(own)) {
            all.mass += ExactSum::from_words(rank[0]);
            for (std::size_t a = 0; a < 3; ++a)
                all.momentum[a] += ExactSum::from_words(rank[a + 1]);
            all.slid += ExactSum::from_words(rank[4]);
        }
        return all;
    }
};

} // namespace vesica
