#include "case_file_samples.hpp"

#include <catch2/catch.hpp>

using namespace vesica;

namespace {

Case with(const std::vector<std::string>& overrides) {
    return read_case_text(discocyte_text(), "case.toml", overrides);
}

} // namespace

TEST_CASE("an override replaces what the file says") {
    CHECK(with({"fluid.kinematic_viscosity=0.2"}).parameters.fluid.kinematic_viscosity == 0.2);
    CHECK(with({"vesicle[0].radius=12"}).parameters.vesicles[0].radius == 12.0);
    CHECK(with({"vesicle_type.rbc.bending.modulus=0.1"}).parameters.types[0].bending.modulus == 0.1);
    CHECK(with({" vesicle[0].centre[2] = 30 "}).parameters.vesicles[0].centre == Vec3<double>{32, 32, 30});
    CHECK(with({"vesicle[0].perturbation[0].amplitude=0.02"}).parameters.vesicles[0].perturbations ==
          std::vector<Perturbation>{HarmonicPerturbation{2, 0, 0.02}});
    CHECK(with({"run.steps=1", "run.steps=2"}).run.steps == 2);
    CHECK(with({"lattice.size=[70, 71, 72]"}).parameters.size == Vec3<int>{70, 71, 72});
}

TEST_CASE("an override adds what the file does not say") {
    CHECK(with({"vesicle[0].perturbation[1].l=3", "vesicle[0].perturbation[1].amplitude=0.01"})
              .parameters.vesicles[0]
              .perturbations ==
          std::vector<Perturbation>{HarmonicPerturbation{2, 0, -0.01}, HarmonicPerturbation{3, 0, 0.01}});
    CHECK(with({"output.fields.stride=2"}).output.fields->stride == 2);
    CHECK(with({"vesicle_type.drop.bending.modulus=0"}).parameters.types.size() == 2);
}

TEST_CASE("bare words and quantities without quotes are text") {
    CHECK(with({"numerics.precision=single"}).parameters.numerics.precision == Precision::single_precision);
    CHECK(with({"run.wall_time=3 h"}).run.wall_time == 10800.0);
    CHECK(with({"run.wall_time=\"3 h\""}).run.wall_time == 10800.0);
    CHECK(with({"output.fields.names=[phase, mean_curvature]"}).output.fields->names ==
          std::vector<std::string>{"phase", "mean_curvature"});
}

TEST_CASE("overrides are kept with the case, and its text stays verbatim") {
    const Case sample = with({"run.steps=10", "vesicle[0].radius=14"});
    CHECK(sample.overrides == std::vector<std::string>{"run.steps=10", "vesicle[0].radius=14"});
    CHECK(sample.source_text == discocyte_text());
    CHECK(sample.place("run.steps").file == "--set run.steps=10");
    CHECK(sample.place("run.steps").line == 0);
}

TEST_CASE("a wrong override is refused by its own name") {
    const auto refused = [](const std::string& override_) {
        return verdict(discocyte_text(), {override_});
    };
    const auto path = [](const std::string& given) {
        return "the path is " + given + "; expected keys and indices; try vesicle[0].radius=12";
    };
    CHECK(refused("run.steps") ==
          "--set run.steps: there is no \"=\"; expected path=value; try fluid.kinematic_viscosity=0.2");
    CHECK(refused("") == "--set : there is no \"=\"; expected path=value; try fluid.kinematic_viscosity=0.2");
    CHECK(refused("=3") == "--set =3: " + path("empty"));
    CHECK(refused("run..steps=3") == "--set run..steps=3: " + path("\"run..steps\""));
    CHECK(refused("run.=3") == "--set run.=3: " + path("\"run.\""));
    CHECK(refused("[0].radius=3") == "--set [0].radius=3: " + path("\"[0].radius\""));
    CHECK(refused("vesicle[-1].radius=3") == "--set vesicle[-1].radius=3: " + path("\"vesicle[-1].radius\""));
    CHECK(refused("vesicle[0.radius=3") == "--set vesicle[0.radius=3: " + path("\"vesicle[0.radius\""));
    CHECK(refused("vesicle[99999999999999999999].radius=3")
              .starts_with("--set vesicle[99999999999999999999].radius=3: "));
    CHECK(refused("run.steps=") == "--set run.steps=: the value is empty; expected a value after \"=\"; "
                                   "try fluid.density=1.0");
    CHECK(refused("run.steps=1\nrun.time=2") ==
          "--set run.steps=1\nrun.time=2: the value has more than one line; expected one value");
    CHECK(refused("title=\"open") ==
          "--set title=\"open: the value \"open is no TOML; expected a number, a word, "
          "\"text\", [array] or {table}; try quoting it for the shell");
    CHECK(refused("vesicle.radius=3") ==
          "--set vesicle.radius=3: vesicle is an array; expected an index, as in "
          "vesicle[0], to set its key radius");
    CHECK(refused("vesicle[3].radius=3") ==
          "--set vesicle[3].radius=3: vesicle has 1 element; expected an index up to 1");
    CHECK(refused("fluid[0].density=3") ==
          "--set fluid[0].density=3: fluid is a table; expected an array, to set its element 0");
    CHECK(refused("title.text=3") ==
          "--set title.text=3: title is \"A discocyte from a deflated sphere\"; expected a "
          "table, to set its key text");
    CHECK(refused("fluid.densty=1") ==
          "--set fluid.densty=1: fluid.densty is not a known key; expected "
          "kinematic_viscosity, relaxation_time, dynamic_viscosity, density, segregation or "
          "collision; try fluid.density");
    CHECK(refused("fluid.density=abc") ==
          "--set fluid.density=abc: fluid.density is \"abc\"; expected a density as a "
          "number without quotes or as text with a unit; try density = \"1000 kg/m^3\"");
    CHECK(refused("fluid.relaxation_time=0.8") ==
          "--set fluid.relaxation_time=0.8: fluid.relaxation_time is 0.8; expected the viscosity to be "
          "stated once, but "
          "fluid.kinematic_viscosity is 0.1666667; try removing one of them");
    CHECK(refused("vesicle[1].radius=3") ==
          "--set vesicle[1].radius=3: vesicle[1].type is missing; expected text; try type = \"rbc\"");
    CHECK(refused("numerics.device=cuda") ==
          "--set numerics.device=cuda: numerics.device is \"cuda\"; that is not "
          "available yet; expected \"cpu\" or \"auto\"; try device = \"cpu\"");
}
