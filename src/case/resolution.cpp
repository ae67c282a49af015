#include "case/resolution.hpp"

#include <fmt/format.h>

namespace vesica {

Resolution judge_resolution(double segregation, double smallest_radius) {
    const double cells = segregation * smallest_radius;
    if (cells >= resolution_note)
        return Resolution::fine;
    if (cells >= resolution_warning)
        return Resolution::note;
    if (cells >= resolution_error)
        return Resolution::warning;
    return Resolution::error; // and so is NaN
}

std::string resolution_advice(double segregation, double smallest_radius) {
    const Resolution verdict = judge_resolution(segregation, smallest_radius);
    if (verdict == Resolution::fine)
        return {};
    const double limit = verdict == Resolution::note      ? resolution_note
                         : verdict == Resolution::warning ? resolution_warning
                                                          : resolution_error;
    const double scale = resolution_note / (segregation * smallest_radius);
    std::string text =
        fmt::format("segregation times the smallest radius of curvature is {:.3g}; expected at least {}",
                    segregation * smallest_radius, limit);
    if (scale > 1.0 && scale < 1e3)
        text += fmt::format("; try a radius {:.2g} times as large for {}", scale, resolution_note);
    return text;
}

} // namespace vesica
