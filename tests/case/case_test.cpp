#include "case/case.hpp"

#include <catch2/catch.hpp>

using namespace vesica;

TEST_CASE("the place of a key is its own, or that of the nearest table around it, or the file") {
    Case sample;
    sample.source_file = "case.toml";
    sample.places["vesicle[0]"] = {"case.toml", 28, 1};
    sample.places["vesicle[0].radius"] = {"--set vesicle[0].radius=3", 0, 0};
    CHECK(sample.place("vesicle[0].radius").file == "--set vesicle[0].radius=3");
    CHECK(sample.place("vesicle[0].axis").line == 28);
    sample.places["vesicle[0].centre"] = {"case.toml", 31, 10};
    CHECK(sample.place("vesicle[0].centre[2]").line == 31);
    CHECK(sample.place("vesicle[0].perturbation[2].l").line == 28);
    CHECK(sample.place("vesicle[1].radius").file == "case.toml");
    CHECK(sample.place("vesicle[1].radius").line == 0);
}
