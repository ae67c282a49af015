#include "core/input_error.hpp"
#include "io/case_file.hpp"
#include "simulation/plan.hpp"
#include "simulation/plan_text.hpp"
#include "simulation/suspension.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>

using namespace vesica;

namespace {

/// A box of 72 x 64 x 56 cells with a suspension of `rest`.
std::string text_of(const std::string& rest, const std::string& others = {}) {
    return "[lattice]\nsize = [72, 64, 56]\n[fluid]\nkinematic_viscosity = 0.3333333\n"
           "[vesicle_type.cell.bending]\nmodulus = 0.1\n[run]\nsteps = 10\n" +
           others + "[suspension]\ntype = \"cell\"\n" + rest + "\n";
}

Case packed(const std::string& rest, const std::string& others = {}) {
    Case what = read_case_text(text_of(rest, others), "case.toml");
    pack_suspension(what);
    return what;
}

std::string refusal(const std::string& rest, const std::string& others = {}) {
    try {
        packed(rest, others);
        return "accepted";
    } catch (const InputError& error) {
        return error.what();
    }
}

const std::string spheroids = "shape = \"spheroid\"\naspect = 0.85\nradius = 8\n";

} // namespace

TEST_CASE("a suspension becomes as many vesicles as its haematocrit asks for, which plan finds apart") {
    Case what = packed(spheroids + "haematocrit = 0.1");
    const double each = 4.0 / 3.0 * std::numbers::pi * 512.0;
    const auto expected = static_cast<std::size_t>(std::lround(0.1 * 72 * 64 * 56 / each));
    REQUIRE(what.parameters.vesicles.size() == expected);
    CHECK(what.packed == expected);
    const Plan plan = make_plan(what);
    CHECK(texts_of(plan.remarks, Remark::Severity::error).empty());
    CHECK(texts_of(plan.remarks, Remark::Severity::warning).empty());
    CHECK(plan_text(what, plan, std::nullopt, 1).find(fmt::format("{} vesicles\n", expected)) !=
          std::string::npos);
    pack_suspension(what); // once is enough
    CHECK(what.parameters.vesicles.size() == expected);
}

TEST_CASE("what was packed is written out as vesicles, which read back are the same") {
    const Case what =
        packed(spheroids + "count = 6\norientation = \"spread\"\naxis = [1, 2, 0]\nspread = 10");
    const Case again = read_case_text(resolved_toml(what), "resolved.toml");
    CHECK_FALSE(again.suspension);
    CHECK(again.parameters == what.parameters);
    const Vec3<double> axis = (1.0 / std::sqrt(5.0)) * Vec3<double>{1.0, 2.0, 0.0};
    double squares = 0.0;
    for (const VesicleParameters& vesicle : what.parameters.vesicles)
        squares += std::pow(std::acos(dot(vesicle.axis, axis)) * 180.0 / std::numbers::pi, 2) / 6.0;
    CHECK(std::sqrt(squares) > 4.0);
    CHECK(std::sqrt(squares) < 20.0);
}

TEST_CASE("the same seed packs the same, and vesicles that are there already stay") {
    const std::string other = "[[vesicle]]\ntype = \"cell\"\nshape = \"sphere\"\nradius = 12\n"
                              "centre = [36, 32, 28]\n";
    const std::string aligned = spheroids + "count = 5\norientation = \"aligned\"\naxis = [0, 1, 0]\n";
    const Case one = packed(aligned + "seed = 3", other);
    const Case two = packed(aligned + "seed = 3", other);
    CHECK(one.parameters == two.parameters);
    CHECK(packed(aligned + "seed = 4", other).parameters != one.parameters);
    REQUIRE(one.parameters.vesicles.size() == 6);
    CHECK(one.parameters.vesicles.front().centre == Vec3<double>{36.0, 32.0, 28.0});
    for (std::size_t k = 1; k < 6; ++k)
        CHECK(one.parameters.vesicles[k].axis == Vec3<double>{0.0, 1.0, 0.0});
    CHECK(texts_of(make_plan(one).remarks, Remark::Severity::warning).empty());
}

TEST_CASE("packed vesicles keep from walls and within their region") {
    const Case what = packed(spheroids + "count = 4\nregion = [[8, 0, 0], [40, 64, 56]]\ngap = 3",
                             "[boundary.z]\nlower = { type = \"wall\" }\nupper = { type = \"wall\" }\n");
    const Plan plan = make_plan(what);
    CHECK(texts_of(plan.remarks, Remark::Severity::error).empty());
    CHECK(texts_of(plan.remarks, Remark::Severity::warning).empty());
    REQUIRE(texts_of(plan.remarks, Remark::Severity::note).size() >= 1);
    // At least 5 cells to either side.
    for (const VesicleParameters& vesicle : what.parameters.vesicles) {
        CHECK(vesicle.centre.x > 8.0 + 3.0 + 5.0);
        CHECK(vesicle.centre.x < 40.0 - 3.0 - 5.0);
        CHECK(vesicle.centre.z > 3.0 + 5.0);
        CHECK(vesicle.centre.z < 56.0 - 3.0 - 5.0);
    }
}

TEST_CASE("suspensions that cannot be are refused, and say what could") {
    CHECK(refusal(spheroids + "haematocrit = 0.001") ==
          "case.toml:14:15: suspension.haematocrit is 0.001: less than one vesicle of this radius in the "
          "258048 "
          "cells of fluid; expected at least 0.00831; try that, or count = 1");
    CHECK(refusal(spheroids + "count = 100") ==
          "case.toml:14:9: suspension.count is 100: 100 vesicles, 83 % of the fluid; expected at most 4000 "
          "and "
          "74 %, which no packing of spheres exceeds; try a haematocrit of 0.3");
    const std::string full = refusal(spheroids + "haematocrit = 0.6");
    CHECK(full.find(
              "case.toml:14:15: suspension.haematocrit is 0.6: 72 vesicles with gaps of 4.99 cells do not "
              "fit, at random; expected no more than about 0.") == 0);
    CHECK(refusal("shape = \"prolate\"\nreduced_volume = 0.1\nradius = 10\ncount = 1")
              .find("case.toml:12:18: suspension.reduced_volume is 0.1; expected ") == 0);
    CHECK(refusal(spheroids + "count = 3\nhaematocrit = 0.1").find("stated once") != std::string::npos);
    CHECK(refusal("shape = \"sphere\"\nradius = 2\ncount = 1")
              .find("case.toml:12:10: suspension.radius is 2; ") == 0);
    CHECK(refusal("shape = \"sphere\"\nradius = 10\ncount = 1\naxis = [1, 0, 0]").find("suspension.axis") !=
          std::string::npos);
    CHECK(refusal("shape = \"sphere\"\nradius = 10\ncount = 1", "[initial]\ncheckpoint = \"out/rest\"\n")
              .find("[initial]") != std::string::npos);
}
