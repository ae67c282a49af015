#include "core/quantity.hpp"

#include "core/unit_table.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace vesica {
namespace {

struct DimensionWords {
    Dimension dimension;
    std::string_view name;
    std::string_view unit;
    std::string_view example;
};

constexpr std::array<DimensionWords, 19> words{{
    {dimension::none, "pure number", "", "0.5"},
    {dimension::length, "length", "m", "3.9 um"},
    {dimension::area, "area", "m^2", "134 um^2"},
    {dimension::volume, "volume", "m^3", "94 um^3"},
    {dimension::curvature, "curvature", "1/m", "0.5 1/um"},
    {dimension::time, "time", "s", "0.2 s"},
    {dimension::rate, "rate", "1/s", "100 1/s"},
    {dimension::velocity, "velocity", "m/s", "1 mm/s"},
    {dimension::acceleration, "acceleration", "m/s^2", "9.81 m/s^2"},
    {dimension::kinematic_viscosity, "kinematic viscosity", "m^2/s", "1.2e-6 m^2/s"},
    {dimension::mass, "mass", "kg", "1e-13 kg"},
    {dimension::density, "density", "kg/m^3", "1000 kg/m^3"},
    {dimension::dynamic_viscosity, "dynamic viscosity", "Pa s", "1.2 mPa s"},
    {dimension::pressure, "pressure", "Pa", "10 Pa"},
    {dimension::tension, "tension", "N/m", "1e-6 N/m"},
    {dimension::force, "force", "N", "5 pN"},
    {dimension::energy, "energy", "J", "2e-19 J"},
    {dimension::force_density, "force per volume", "N/m^3", "1000 N/m^3"},
    {dimension::tension_per_area_squared, "tension per area squared", "N/m^5", "1e15 N/m^5"},
}};

const DimensionWords* find_words(const Dimension& dimension) {
    for (const DimensionWords& entry : words) {
        if (entry.dimension == dimension)
            return &entry;
    }
    return nullptr;
}

std::string exponents(const Dimension& dimension) {
    std::string text;
    const auto add = [&text](std::string_view symbol, int exponent) {
        if (exponent == 0)
            return;
        if (!text.empty())
            text += ' ';
        text += symbol;
        if (exponent != 1)
            text += fmt::format("^{}", exponent);
    };
    add("kg", dimension.mass);
    add("m", dimension.length);
    add("s", dimension.time);
    return text;
}

} // namespace

QuantityError::QuantityError(std::string_view text, const std::string& advice)
    : InputError(fmt::format("\"{}\" is no quantity; {}", text, advice)), advice_(advice) {}

std::string dimension_name(const Dimension& dimension) {
    const DimensionWords* entry = find_words(dimension);
    return entry ? std::string(entry->name) : exponents(dimension);
}

std::string si_unit(const Dimension& dimension) {
    const DimensionWords* entry = find_words(dimension);
    return entry ? std::string(entry->unit) : exponents(dimension);
}

std::string example_quantity(const Dimension& dimension) {
    const DimensionWords* entry = find_words(dimension);
    return entry ? std::string(entry->example) : "1 " + exponents(dimension);
}

std::string to_text(const Quantity& quantity) {
    const std::string unit = si_unit(quantity.dimension);
    if (unit.empty())
        return fmt::format("{:.6g}", quantity.value);
    // Only a unit that stands alone and to the first power takes a prefix: mm^2 would read as (mm)^2.
    const bool prefixed = quantity.dimension == dimension::length || quantity.dimension == dimension::time ||
                          quantity.dimension == dimension::velocity ||
                          quantity.dimension == dimension::pressure ||
                          quantity.dimension == dimension::dynamic_viscosity;
    struct Prefix {
        double factor;
        std::string_view symbol;
    };
    constexpr std::array<Prefix, 5> prefixes{
        {{1.0, ""}, {1e-3, "m"}, {1e-6, "u"}, {1e-9, "n"}, {1e-12, "p"}}};
    const double magnitude = std::abs(quantity.value);
    if (prefixed && magnitude >= 1e-12) {
        for (const Prefix& prefix : prefixes) {
            if (magnitude >= prefix.factor * (1.0 - 1e-9))
                return fmt::format("{:.6g} {}{}", quantity.value / prefix.factor, prefix.symbol, unit);
        }
    }
    return fmt::format("{:.6g} {}", quantity.value, unit);
}

} // namespace vesica
