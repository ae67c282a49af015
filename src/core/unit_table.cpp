#include "core/unit_table.hpp"

#include <array>
#include <cctype>
#include <utility>

namespace vesica::detail {
namespace {

struct NamedUnit {
    std::string_view symbol;
    double factor;
    Dimension dimension;
    bool takes_prefix;
};

constexpr std::array<NamedUnit, 13> units{{
    {"m", 1.0, dimension::length, true},
    {"s", 1.0, dimension::time, true},
    {"g", 1e-3, dimension::mass, true},
    {"N", 1.0, dimension::force, true},
    {"Pa", 1.0, dimension::pressure, true},
    {"J", 1.0, dimension::energy, true},
    {"Hz", 1.0, dimension::rate, true},
    {"L", 1e-3, dimension::volume, true},
    {"P", 0.1, dimension::dynamic_viscosity, true},
    {"dyn", 1e-5, dimension::force, true},
    {"erg", 1e-7, dimension::energy, true},
    {"min", 60.0, dimension::time, false},
    {"h", 3600.0, dimension::time, false},
}};

// U+00B5 is the micro sign, U+03BC the Greek letter; keyboards produce either. A litre may be written l.
constexpr std::array<std::pair<std::string_view, double>, 14> prefixes{{
    {"a", 1e-18},
    {"f", 1e-15},
    {"p", 1e-12},
    {"n", 1e-9},
    {"u", 1e-6},
    {"\u00B5", 1e-6},
    {"\u03BC", 1e-6},
    {"m", 1e-3},
    {"c", 1e-2},
    {"d", 1e-1},
    {"k", 1e3},
    {"M", 1e6},
    {"G", 1e9},
    {"T", 1e12},
}};

constexpr std::array<std::pair<std::string_view, std::string_view>, 24> misspellings{{
    {"sec", "s"},         {"second", "s"},      {"seconds", "s"}, {"minute", "min"}, {"minutes", "min"},
    {"hr", "h"},          {"hour", "h"},        {"hours", "h"},   {"micron", "um"},  {"microns", "um"},
    {"micrometer", "um"}, {"micrometre", "um"}, {"meter", "m"},   {"metre", "m"},    {"meters", "m"},
    {"metres", "m"},      {"newton", "N"},      {"pascal", "Pa"}, {"joule", "J"},    {"joules", "J"},
    {"hertz", "Hz"},      {"poise", "P"},       {"liter", "L"},   {"litre", "L"},
}};

std::optional<Unit> plain_unit(std::string_view symbol, bool with_prefix) {
    if (symbol == "l")
        symbol = "L";
    for (const NamedUnit& unit : units) {
        if (unit.symbol == symbol && (unit.takes_prefix || !with_prefix))
            return Unit{unit.factor, unit.dimension};
    }
    return std::nullopt;
}

std::string lower(std::string_view word) {
    std::string result;
    for (const char c : word)
        result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return result;
}

} // namespace

std::optional<Unit> find_unit(std::string_view symbol) {
    if (auto unit = plain_unit(symbol, false))
        return unit; // "min" is a minute, never a milli-inch
    for (const auto& [prefix, factor] : prefixes) {
        if (!symbol.starts_with(prefix))
            continue;
        if (auto unit = plain_unit(symbol.substr(prefix.size()), true)) {
            // 1e-3 * 1e3 would be exact, 1e-6 * 1e-3 is not: kilograms are the base and must stay so.
            if (unit->dimension == dimension::mass && factor == 1e3)
                return Unit{1.0, dimension::mass};
            return Unit{unit->factor * factor, unit->dimension};
        }
    }
    return std::nullopt;
}

std::string meant_unit(std::string_view word) {
    const std::string small = lower(word);
    for (const auto& [wrong, right] : misspellings) {
        if (small == wrong)
            return std::string(right);
    }
    for (const NamedUnit& unit : units) {
        if (lower(unit.symbol) == small)
            return std::string(unit.symbol);
    }
    for (const auto& [prefix, factor] : prefixes) {
        for (const NamedUnit& unit : units) {
            if (unit.takes_prefix && lower(std::string(prefix) + std::string(unit.symbol)) == small)
                return std::string(prefix) + std::string(unit.symbol);
        }
    }
    return {};
}

std::string_view known_units() {
    return "m, s, kg, g, N, Pa, J, Hz, L, P, dyn, erg with a prefix, min and h";
}

} // namespace vesica::detail
