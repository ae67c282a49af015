#pragma once

#include <string>

namespace vesica {

/// How well the diffuse interface resolves a surface, judged by beta times its smallest radius of curvature.
enum class Resolution {
    fine,    ///< at least 5
    note,    ///< below 5: forces are a few per cent off
    warning, ///< below 3.5
    error    ///< below 2: the layer is as thick as the surface is curved
};

inline constexpr double resolution_note = 5.0;
inline constexpr double resolution_warning = 3.5;
inline constexpr double resolution_error = 2.0;

/// segregation: beta, 1/cells; smallest_radius: of curvature, in modulus, cells. A number that is no number
/// or not positive is an error.
Resolution judge_resolution(double segregation, double smallest_radius);

/// One line that names the number, the limit it misses and what to change; empty when the resolution is fine.
std::string resolution_advice(double segregation, double smallest_radius);

} // namespace vesica
