#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>

namespace vesica {

/// The parts of a step, in the order they are done; transport goes along with the fluid, and waiting for
/// other ranks with all of them.
enum class StepPart { fluid, transport, locate, follow, normals, curvatures, slopes, forces, waiting };

inline constexpr std::size_t step_part_count = 9;

constexpr const char* name_of(StepPart part) {
    constexpr const char* names[step_part_count] = {"fluid",      "transport", "locate", "follow", "normals",
                                                    "curvatures", "slopes",    "forces", "waiting"};
    return names[static_cast<std::size_t>(part)];
}

/// Where the time of the steps of this process went.
struct StepProfile {
    std::int64_t steps = 0;
    double cells = 0.0;                            ///< worked on, summed over the steps
    double interface_cells = 0.0;                  ///< of them in interface bands
    std::array<double, step_part_count> seconds{}; ///< of wall time, by part

    double of(StepPart part) const { return seconds[static_cast<std::size_t>(part)]; }
    double total() const {
        double sum = 0.0;
        for (const double part : seconds)
            sum += part;
        return sum;
    }

    /// Nanoseconds of one core: for a cell, without a membrane; and what a cell of an interface band costs
    /// more.
    double per_cell(int threads) const;
    double per_interface_cell(int threads) const;

    std::map<std::string, double> numbers(int threads) const; ///< for summary.json
    std::string text(int threads) const;                      ///< a table for people

private:
    static double core_nanoseconds(double part_seconds, double per, int threads);
};

/// Charges wall time to the part entered last, by one reading of the clock per part.
template <class Clock>
class BasicStepClock {
public:
    /// A step begins with this part; what goes on between steps is nobody's.
    void begin(StepPart part) {
        since_ = Clock::now();
        part_ = static_cast<std::size_t>(part);
        running_ = true;
    }

    /// Nothing outside a step, so that the passes of a step can be used there as well.
    void enter(StepPart part) {
        if (!running_)
            return;
        settle();
        part_ = static_cast<std::size_t>(part);
    }

    /// So much of the time of the part that is going on is another's. Nothing outside a step.
    void concede(StepPart to, double seconds) {
        if (!running_)
            return;
        profile_.seconds[static_cast<std::size_t>(to)] += seconds;
        profile_.seconds[part_] -= seconds;
    }

    /// The step is done.
    void leave(double cells, double interface_cells) {
        settle();
        running_ = false;
        ++profile_.steps;
        profile_.cells += cells;
        profile_.interface_cells += interface_cells;
    }

    const StepProfile& profile() const { return profile_; }

private:
    void settle() {
        const typename Clock::time_point now = Clock::now();
        profile_.seconds[part_] += std::chrono::duration<double>(now - since_).count();
        since_ = now;
    }

    StepProfile profile_;
    typename Clock::time_point since_;
    std::size_t part_ = 0;
    bool running_ = false;
};

using StepClock = BasicStepClock<std::chrono::steady_clock>;

} // namespace vesica
