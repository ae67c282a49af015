#pragma once

#include "core/input_error.hpp"

#include <string>
#include <string_view>

namespace vesica {

/// Exponents of length, time and mass; {2, -1, 0} is a kinematic viscosity.
struct Dimension {
    int length = 0;
    int time = 0;
    int mass = 0;

    friend constexpr bool operator==(const Dimension&, const Dimension&) = default;
    friend constexpr Dimension operator*(const Dimension& a, const Dimension& b) {
        return {a.length + b.length, a.time + b.time, a.mass + b.mass};
    }
    friend constexpr Dimension operator/(const Dimension& a, const Dimension& b) {
        return {a.length - b.length, a.time - b.time, a.mass - b.mass};
    }
};

namespace dimension {
inline constexpr Dimension none{};
inline constexpr Dimension length{1, 0, 0};
inline constexpr Dimension area{2, 0, 0};
inline constexpr Dimension volume{3, 0, 0};
inline constexpr Dimension curvature{-1, 0, 0};
inline constexpr Dimension time{0, 1, 0};
inline constexpr Dimension rate{0, -1, 0};
inline constexpr Dimension velocity{1, -1, 0};
inline constexpr Dimension acceleration{1, -2, 0};
inline constexpr Dimension kinematic_viscosity{2, -1, 0};
inline constexpr Dimension mass{0, 0, 1};
inline constexpr Dimension density{-3, 0, 1};
inline constexpr Dimension dynamic_viscosity{-1, -1, 1};
inline constexpr Dimension pressure{-1, -2, 1};
inline constexpr Dimension tension{0, -2, 1};
inline constexpr Dimension force{1, -2, 1};
inline constexpr Dimension energy{2, -2, 1};
inline constexpr Dimension force_density{-2, -2, 1};
/// The factor alpha of the paper's area constraint, sigma_A = (alpha/2) A (A - A0).
inline constexpr Dimension tension_per_area_squared{-4, -2, 1};
} // namespace dimension

/// What a dimension is called ("length"), or its exponents in SI ("kg m^2 s^-3") where it has no name here.
std::string dimension_name(const Dimension& dimension);

/// The SI unit in which quantities of this dimension are written ("Pa s"); empty for a pure number.
std::string si_unit(const Dimension& dimension);

/// A quantity such as a user would type it, to show in messages: "3.9 um" for a length, "2e-19 J" for an
/// energy.
std::string example_quantity(const Dimension& dimension);

/// A number in SI base units (m, s, kg) with its dimension; lattice numbers are plain doubles.
struct Quantity {
    double value = 0.0;
    Dimension dimension;

    friend constexpr bool operator==(const Quantity&, const Quantity&) = default;
};

/// Text that should be a quantity and is none. what() reads `"TEXT" is no quantity; ADVICE`.
class QuantityError : public InputError {
public:
    QuantityError(std::string_view text, const std::string& advice);

    /// `expected ...; try ...`, for callers who name the value themselves.
    const std::string& advice() const { return advice_; }

private:
    std::string advice_;
};

/// Reads a number and its unit: "3.9 um", "100 1/s", "1.2 mPa s", "0.25 µm", "1000 kg/m^3", "2 h".
/// Units: m s kg g N Pa J Hz L P(oise) dyn erg with the prefixes a f p n u µ m c d k M G T; min h; products
/// by a space, `*` or `·`, quotients by `/` (which divides by the next unit only, so that a product after it
/// needs parentheses), powers by `^` or one superscript digit. Throws QuantityError.
Quantity parse_quantity(std::string_view text);

/// The quantity in readable units, six digits: "3.9 um", "1.2 mPa s", "2e-19 J".
std::string to_text(const Quantity& quantity);

} // namespace vesica
