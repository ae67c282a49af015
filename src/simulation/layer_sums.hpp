#pragma once

#include "parallel/lane_sum.hpp"
#include "parallel/ranks.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vesica {

/// Sums over a vesicle's layer, independent of the order they are made in.
struct LayerSums {
    double raw_area = 0.0;              ///< sum (beta/2)(1 - phi^2)
    double gaussian_curvature = 0.0;    ///< int K dA
    double square_mean_curvature = 0.0; ///< int H^2 dA
    double red = 0.0;                   ///< sum rho_R/rho over all cells
};

/// What a thread's share of a label's transport amounts to.
struct TransportSums {
    LaneSum<50> leaked; ///< red that left the band, in cells' worth of fluid
    LaneSum<38> layer;  ///< 1 - phi^2
};

/// Exact sums, one for each thread and label. Memory is reused.
template <int fraction_bits>
class LabelSums {
public:
    using Halves = typename LaneSum<fraction_bits>::Halves;

    void reset(int threads, int labels) {
        labels_ = static_cast<std::size_t>(labels);
        sums_.assign(static_cast<std::size_t>(threads) * labels_, {});
    }
    LaneSum<fraction_bits>& of(int thread, int label) {
        return sums_[static_cast<std::size_t>(thread) * labels_ + static_cast<std::size_t>(label)];
    }
    /// Of a label, of all threads together.
    LaneSum<fraction_bits> total(int label) const {
        LaneSum<fraction_bits> sum;
        for (std::size_t at = static_cast<std::size_t>(label); at < sums_.size(); at += labels_)
            sum.merge(sums_[at]);
        return sum;
    }
    std::size_t bytes() const { return sums_.capacity() * sizeof(LaneSum<fraction_bits>); }

private:
    std::size_t labels_ = 0;
    std::vector<LaneSum<fraction_bits>> sums_;
};

/// Values of sums over the ranks, for every label, in one message: take(label, values of its sums).
class SumsOverRanks {
public:
    template <class Take, class... Sums>
    void operator()(const Ranks& ranks, int labels, const Take& take, const Sums&... sums) {
        constexpr std::size_t count = sizeof...(Sums);
        words_.clear();
        for (int label = 0; label < labels; ++label)
            (..., append(sums.total(label).halves()));
        ranks.sum(words_);
        std::size_t at = 0;
        for (int label = 0; label < labels; ++label) {
            std::array<double, count> values{};
            std::size_t k = 0;
            (..., (values[k++] = value_of<typename Sums::Halves>(at)));
            take(label, values);
        }
    }

private:
    template <class Halves>
    void append(const Halves& halves) {
        words_.push_back(halves.low);
        words_.push_back(halves.high);
    }
    template <class Halves>
    double value_of(std::size_t& at) const {
        Halves halves;
        halves.low = words_[at++];
        halves.high = words_[at++];
        return halves.value();
    }

    std::vector<std::uint64_t> words_;
};

} // namespace vesica
