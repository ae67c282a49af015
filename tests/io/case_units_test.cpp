#include "case_file_samples.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace vesica;

namespace {

/// A red-cell-like vesicle with these lines in [units] and [fluid].
std::string red_cell(const std::string& units, const std::string& fluid) {
    return "[units]\ncell = \"0.2 um\"\n" + units + "\n[fluid]\n" + fluid +
           "\n[lattice]\nsize = [64, 64, 64]\n[vesicle_type.rbc.bending]\nmodulus = \"2e-19 J\"\n"
           "[vesicle_type.rbc.tension]\nsigma = \"1e-9 N/m\"\n[[vesicle]]\ntype = \"rbc\"\nshape = "
           "\"sphere\"\n"
           "centre = [\"6.4 um\", \"6400 nm\", 32]\nradius = \"3 um\"\n[run]\ntime = \"1 ms\"\n";
}

const std::string water = "dynamic_viscosity = \"1.2 mPa s\"\ndensity = \"1000 kg/m^3\"\n";

Case reading(const std::string& text) {
    return read_case_text(text, "case.toml");
}

/// rho kappa/(eta^2 R0) in lattice units.
double lattice_reynolds(const Case& sample) {
    const double eta = sample.parameters.fluid.density * sample.parameters.fluid.kinematic_viscosity;
    return sample.parameters.fluid.density * sample.parameters.types[0].bending.modulus /
           (eta * eta * sample.parameters.vesicles[0].radius);
}

/// eta R0^3/kappa in seconds: the time in which shapes relax, which every closure must leave as it is.
double bending_time(const Case& sample) {
    const double eta = sample.parameters.fluid.density * sample.parameters.fluid.kinematic_viscosity;
    return eta * std::pow(sample.parameters.vesicles[0].radius, 3) /
           sample.parameters.types[0].bending.modulus * sample.scales->step;
}

constexpr double true_reynolds = 1000.0 * 2e-19 / (1.2e-3 * 1.2e-3 * 3e-6);
constexpr double true_bending_time = 1.2e-3 * 27e-18 / 2e-19;

} // namespace

TEST_CASE("with a time step the lattice has the real Reynolds number and the real times") {
    const Case sample = reading(red_cell("time_step = \"5 ns\"", water));
    REQUIRE(sample.scales);
    CHECK(*sample.scales == Scales{0.2 * 1e-6, 5.0 * 1e-9, 1000.0});
    CHECK(sample.parameters.fluid.density == 1.0);
    CHECK(sample.parameters.fluid.kinematic_viscosity == Approx(1.2e-6 * 5e-9 / 4e-14).epsilon(1e-12));
    CHECK(lattice_reynolds(sample) == Approx(true_reynolds).epsilon(1e-12));
    CHECK(bending_time(sample) == Approx(true_bending_time).epsilon(1e-12));
    CHECK(sample.run.steps == 200000);
    CHECK_FALSE(sample.inertia);
}

TEST_CASE("with a density the relaxation time decides the step") {
    for (const double relaxation : {0.8, 1.0, 1.7}) {
        const Case sample = reading(
            red_cell("density = \"1000 kg/m^3\"",
                     "dynamic_viscosity = \"1.2 mPa s\"\nrelaxation_time = " + std::to_string(relaxation)));
        const double nu = (relaxation - 0.5) / 3.0;
        CHECK(sample.parameters.fluid.kinematic_viscosity == Approx(nu).epsilon(1e-15));
        CHECK(sample.scales->step == Approx(nu * 4e-14 / 1.2e-6).epsilon(1e-12));
        CHECK(lattice_reynolds(sample) == Approx(true_reynolds).epsilon(1e-12));
        CHECK(bending_time(sample) == Approx(true_bending_time).epsilon(1e-12));
    }
    const auto step = [](const std::string& fluid) {
        return reading(red_cell("density = \"1000 kg/m^3\"", fluid)).scales->step;
    };
    CHECK(step("kinematic_viscosity = \"1.2e-6 m^2/s\"") ==
          Approx(step("dynamic_viscosity = \"1.2 mPa s\"")));
}

TEST_CASE("with a Reynolds number the inertia is scaled and the times stay real") {
    const Case sample = reading(red_cell("reynolds = 0.05", water));
    CHECK(lattice_reynolds(sample) == Approx(0.05).epsilon(1e-12));
    CHECK(bending_time(sample) == Approx(true_bending_time).epsilon(1e-12));
    CHECK(sample.parameters.fluid.kinematic_viscosity == Approx(1.0 / 6.0).epsilon(1e-15));
    REQUIRE(sample.inertia);
    CHECK(sample.inertia->reynolds == 0.05);
    CHECK(sample.inertia->true_reynolds == Approx(true_reynolds).epsilon(1e-12));
    CHECK(sample.inertia->true_density == 1000.0);
    CHECK(sample.scales->density == Approx(1000.0 * 0.05 / true_reynolds).epsilon(1e-12));
    const double viscosity = sample.scales
                                 ->to_si(sample.parameters.fluid.kinematic_viscosity, // times density 1
                                         dimension::dynamic_viscosity)
                                 .value;
    CHECK(viscosity == Approx(1.2e-3).epsilon(1e-12));

    const Case other =
        reading(red_cell("reynolds = 0.05", "kinematic_viscosity = \"1.2e-6 m^2/s\"\n"
                                            "density = \"1000 kg/m^3\"\nrelaxation_time = 0.8\n"));
    CHECK(lattice_reynolds(other) == Approx(0.05).epsilon(1e-12));
    CHECK(bending_time(other) == Approx(true_bending_time).epsilon(1e-12));
    CHECK(other.parameters.fluid.kinematic_viscosity == Approx(0.1).epsilon(1e-14));
}

TEST_CASE("positions in SI are exact on the lattice, and lattice numbers stay beside them") {
    const Case sample = reading(red_cell("reynolds = 0.05", water));
    CHECK(sample.parameters.vesicles[0].centre == Vec3<double>{32.0, 32.0, 32.0});
    CHECK(sample.parameters.vesicles[0].radius == 15.0);
}

TEST_CASE("times in SI become whole steps") {
    const std::string text =
        red_cell("time_step = \"5 ns\"", water) + "[output]\nmetrics = { every = \"12.6 ns\" }\n";
    CHECK(reading(text).output.metrics_every == 3);
    CHECK(reading(red_cell("time_step = \"5 ns\"", water) + "wall_time = \"2 h\"\n").run.wall_time == 7200.0);
}

TEST_CASE("units that do not close the system are refused with what is missing") {
    const auto refused = [](const std::string& units, const std::string& fluid) {
        return verdict(red_cell(units, fluid));
    };
    CHECK(refused("time_step = \"5 ns\"", "dynamic_viscosity = \"1.2 mPa s\"") ==
          "case.toml:4:1: fluid.density is missing; expected a density with its unit, which fixes the scale "
          "of mass "
          "beside units.time_step; try density = \"1000 kg/m^3\"");
    CHECK(refused("time_step = \"5 ns\"", water + "relaxation_time = 1.0") ==
          "case.toml:7:19: fluid.relaxation_time is 1.0; expected the viscosity to be stated once, but "
          "fluid.dynamic_viscosity is \"1.2 mPa s\"; try removing one of them");
    CHECK(refused("time_step = \"5 ms\"", water) ==
          "case.toml:5:21: fluid.dynamic_viscosity is \"1.2 mPa s\"; expected at most 100 in lattice units, "
          "not 1.5e+05; "
          "try a shorter units.time_step");
    CHECK(refused("density = \"1000 kg/m^3\"", water) ==
          "case.toml:6:11: fluid.density is \"1000 kg/m^3\"; expected the density to be stated once, but "
          "units.density is "
          "\"1000 kg/m^3\"; try removing one of them");
    CHECK(
        refused("density = \"1000 kg/m^3\"", "relaxation_time = 1.0") ==
        "case.toml:4:1: fluid.kinematic_viscosity is missing; expected exactly one of kinematic_viscosity or "
        "dynamic_viscosity, to state the viscosity; try kinematic_viscosity = 0.1666667");
    CHECK(refused("density = \"1000 kg/m^3\"", "kinematic_viscosity = 0.2") ==
          "case.toml:5:23: fluid.kinematic_viscosity is 0.2; expected a viscosity with its unit, from which "
          "units.density "
          "finds the step; try dynamic_viscosity = \"1.2 mPa s\"");
    CHECK(refused("reynolds = 0.05", "dynamic_viscosity = \"1.2 mPa s\"") ==
          "case.toml:4:1: fluid.density is missing; expected a density with its unit, from which "
          "units.reynolds scales "
          "the inertia; try density = \"1000 kg/m^3\"");
    CHECK(refused("reynolds = 0", water) == "case.toml:3:12: units.reynolds is 0; expected a number above 0 "
                                            "and at most 100; try reynolds = 0.05");
    std::string drop = red_cell("reynolds = 0.05", water);
    drop.replace(drop.find("\"2e-19 J\""), 9, "0.0");
    CHECK(verdict(drop) ==
          "case.toml:11:11: vesicle_type.rbc.bending.modulus is 0.0; expected an energy above 0 with its "
          "unit, since units.reynolds takes its velocity from bending; try modulus = \"2e-19 J\", or "
          "[units] with time_step or density");
    std::string small = red_cell("reynolds = 0.05", water);
    small.replace(small.find("\"3 um\""), 6, "\"0.3 um\"");
    CHECK(verdict(small) ==
          "case.toml:18:10: vesicle[0].radius is \"0.3 um\"; expected at least 2.99 cells, as even a "
          "sphere is not resolved otherwise (radius times fluid.segregation below 2); try radius = 15");
    std::string soon = red_cell("reynolds = 0.05", water);
    soon.replace(soon.find("\"1 ms\""), 6, "\"1 ns\"");
    CHECK(verdict(soon) ==
          "case.toml:20:8: run.time is \"1 ns\" (0.000167 steps); expected at least one step of 6 us; try "
          "a longer time or another [units]");
    std::string stiff = red_cell("time_step = \"5 ns\"", water);
    stiff.replace(stiff.find("\"2e-19 J\""), 9, "\"2e-10 J\"");
    CHECK(verdict(stiff) ==
          "case.toml:11:11: vesicle_type.rbc.bending.modulus is \"2e-10 J\" (15625 in lattice units); "
          "expected an energy at least 0 and at most 1000 in lattice units; try other [units]");
}
