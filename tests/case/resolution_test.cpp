#include "case/resolution.hpp"

#include <catch2/catch.hpp>

#include <limits>

using namespace vesica;

TEST_CASE("resolution is judged by beta times the smallest radius of curvature") {
    CHECK(judge_resolution(0.5, 10.0) == Resolution::fine);
    CHECK(judge_resolution(0.5, 9.99) == Resolution::note);
    CHECK(judge_resolution(0.5, 7.0) == Resolution::note);
    CHECK(judge_resolution(0.5, 6.99) == Resolution::warning);
    CHECK(judge_resolution(0.5, 4.0) == Resolution::warning);
    CHECK(judge_resolution(0.5, 3.99) == Resolution::error);
    CHECK(judge_resolution(0.5, 0.0) == Resolution::error);
    CHECK(judge_resolution(0.5, std::numeric_limits<double>::quiet_NaN()) == Resolution::error);
    CHECK(judge_resolution(0.5, std::numeric_limits<double>::infinity()) == Resolution::fine);
}

TEST_CASE("advice on the resolution names the number, the limit and the remedy") {
    CHECK(resolution_advice(0.5, 10.0).empty());
    CHECK(resolution_advice(0.5, 8.0) ==
          "segregation times the smallest radius of curvature is 4; expected at least 5; "
          "try a radius 1.2 times as large for 5");
    CHECK(resolution_advice(0.5, 5.0) ==
          "segregation times the smallest radius of curvature is 2.5; expected at least "
          "3.5; try a radius 2 times as large for 5");
    CHECK(resolution_advice(0.5, 2.0) ==
          "segregation times the smallest radius of curvature is 1; expected at least 2; "
          "try a radius 5 times as large for 5");
    CHECK(resolution_advice(0.5, 0.0) ==
          "segregation times the smallest radius of curvature is 0; expected at least 2");
}
