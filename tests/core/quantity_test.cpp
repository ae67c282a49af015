#include "core/quantity.hpp"

#include <catch2/catch.hpp>

#include <string>
#include <vector>

using namespace vesica;

namespace {

std::string refusal(const std::string& text) {
    try {
        const Quantity quantity = parse_quantity(text);
        return "accepted as " + to_text(quantity);
    } catch (const QuantityError& error) {
        return error.what();
    }
}

} // namespace

TEST_CASE("a quantity is worth its number times its unit in SI") {
    struct Row {
        std::string text;
        double value;
        Dimension dimension;
    };
    const std::vector<Row> rows{
        {"3.9 um", 3.9e-6, dimension::length},
        {"3.9um", 3.9e-6, dimension::length},
        {"  -3.9 um ", -3.9e-6, dimension::length},
        {"+2 m", 2.0, dimension::length},
        {"0.25 \u00B5m", 0.25e-6, dimension::length},
        {"0.25 \u03BCm", 0.25e-6, dimension::length},
        {"2e-19 J", 2e-19, dimension::energy},
        {"100 1/s", 100.0, dimension::rate},
        {"100/s", 100.0, dimension::rate},
        {"100 s^-1", 100.0, dimension::rate},
        {"100 s\u207B\u00B9", 100.0, dimension::rate},
        {"1 kHz", 1000.0, dimension::rate},
        {"1.2 mPa s", 1.2e-3, dimension::dynamic_viscosity},
        {"1.2 mPa*s", 1.2e-3, dimension::dynamic_viscosity},
        {"1.2 mPa\u00B7s", 1.2e-3, dimension::dynamic_viscosity},
        {"1.2 cP", 1.2e-3, dimension::dynamic_viscosity},
        {"1.2 g/(m s)", 1.2e-3, dimension::dynamic_viscosity},
        {"5 N/m", 5.0, dimension::tension},
        {"5 dyn/cm", 5e-3, dimension::tension},
        {"1000 kg/m^3", 1000.0, dimension::density},
        {"1 g/cm\u00B3", 1000.0, dimension::density},
        {"1e-6 m^2/s", 1e-6, dimension::kinematic_viscosity},
        {"1 m/s/s", 1.0, dimension::acceleration},
        {"2 h", 7200.0, dimension::time},
        {"3 min", 180.0, dimension::time},
        {"5 ms", 5e-3, dimension::time},
        {"3 m/s", 3.0, dimension::velocity},
        {"7 Pa", 7.0, dimension::pressure},
        {"94 fL", 94e-18, dimension::volume},
        {"94 um^3", 94e-18, dimension::volume},
        {"1 erg", 1e-7, dimension::energy},
        {"6 pN", 6e-12, dimension::force},
    };
    for (const Row& row : rows) {
        INFO(row.text);
        const Quantity quantity = parse_quantity(row.text);
        CHECK(quantity.dimension == row.dimension);
        CHECK(quantity.value == Approx(row.value).epsilon(1e-14));
    }
    CHECK(parse_quantity("1 kg") == Quantity{1.0, dimension::mass});
}

TEST_CASE("text that is no quantity is refused with what was read and what was expected") {
    const std::string wanted = " is no quantity; expected a number and its unit; try \"3.9 um\"";
    const std::string units = "m, s, kg, g, N, Pa, J, Hz, L, P, dyn, erg with a prefix, min and h";
    const std::vector<std::pair<std::string, std::string>> rows{
        {"", "\"\"" + wanted},
        {"um", "\"um\"" + wanted},
        {"3.9", "\"3.9\"" + wanted},
        {"nan m", "\"nan m\"" + wanted},
        {"inf m", "\"inf m\"" + wanted},
        {"+-3 m", "\"+-3 m\"" + wanted},
        {"3,9 um", "\"3,9 um\" is no quantity; expected a decimal point, not a comma; try \"3.9 um\""},
        {"1e999 m", "\"1e999 m\" is no quantity; expected a number that a double can hold"},
        {"3 furlong", "\"3 furlong\" is no quantity; expected a known unit instead of furlong: " + units},
        {"3 sec", "\"3 sec\" is no quantity; expected a known unit instead of sec: " + units + "; try s"},
        {"3 UM", "\"3 UM\" is no quantity; expected a known unit instead of UM: " + units + "; try um"},
        {"3 m$", "\"3 m$\" is no quantity; expected the unit to end before \"$\""},
        {"3 m^x", "\"3 m^x\" is no quantity; expected a whole number after \"^\"; try \"m^3\""},
        {"3 m^99", "\"3 m^99\" is no quantity; expected a smaller exponent"},
        {"3 kg/m s", "\"3 kg/m s\" is no quantity; expected parentheses around a product after \"/\"; "
                     "try \"kg/(m s)\" or \"1/s\" last"},
        {"3 kg/(m s", "\"3 kg/(m s\" is no quantity; expected a closing parenthesis"},
        {"3 kg/", "\"3 kg/\" is no quantity; expected a unit; known are " + units},
        {"3 4 m", "\"3 4 m\" is no quantity; expected a unit at \"4 m\"; known are " + units},
        {"3 12 m", "\"3 12 m\" is no quantity; expected one number only, at the start"},
        {"3 kmin", "\"3 kmin\" is no quantity; expected a known unit instead of kmin: " + units},
    };
    for (const auto& [text, message] : rows)
        CHECK(refusal(text) == message);
}

TEST_CASE("text of any length and nesting is refused without harm") {
    CHECK(refusal("1 " + std::string(100000, '(')).find("is no quantity") != std::string::npos);
    CHECK(refusal("1 ((((((((((m))))))))))").find("expected fewer parentheses") != std::string::npos);
    CHECK(refusal("1 am^9 am^9 am^9 am^9").find("a double can hold") != std::string::npos);
}

TEST_CASE("every dimension's example is a quantity of that dimension, and so is its SI unit") {
    for (const Dimension& entry :
         {dimension::length, dimension::area, dimension::volume, dimension::curvature, dimension::time,
          dimension::rate, dimension::velocity, dimension::acceleration, dimension::kinematic_viscosity,
          dimension::mass, dimension::density, dimension::dynamic_viscosity, dimension::pressure,
          dimension::tension, dimension::force, dimension::energy, dimension::force_density,
          dimension::tension_per_area_squared, Dimension{5, -3, 2}}) {
        INFO(dimension_name(entry));
        CHECK(parse_quantity(example_quantity(entry)).dimension == entry);
        CHECK(parse_quantity("1 " + si_unit(entry)) == Quantity{1.0, entry});
    }
}

TEST_CASE("a quantity's text reads back to six digits") {
    CHECK(to_text({3.9e-6, dimension::length}) == "3.9 um");
    CHECK(to_text({1.2e-3, dimension::dynamic_viscosity}) == "1.2 mPa s");
    CHECK(to_text({2e-19, dimension::energy}) == "2e-19 J");
    CHECK(to_text({1e-3, dimension::time}) == "1 ms");
    CHECK(to_text({0.5, dimension::none}) == "0.5");
    CHECK(to_text({0.0, dimension::length}) == "0 m");
    for (double value = 1.2345678e-14; value < 1e6; value *= 7.7) {
        for (const Dimension& entry :
             {dimension::length, dimension::density, dimension::energy, dimension::time}) {
            const Quantity back = parse_quantity(to_text({value, entry}));
            CHECK(back.dimension == entry);
            CHECK(back.value == Approx(value).epsilon(5e-6));
        }
    }
}
