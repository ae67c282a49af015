#pragma once

#include "core/real.hpp"

#include <algorithm>
#include <cstdint>

namespace vesica {

/// The area a membrane should have, ramped linearly from the initial area.
struct AreaTarget {
    double initial = 0.0;
    double final = 0.0;
    std::int64_t ramp = 0; ///< steps

    double at(std::int64_t step) const {
        if (step >= ramp)
            return final;
        return initial + (final - initial) * (static_cast<double>(step) / static_cast<double>(ramp));
    }
};

/// sigma_A = K_A (A - A0)/A0: area too large, tension positive.
struct AreaPenalty {
    double modulus = 0.0;

    double tension(double area, double target) const { return modulus * (area - target) / target; }
};

/// sigma_A = (alpha/2) A (A - A0) (Spendlove et al. 2021, Eq 29): a penalty with K_A = alpha A A0/2.
struct PaperAreaPenalty {
    double alpha = 0.0;

    double tension(double area, double target) const { return 0.5 * alpha * area * (area - target); }
};

/// The tension that holds A = A_target(t), by a proportional-integral-derivative law on the relative excess
/// area e:
///   sigma_A = K (e + (1/T_i) int e dt + T_d de/dt).
/// K stays below eta R per step, where an explicit area spring becomes unstable. Compression is limited to
/// what buckles a sphere into its l = 2 mode only (-12 < (sigma + sigma_A) R^2/kappa): beyond, wrinkles and
/// starfish grow faster than the shape wanted. While the limit acts the integral is frozen. The first tension
/// takes up sigma, which a held area makes redundant: a membrane that had to wait for the integral would be
/// smoothed by sigma alone for R/nu steps, and a perturbation would be gone before the area begins to grow.
class AreaMultiplier {
public:
    struct Gains {
        double proportional = 0.0;    ///< K, tension
        double integral_time = 1.0;   ///< T_i, steps
        double derivative_time = 0.0; ///< T_d, steps
        double lowest_tension = 0.0;  ///< of sigma_A
        double first_tension = 0.0;   ///< sigma_A of a membrane that begins with its target area
    };
    struct State {
        double integral = 0.0; ///< int e dt, steps
        double previous_excess = 0.0;
        bool started = false;
    };

    AreaMultiplier() = default;
    explicit AreaMultiplier(const Gains& gains) : gains_(gains) {
        if (gains.proportional > 0.0)
            state_.integral = gains.first_tension * gains.integral_time / gains.proportional;
    }

    double tension(double area, double target) {
        const double excess = (area - target) / target;
        const double rate = state_.started ? excess - state_.previous_excess : 0.0;
        state_.previous_excess = excess;
        state_.started = true;
        const double integral = state_.integral + excess;
        const auto law = [&](double sum) {
            return gains_.proportional *
                   (excess + sum / gains_.integral_time + gains_.derivative_time * rate);
        };
        const double wanted = law(integral);
        if (wanted >= gains_.lowest_tension || excess > 0.0)
            state_.integral = integral;
        return std::max(wanted, gains_.lowest_tension);
    }

    const State& state() const { return state_; }
    void restore(const State& state) { state_ = state; }

private:
    Gains gains_;
    State state_;
};

} // namespace vesica
