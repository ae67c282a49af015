#include "core/quantity.hpp"
#include "core/unit_table.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace vesica {
namespace {

using detail::Unit;

constexpr std::string_view middle_dot = "\u00B7";
constexpr std::string_view superscript_minus = "\u207B";
constexpr std::array<std::string_view, 10> superscripts{"\u2070", "\u00B9", "\u00B2", "\u00B3", "\u2074",
                                                        "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};

constexpr std::size_t longest_text = 80;
constexpr int largest_exponent = 9;

Unit power(const Unit& unit, int exponent) {
    return {
        std::pow(unit.factor, exponent),
        {unit.dimension.length * exponent, unit.dimension.time * exponent, unit.dimension.mass * exponent}};
}

/// Recursive descent over `product := factor { ("*" | "·" | space | "/") factor }`,
/// `factor := ("1" | symbol | "(" product ")") [exponent]`.
class UnitParser {
public:
    UnitParser(std::string_view whole, std::string_view rest) : whole_(whole), rest_(rest) {}

    Unit parse() {
        const Unit unit = product();
        if (!rest_.empty())
            fail(fmt::format("expected the unit to end before \"{}\"", rest_));
        return unit;
    }

private:
    [[noreturn]] void fail(const std::string& advice) const { throw QuantityError(whole_, advice); }

    bool take(std::string_view token) {
        if (!rest_.starts_with(token))
            return false;
        rest_.remove_prefix(token.size());
        return true;
    }

    bool skip_spaces() {
        bool any = false;
        while (take(" ") || take("\t"))
            any = true;
        return any;
    }

    Unit product() {
        skip_spaces();
        Unit result = rest_.starts_with("/") ? Unit{} : factor(); // "100/s" is "100 1/s"
        bool divided = false;
        while (true) {
            const bool space = skip_spaces();
            if (take("/")) {
                skip_spaces();
                const Unit next = factor();
                result = {result.factor / next.factor, result.dimension / next.dimension};
                divided = true;
                continue;
            }
            const bool sign = take("*") || take(middle_dot);
            if (!sign && (!space || rest_.empty() || rest_.front() == ')'))
                return result;
            if (divided)
                fail("expected parentheses around a product after \"/\"; try \"kg/(m s)\" or \"1/s\" last");
            skip_spaces();
            const Unit next = factor();
            result = {result.factor * next.factor, result.dimension * next.dimension};
        }
    }

    Unit factor() {
        if (take("(")) {
            if (++depth_ > 8)
                fail("expected fewer parentheses");
            const Unit inner = product();
            if (!take(")"))
                fail("expected a closing parenthesis");
            --depth_;
            return power(inner, exponent());
        }
        if (take("1")) {
            if (!rest_.empty() &&
                std::string_view("0123456789.eE").find(rest_.front()) != std::string_view::npos)
                fail("expected one number only, at the start");
            return Unit{};
        }
        const std::string_view symbol = word();
        if (symbol.empty()) {
            if (rest_.empty())
                fail(fmt::format("expected a unit; known are {}", detail::known_units()));
            fail(fmt::format("expected a unit at \"{}\"; known are {}", rest_, detail::known_units()));
        }
        const auto unit = detail::find_unit(symbol);
        if (!unit) {
            const std::string meant = detail::meant_unit(symbol);
            fail(fmt::format("expected a known unit instead of {}: {}{}{}", symbol, detail::known_units(),
                             meant.empty() ? "" : "; try ", meant));
        }
        return power(*unit, exponent());
    }

    std::string_view word() {
        std::size_t end = 0;
        while (end < rest_.size()) {
            const char c = rest_[end];
            if ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z')) {
                ++end;
            } else if (rest_.substr(end).starts_with("\u00B5") || rest_.substr(end).starts_with("\u03BC")) {
                end += 2;
            } else {
                break;
            }
        }
        const std::string_view result = rest_.substr(0, end);
        rest_.remove_prefix(end);
        return result;
    }

    int exponent() {
        const bool caret = take("^") || take("**");
        if (caret) {
            const bool parenthesis = take("(");
            const int result = digits();
            if (parenthesis && !take(")"))
                fail("expected a closing parenthesis");
            return result;
        }
        const int sign = take(superscript_minus) ? -1 : 1;
        for (int digit = 0; digit < 10; ++digit) {
            if (take(superscripts[static_cast<std::size_t>(digit)]))
                return sign * digit;
        }
        if (sign < 0)
            fail("expected a digit after the minus");
        return 1;
    }

    int digits() {
        int result = 0;
        const bool plus = take("+");
        const auto [end, code] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), result);
        if (code != std::errc{} || (plus && result < 0))
            fail("expected a whole number after \"^\"; try \"m^3\"");
        if (std::abs(result) > largest_exponent)
            fail("expected a smaller exponent");
        rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
        return result;
    }

    std::string_view whole_;
    std::string_view rest_;
    int depth_ = 0;
};

std::string_view trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos)
        return {};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

} // namespace

Quantity parse_quantity(std::string_view text) {
    constexpr std::string_view wanted = "expected a number and its unit; try \"3.9 um\"";
    std::string_view rest = trimmed(text);
    if (rest.size() > longest_text)
        throw QuantityError(fmt::format("{}...", text.substr(0, 20)), std::string(wanted));
    if (rest.starts_with("+") && !rest.starts_with("+-"))
        rest.remove_prefix(1);

    double number = 0.0;
    const auto [end, code] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
    if (code == std::errc::result_out_of_range)
        throw QuantityError(text, "expected a number that a double can hold");
    if (code != std::errc{} || !std::isfinite(number))
        throw QuantityError(text, std::string(wanted));
    rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
    if (rest.starts_with(","))
        throw QuantityError(text, "expected a decimal point, not a comma; try \"3.9 um\"");
    if (trimmed(rest).empty())
        throw QuantityError(text, std::string(wanted));

    const Unit unit = UnitParser(text, rest).parse();
    const double value = number * unit.factor;
    if (!std::isfinite(value) || !std::isfinite(unit.factor) || (value == 0.0 && number != 0.0))
        throw QuantityError(text, "expected a number that a double can hold");
    return {value, unit.dimension};
}

} // namespace vesica
