#include "case_file_samples.hpp"

#include <catch2/catch.hpp>

using namespace vesica;

namespace {

void check_round_trip(const Case& sample) {
    const std::string text = resolved_toml(sample);
    INFO(text);
    const Case again = read_case_text(text, "resolved.toml");
    CHECK(again.title == sample.title);
    CHECK(again.parameters == sample.parameters);
    CHECK(again.run == sample.run);
    CHECK(again.output == sample.output);
    CHECK(again.scales == sample.scales);
    CHECK(resolved_toml(again).size() <= text.size()); // nothing is a default any more
}

} // namespace

TEST_CASE("reading the resolved case gives the same case, bit for bit") {
    for (const CaseTemplate& item : case_templates()) {
        INFO(item.name);
        check_round_trip(read_case_text(std::string(item.text), "case.toml"));
    }
    for (const std::vector<std::string>& overrides : std::vector<std::vector<std::string>>{
             {"fluid.collision.ghost_rates=trt", "fluid.collision.magic=0.25"},
             {"fluid.collision.ghost_rates={ even = 1.1, odd = 1.3 }"},
             {"fluid.collision.basis=paper",
              "fluid.collision.ghost_rates={ l10 = 1.1, l11 = 1.2, l14 = 1.3, l17 = 0.1 }"},
             {"fluid.collision.model=bgk"},
             {"vesicle_type.rbc.bending.form=paper", "vesicle_type.rbc.bending.laplacian_coefficient=0.5"},
             {"vesicle_type.rbc.area.constraint=none"},
             {"vesicle_type.rbc.area.constraint=penalty", "vesicle_type.rbc.area.modulus=0.013"},
             {"vesicle_type.rbc.area.constraint=paper", "vesicle_type.rbc.area.alpha=1.3e-9"},
             {"vesicle[0].shape=spheroid", "vesicle[0].aspect=0.3"},
             {"vesicle[0].shape=stomatocyte", "vesicle[0].reduced_volume=0.6"},
             {"vesicle[0].shape=evans-fung"},
             {"vesicle[0].perturbation=[{ l = [2, 9], amplitude = 0.1, seed = 9007199254740993 }]"},
             {"title=\"quotes \\\" and \\\\ and \\n and µ\""},
             {"flow.shear={ rate = -1e-4, velocity = \"z\", gradient = \"y\", start = 100, stop = 9000, ramp "
              "= 7 }",
              "boundary.wetting=0.001"},
             {"boundary.y={ lower = { type = \"wall\", velocity = [0.01, 0, 0] }, upper = { type = \"wall\" "
              "} }",
              "flow.poiseuille={ mean_velocity = 0.0123, velocity = \"z\", ramp = 50 }",
              "flow.body_force={ force = [1e-7, 0, 2e-7] }", "vesicle_type.rbc.buoyancy=[0, 1e-6, 0]",
              "vesicle[0].buoyancy=[0, 2e-6, 0]"},
             {"boundary.x={ lower = { type = \"outlet\", pressure = 0.001 }, upper = { type = \"inlet\", "
              "velocity = [-0.01, "
              "0, 0], profile = \"parabolic\", ramp = 30 } }",
              "boundary.z={ lower = { type = \"wall\" }, upper = { type = \"wall\" } }"},
             {"tracers={ every = 50, start = 100, release = 200, membrane = 8, seeds = [{ from = [1, 2, 3] "
              "}, { from = "
              "[4, 5, 6], to = [7, 8, 9], count = 5 }] }"},
             {"flow.extension={ rate = 1e-4, stretch = \"y\", squeeze = \"x\", stop = 1000 }"},
             {"flow.shear={ rate = 1e-4, velocity = \"y\", gradient = \"x\", with = \"lees-edwards\" }"},
             {"numerics.geometry=paper", "numerics.precision=single", "numerics.cutoff=0.1"},
             {"output.fields.every=0", "output.surfaces.every=0", "output.checkpoint.every=0"},
         }) {
        check_round_trip(read_case_text(discocyte_text(), "case.toml", overrides));
    }
}

TEST_CASE("the resolved case shows SI beside lattice values and marks defaults") {
    const std::string text =
        resolved_toml(read_case_text(std::string(case_templates()[4].text), "case.toml"));
    const std::vector<std::string> lines{
        R"(cell = "1.8e-07 m")",
        R"(radius = 15.675555555556                 # 2.8216 um)",
        R"(bending.modulus = 0.087086419753086      # 2e-19 J)",
        R"(kinematic_viscosity = 0.16666666666666666 # 2.95341e-10 m^2/s, 1.2 mPa s)",
        R"(tension.sigma = 0.0                      # 0 N/m, default)",
        R"(geometry = "mapped"                      # default)",
        R"(centre = [28.0, 28.0, 20.0]              # [5.04 um, 5.04 um, 3.6 um])",
        R"(# inertia is scaled: Re = 0.2 instead of 4.92235e-05, fluid.density 4.0631e+06 kg/m^3 instead of 1000 kg/m^3)"};
    for (const std::string& line : lines)
        CHECK(text.find(line + "\n") != std::string::npos);
}
