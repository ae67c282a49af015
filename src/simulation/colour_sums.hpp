#pragma once

#include "core/exact_sum.hpp"
#include "core/vec3.hpp"
#include "parallel/ranks.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

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

    static constexpr std::size_t word_count = 5 * 3;
    using Words = std::array<std::uint64_t, word_count>;

    Words words() const {
        Words all{};
        std::size_t at = 0;
        for (const ExactSum* sum : {&mass, &momentum[0], &momentum[1], &momentum[2], &slid})
            for (const std::uint64_t word : sum->words())
                all[at++] = word;
        return all;
    }
    void add(const Words& words) {
        std::size_t at = 0;
        for (ExactSum* sum : {&mass, &momentum[0], &momentum[1], &momentum[2], &slid}) {
            *sum += ExactSum::from_words({words[at], words[at + 1], words[at + 2]});
            at += 3;
        }
    }
};

/// Of all ranks together, each as many.
inline std::vector<ColourSums> over_ranks(const Ranks& ranks, const std::vector<ColourSums>& own) {
    std::vector<ColourSums::Words> words;
    for (const ColourSums& sums : own)
        words.push_back(sums.words());
    const std::vector<std::byte> bytes = ranks.gather_to_all(std::as_bytes(std::span(words)));
    words.resize(bytes.size() / sizeof(ColourSums::Words));
    std::copy(bytes.begin(), bytes.end(), std::as_writable_bytes(std::span(words)).begin());
    std::vector<ColourSums> all(own.size());
    for (std::size_t k = 0; k < words.size(); ++k)
        all[k % own.size()].add(words[k]);
    return all;
}

} // namespace vesica
