#pragma once

#include "simulation/lattice_engine.hpp"

#include <cmath>
#include <numbers>

namespace vesica {

namespace detail {

/// A mean of positions that counts a box's periodic images as one: each adds its direction round the box.
class CircularMean {
public:
    explicit CircularMean(double period) : turn_(2.0 * std::numbers::pi / period) {}

    void add(double place, double count) {
        sine_ += count * std::sin(turn_ * place);
        cosine_ += count * std::cos(turn_ * place);
    }
    double value() const {
        const double angle = std::atan2(sine_, cosine_) / turn_;
        return angle < 0.0 ? angle + 2.0 * std::numbers::pi / turn_ : angle;
    }

private:
    double turn_;
    double sine_ = 0.0;
    double cosine_ = 0.0;
};

} // namespace detail

/// A point near each vesicle's middle: the circular mean of its core's cells, so that periodic images do not
/// matter. They are counted plane by plane: the same bits however the box is shared out.
template <class Real>
std::vector<Vec3<double>> LatticeEngine<Real>::middles() const {
    const Vec3<int> box = block_.box;
    const auto for_each_core_cell = [&](const auto& body) {
        for (const BandTile& t : layer_.band().tiles())
            for (int k = 0; k < tile_width; ++k)
                if ((t.bits[0] >> k & 1) != 0)
                    body(static_cast<std::size_t>(t.label),
                         grid_.tile_origin(t.tile) + block_.own.begin + Vec3<int>{k, 0, 0});
    };
    const std::size_t begins[3] = {0, static_cast<std::size_t>(box.x),
                                   static_cast<std::size_t>(box.x + box.y)};
    const std::size_t planes = begins[2] + static_cast<std::size_t>(box.z);
    std::vector<Vec3<double>> middles(membranes_.size());
    std::vector<std::uint64_t> counts(planes * middles.size(), 0);
    for_each_core_cell([&](std::size_t label, const Vec3<int>& cell) {
        for (int a = 0; a < 3; ++a)
            ++counts[label * planes + begins[a] + static_cast<std::size_t>(cell[a])];
    });
    ranks().sum(counts);
    for (std::size_t label = 0; label < middles.size(); ++label)
        for (int a = 0; a < 3; ++a) {
            detail::CircularMean mean(box[a]);
            for (int k = 0; k < box[a]; ++k)
                mean.add(k + 0.5, static_cast<double>(
                                      counts[label * planes + begins[a] + static_cast<std::size_t>(k)]));
            middles[label][a] = mean.value();
        }
    if (!block_.slide)
        return middles;
    // Images that have slid are counted apart: below, home, above.
    const auto [across, along] = *block_.slide;
    const auto length = static_cast<std::size_t>(box[along]);
    counts.assign(3 * length * middles.size(), 0);
    for_each_core_cell([&](std::size_t label, const Vec3<int>& cell) {
        const auto image = 1 - std::lround((cell[across] + 0.5 - middles[label][across]) / box[across]);
        ++counts[(3 * label + static_cast<std::size_t>(image)) * length +
                 static_cast<std::size_t>(cell[along])];
    });
    ranks().sum(counts);
    const double slid = setup_.drive.displacement(step_);
    for (std::size_t label = 0; label < middles.size(); ++label) {
        detail::CircularMean mean(box[along]);
        for (std::size_t k = 0; k < 3 * length; ++k)
            mean.add(static_cast<double>(k % length) + 0.5 + (static_cast<double>(k / length) - 1.0) * slid,
                     static_cast<double>(counts[3 * length * label + k]));
        middles[label][along] = mean.value();
    }
    return middles;
}

} // namespace vesica
